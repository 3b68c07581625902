using Msisf.Core.Camera;
using Msisf.Core.Render;
using Msisf.Core.Scene;
using Msisf.Core.Tracing;

namespace Msisf.Core.Navigation;

/// <summary>Ground truth of a frame that also knows which crater or object each pixel shows.</summary>
/// <param name="frame">The frame; must live longer than this.</param>
/// <param name="craterNumbers">The result of <see cref="CraterPixels.NumbersOf"/>; empty for none.</param>
/// <param name="objectNumbers">The number of the object that each pixel shows, by rows; empty for none.</param>
public sealed class MarkedFrame(IGroundTruth frame, int[] craterNumbers, int[] objectNumbers) : IGroundTruth
{
    /// <inheritdoc/>
    public ICamera Camera => frame.Camera;

    /// <inheritdoc/>
    public SceneLight Light => frame.Light;

    /// <inheritdoc/>
    public ReadOnlySpan<double> RadianceFactors => frame.RadianceFactors;

    /// <inheritdoc/>
    public ReadOnlySpan<double> IndirectFactors => frame.IndirectFactors;

    /// <inheritdoc/>
    public ReadOnlySpan<double> Electrons => frame.Electrons;

    /// <inheritdoc/>
    public ReadOnlySpan<byte> Saturated => frame.Saturated;

    /// <inheritdoc/>
    public ReadOnlySpan<int> CraterNumbers => craterNumbers;

    /// <inheritdoc/>
    public ReadOnlySpan<int> ObjectNumbers => objectNumbers;

    /// <inheritdoc/>
    public bool TryGet(int x, int y, out SurfaceHit hit, out PixelIllumination light) => frame.TryGet(x, y, out hit, out light);

    /// <inheritdoc/>
    void IGroundTruth.ReadRow(int y, TruthRow row) => frame.ReadRow(y, row);
}
