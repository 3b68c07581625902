using Msisf.Core.Errors;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>
/// An LDEM model of the surroundings of a pole, mapped into memory: only the samples that are asked for are read. The radius of a sample is
/// OFFSET + SCALING_FACTOR * value in doubles, in m.
/// </summary>
/// <remarks>Don't use it after or while it is disposed. A file that is made shorter while it is open ends the process.</remarks>
public sealed class LdemMapImage : ITerrainGrid, IDisposable
{
    private readonly LdemPart _part;
    private bool _isDisposed;

    private LdemMapImage(LdemPart part, PolarStereographic projection)
    {
        _part = part;
        Projection = projection;
    }

    /// <inheritdoc/>
    public string ProductId => _part.Label.ProductId;

    /// <inheritdoc/>
    public MapProjection Projection { get; }

    /// <inheritdoc/>
    public int Lines => _part.Label.Lines;

    /// <inheritdoc/>
    public int Samples => _part.Label.LineSamples;

    /// <inheritdoc/>
    public (double Min, double Max) RadiusLimits => _part.Label.RadiusLimits;

    /// <summary>Opens the image of a label.</summary>
    /// <param name="label">The label of a polar map.</param>
    /// <exception cref="BadInputException">The image is missing, unreadable, or not as long as the label says.</exception>
    public static LdemMapImage Open(LdemLabel label)
    {
        ArgumentNullException.ThrowIfNull(label.Polar);
        return new LdemMapImage(LdemPart.Open(label), label.Polar);
    }

    /// <inheritdoc/>
    public void ReadRadii(int line, int firstSample, Span<double> radii)
    {
        CheckBlock(line, 1, firstSample, radii.Length);
        _part.ReadRadii(line, firstSample, radii);
    }

    /// <inheritdoc/>
    public (double Minimum, double Maximum) RadiusBounds(int firstLine, int lines, int firstSample, int samples)
    {
        CheckBlock(firstLine, lines, firstSample, samples);
        return _part.RadiusBounds(firstLine, lines, firstSample, samples);
    }

    /// <inheritdoc/>
    public void ReleasePages() => _part.ReleasePages();

    /// <summary>Unmaps the file.</summary>
    public void Dispose()
    {
        _isDisposed = true;
        _part.Dispose();
    }

    private void CheckBlock(int firstLine, int lines, int firstSample, int samples)
    {
        ObjectDisposedException.ThrowIf(_isDisposed, this);
        if (firstLine < 0 || lines < 1 || lines > Lines - firstLine || firstSample < 0 || samples < 1 || samples > Samples - firstSample)
        {
            throw new ArgumentOutOfRangeException(
                nameof(firstLine),
                $"No block of {Lines} x {Samples} samples: {lines} lines from {firstLine}, {samples} samples from {firstSample}.");
        }
    }
}
