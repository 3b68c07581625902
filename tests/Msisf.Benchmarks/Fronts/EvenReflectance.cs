using Msisf.Core.Render.Photometry;

namespace Msisf.Benchmarks.Fronts;

/// <summary>A law that makes all that is lit equally bright: an image by it shows which part of each pixel's samples is lit.</summary>
internal sealed class EvenReflectance : IReflectance
{
    /// <inheritdoc/>
    public bool DependsOnViewer => false;

    /// <inheritdoc/>
    public double RadianceFactor(double cosIncidence, double cosEmission, double phaseHaversine) => 1.0;
}
