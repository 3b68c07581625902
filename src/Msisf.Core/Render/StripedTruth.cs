using System.Collections.Concurrent;
using Msisf.Core.Camera;
using Msisf.Core.Scene;
using Msisf.Core.Tracing;

namespace Msisf.Core.Render;

/// <summary>
/// The ground truth of a scanned image that is too large to be kept: strips of rows are drawn when they are asked for, and the last ones
/// kept. Single pixels draw their exposure alone. Safe for several threads.
/// </summary>
/// <param name="rowsOfStrip">Rows of a strip, at least 1.</param>
/// <param name="rowsOfExposure">Rows that are exposed at once, of which a strip has some.</param>
/// <param name="draw">Draws some rows, with ground truth that stays valid.</param>
public sealed class StripedTruth(
    ICamera camera, SceneLight light, int rowsOfStrip, int rowsOfExposure, Func<PixelRows, IGroundTruth> draw) : IGroundTruth
{
    /// <summary>Number of strips kept, 50 MB or more each; layers are written from the top, a strip at a time.</summary>
    private const int KeptStrips = 2;

    /// <summary>The meta file reads several rows at a time.</summary>
    private const int KeptExposures = 8;

    private readonly Drawn _strips = new(draw, KeptStrips);
    private readonly Drawn _exposures = new(draw, KeptExposures);

    /// <inheritdoc/>
    public ICamera Camera => camera;

    /// <inheritdoc/>
    public SceneLight Light => light;

    /// <summary>Empty: <see cref="IGroundTruth.RadianceFactorsOf"/> has those of a row.</summary>
    public ReadOnlySpan<double> RadianceFactors => [];

    /// <inheritdoc/>
    public int RowsAtOnce => rowsOfStrip;

    /// <inheritdoc/>
    public bool TryGet(int x, int y, out SurfaceHit hit, out PixelIllumination light)
    {
        PixelRows strip = StripOf(y - 1);
        PixelRows exposure = ExposureOf(y - 1);
        (IGroundTruth truth, int first) = _strips.Has(strip) ? (_strips.Of(strip), strip.First) : (_exposures.Of(exposure), exposure.First);
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

    private (IGroundTruth Truth, int First) Of(PixelRows strip) => (_strips.Of(strip), strip.First);

    /// <summary>Parts of the image, drawn once while they are kept.</summary>
    private sealed class Drawn(Func<PixelRows, IGroundTruth> draw, int most)
    {
        private readonly ConcurrentDictionary<PixelRows, Lazy<IGroundTruth>> _parts = [];
        private readonly ConcurrentQueue<PixelRows> _order = [];

        public bool Has(PixelRows rows) => _parts.ContainsKey(rows);

        public IGroundTruth Of(PixelRows rows)
        {
            Lazy<IGroundTruth> part = _parts.GetOrAdd(rows, wanted =>
            {
                _order.Enqueue(wanted);
                return new Lazy<IGroundTruth>(() => draw(wanted));
            });
            while (_order.Count > most && _order.TryDequeue(out PixelRows oldest))
            {
                _parts.TryRemove(oldest, out _);
            }

            return part.Value;
        }
    }
}
