using Msisf.Core.Parallel;
using Msisf.Core.Render.Shading;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Surface;

namespace Msisf.Core.Render.Sampling;

/// <summary>
/// Finds the parts of pixels that show one facet each, their light and their brightness. One object serves many frames, one at a time.
/// </summary>
internal sealed class PartPass(SurfaceModel surface)
{
    private SurfaceModel _surface = surface;
    private readonly List<SubsampleWorker> _workers = [];
    private readonly List<int> _firstRows = [];
    private readonly PartRows _rows = new();
    private readonly PixelSunlight _sunlight = new();
    private double[] _factors = [];

    /// <summary>Draws another surface from the next frame on; the memory is kept.</summary>
    public void Show(SurfaceModel next) => _surface = next;

    /// <summary>Draws the samples of some bands and finds the parts of their pixels.</summary>
    /// <param name="bands">Numbers of the first band, and of the one after the last.</param>
    /// <param name="lists">Receives the parts, a list for each band.</param>
    /// <param name="withMerged">Whether further lists receive the parts without regard to borders of shadows.</param>
    public void Find(SampledFrame frame, SampledPixels pixels, (int First, int End) bands, List<PixelParts> lists, bool withMerged)
    {
        int count = bands.End - bands.First;
        EnsureRoom(lists, withMerged ? 2 * count : count);
        while (_workers.Count < frame.Threads)
        {
            _workers.Add(new SubsampleWorker());
        }

        WorkerTeam.Run(
            frame.Threads,
            count,
            (worker, index) => _workers[worker].Draw(
                _surface, frame.Frame, pixels, pixels.Bands[bands.First + index], lists[index], withMerged ? lists[count + index] : null),
            frame.Cancellation);
    }

    /// <summary>Finds light and brightness of each part of some lists.</summary>
    public void Light(SampledFrame frame, List<PixelParts> lists, int count)
    {
        _rows.Begin(frame.Frame.View);
        _firstRows.Clear();
        for (int list = 0; list < count; list++)
        {
            _firstRows.Add(_rows.Add(lists[list]));
        }

        int room = _rows.Height * PartRows.RowLength;
        if (_factors.Length < room)
        {
            _factors = new double[room];
        }

        frame.Lights.Run(
            _rows, frame.Light, frame.Options, new SampleWeight(1.0, IsFirst: true, ForgetsLight: true), _sunlight, _factors, frame.Threads,
            frame.Cancellation);
        if (frame.Options.Indirect is not null)
        {
            frame.Indirect?.Add(
                _rows, frame.Options, weight: 1.0, _factors, indirect: [], frame.Threads, frame.Cancellation);
        }
    }

    /// <summary>The brightness of the parts of a list.</summary>
    public ReadOnlySpan<double> FactorsOf(int list, PixelParts parts) =>
        _factors.AsSpan(_firstRows[list] * PartRows.RowLength, parts.Count);

    /// <summary>Adds the brightness of the parts of a list to that of their pixels.</summary>
    public void Collect(SampledFrame frame, int list, PixelParts parts)
    {
        ReadOnlySpan<double> factors = FactorsOf(list, parts);
        for (int part = 0; part < factors.Length; part++)
        {
            frame.RadianceFactors[parts.Pixels[part]] += parts.Weights[part] * factors[part];
        }
    }

    /// <summary>Makes a list of lists of parts long enough.</summary>
    public static void EnsureRoom(List<PixelParts> lists, int count)
    {
        while (lists.Count < count)
        {
            lists.Add(new PixelParts());
        }
    }
}
