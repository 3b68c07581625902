using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Tracing;

namespace Msisf.Core.Render;

/// <summary>A finished frame. Reading it is safe for several threads. It must not be used after it is disposed.</summary>
public sealed class NativeFrame : IGroundTruth, IDisposable
{
    private readonly Action<FramePass> _giveBack;
    private FramePass? _pass;

    internal NativeFrame(FramePass pass, Action<FramePass> giveBack)
    {
        _pass = pass;
        _giveBack = giveBack;
    }

    /// <inheritdoc/>
    public PinholeCamera Camera => Pass.Camera;

    /// <inheritdoc/>
    public Vector3D LightPositionMoonMe => Pass.Light.PositionMoonMe;

    /// <inheritdoc/>
    public bool LightIsSun => Pass.Light.IsSun;

    /// <inheritdoc/>
    public ReadOnlySpan<double> RadianceFactors => Pass.RadianceFactors;

    /// <summary>The same numbers as <see cref="RadianceFactors"/>.</summary>
    internal ReadOnlyMemory<double> RadianceFactorMemory => Pass.RadianceFactorMemory;

    private FramePass Pass => _pass ?? throw new ObjectDisposedException(nameof(NativeFrame));

    /// <inheritdoc/>
    /// <exception cref="InvalidOperationException">
    /// The frame was drawn without <see cref="NativeRenderOptions.KeepGroundTruth"/>.
    /// </exception>
    public bool TryGet(int x, int y, out SurfaceHit hit, out PixelIllumination light) => Pass.TryGet(x, y, out hit, out light);

    /// <inheritdoc/>
    void IGroundTruth.ReadRow(int y, TruthRow row) => Pass.ReadRow(y, row);

    /// <summary>Gets the surface point at a pixel's centre, with its facet's normal.</summary>
    /// <inheritdoc cref="TryGet"/>
    internal bool TryGetSurface(int x, int y, out SurfaceHit hit) => Pass.TryGetSurface(x, y, out hit);

    /// <summary>Returns the frame's memory to the renderer for later frames.</summary>
    public void Dispose()
    {
        if (Interlocked.Exchange(ref _pass, null) is FramePass pass)
        {
            _giveBack(pass);
        }
    }
}
