using System.Collections.Concurrent;
using Msisf.Core.Camera;
using Msisf.Core.Scene;
using Msisf.Core.Tracing;

namespace Msisf.Core.Render;

/// <summary>
/// The ground truth of a scanned image that is too large to be kept: strips of rows are drawn when they are asked for, and the last ones
/// kept.
/// Single pixels draw their exposure alone. Safe for several threads.
/// </summary>
/// <param name="camera">The image's camera.</param>
/// <param name="light">The image's light.</param>
/// <param name="rowsOfStrip">Rows of a strip, at least 1.</param>
/// <param name="rowsOfExposure">Rows that are exposed at once, of which a strip has some.</param>
/// <param name="draw">Draws some rows, with ground truth that stays valid.</param>
public sealed class StripedTruth(
    ICamera camera, SceneLight light, int rowsOfStrip, int rowsOfExposure, Func<PixelRows, IGroundTruth> draw) : IGroundTruth
{
    private const int KeptStrips = 8;

    private readonly ConcurrentDictionary<PixelRows, Lazy<IGroundTruth>> _strips = [];
    private readonly ConcurrentQueue<PixelRows> _order = [];

    /// <inheritdoc/>
    public ICamera Camera => camera;

    /// <inheritdoc/>
    public SceneLight Light => light;

    /// <summary>Empty: <see cref="IGroundTruth.RadianceFactorsOf"/> has those of a row.</summary>
    public ReadOnlySpan<double> RadianceFactors => [];

    /// <inheritdoc/>
    public bool TryGet(int x, int y, out SurfaceHit hit, out PixelIllumination light)
    {
        (IGroundTruth truth, int first) = Of(_strips.ContainsKey(StripOf(y - 1)) ? StripOf(y - 1) : ExposureOf(y - 1));
        return truth.TryGet(x, y - first, out hit, out light);
    }

    /// <inheritdoc/>
    void IGroundTruth.ReadRow(int y, TruthRow row)
    {
        (IGroundTruth truth, int first) = Of(StripOf(y - 1));
        truth.ReadRow(y - first, row);
    }

    /// <inheritdoc/>
    ReadOnlySpan<double> IGroundTruth.RadianceFactorsOf(int row)
    {
        (IGroundTruth truth, int first) = Of(StripOf(row));
        return truth.RadianceFactorsOf(row - first);
    }

    /// <inheritdoc/>
    ReadOnlySpan<double> IGroundTruth.ElectronsOf(int row)
    {
        (IGroundTruth truth, int first) = Of(StripOf(row));
        return truth.ElectronsOf(row - first);
    }

    /// <inheritdoc/>
    ReadOnlySpan<byte> IGroundTruth.SaturatedOf(int row)
    {
        (IGroundTruth truth, int first) = Of(StripOf(row));
        return truth.SaturatedOf(row - first);
    }

    private PixelRows ExposureOf(int row)
    {
        int first = row / rowsOfExposure * rowsOfExposure;
        return new PixelRows(first, first + rowsOfExposure);
    }

    private PixelRows StripOf(int row)
    {
        int first = row / rowsOfStrip * rowsOfStrip;
        return new PixelRows(first, Math.Min(camera.Height, first + rowsOfStrip));
    }

    private (IGroundTruth Truth, int First) Of(PixelRows rows)
    {
        Lazy<IGroundTruth> strip = _strips.GetOrAdd(rows, wanted =>
        {
            _order.Enqueue(wanted);
            return new Lazy<IGroundTruth>(() => draw(wanted));
        });
        while (_order.Count > KeptStrips && _order.TryDequeue(out PixelRows oldest))
        {
            _strips.TryRemove(oldest, out _);
        }

        return (strip.Value, rows.First);
    }
}
