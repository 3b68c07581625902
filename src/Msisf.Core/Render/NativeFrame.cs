using Msisf.Core.Camera;
using Msisf.Core.Render.Options;
using Msisf.Core.Scene;
using Msisf.Core.Tracing;

namespace Msisf.Core.Render;

/// <summary>A finished frame. Reading it is safe for several threads. It must not be used after it is disposed.</summary>
public sealed class NativeFrame : IGroundTruth, IDisposable
{
    private readonly Action _giveBack;
    private IDrawnFrame? _drawn;

    internal NativeFrame(IDrawnFrame drawn, Action giveBack)
    {
        _drawn = drawn;
        _giveBack = giveBack;
    }

    /// <inheritdoc/>
    public ICamera Camera => Drawn.Camera;

    /// <inheritdoc/>
    public SceneLight Light => Drawn.Light;

    /// <inheritdoc/>
    public ReadOnlySpan<double> RadianceFactors => Drawn.RadianceFactors.Span;

    /// <inheritdoc/>
    public ReadOnlySpan<double> IndirectFactors => Drawn.IndirectFactors.Span;

    /// <summary>The same numbers as <see cref="RadianceFactors"/>.</summary>
    internal ReadOnlyMemory<double> RadianceFactorMemory => Drawn.RadianceFactors;

    /// <summary>Adds the light of another lamp, by which the same camera was drawn.</summary>
    /// <param name="factor">That lamp's light over this one's.</param>
    internal void AddLight(NativeFrame other, double factor)
    {
        Span<double> sum = Drawn.RadianceFactors.Span;
        ReadOnlySpan<double> more = other.RadianceFactors;
        for (int i = 0; i < sum.Length; i++)
        {
            sum[i] += factor * more[i];
        }
    }

    private IDrawnFrame Drawn => _drawn ?? throw new ObjectDisposedException(nameof(NativeFrame));

    /// <inheritdoc/>
    /// <exception cref="InvalidOperationException">
    /// The frame was drawn without <see cref="NativeRenderOptions.KeepGroundTruth"/>.
    /// </exception>
    public bool TryGet(int x, int y, out SurfaceHit hit, out PixelIllumination light) => Drawn.TryGet(x, y, out hit, out light);

    /// <inheritdoc/>
    void IGroundTruth.ReadRow(int y, TruthRow row) => Drawn.ReadRow(y, row);

    /// <summary>Gets the surface point at a pixel's centre, with its facet's normal.</summary>
    /// <inheritdoc cref="TryGet"/>
    internal bool TryGetSurface(int x, int y, out SurfaceHit hit) => Drawn.TryGetSurface(x, y, out hit);

    /// <summary>Returns the frame's memory to the renderer for later frames.</summary>
    public void Dispose()
    {
        if (Interlocked.Exchange(ref _drawn, null) is not null)
        {
            _giveBack();
        }
    }
}
