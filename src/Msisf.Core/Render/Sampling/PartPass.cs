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
    private double[] _factors = [];

    /// <summary>The parts that are lit and shaded together.</summary>
    public PartRows Rows { get; } = new();

    /// <summary>The light on them.</summary>
    public PixelSunlight Sunlight { get; } = new();

    /// <summary>Draws another surface from the next frame on; the memory is kept.</summary>
    public void Show(SurfaceModel next) => _surface = next;

    /// <summary>Draws the samples of some bands and finds the parts of their pixels.</summary>
    /// <param name="frame">The frame.</param>
    /// <param name="bands">Numbers of the first band, and of the one after the last.</param>
    /// <param name="lists">Receives the parts; made longer if it is too short.</param>
    /// <param name="list">The list of the first band's parts; those of the others follow.</param>
    /// <param name="merged">The list of the first band's parts without regard to borders of shadows; null for none.</param>
    public void Find(SampledFrame frame, (int First, int End) bands, List<PixelParts> lists, int list, int? merged = null)
    {
        int count = bands.End - bands.First;
        EnsureRoom(lists, Math.Max(list, merged ?? 0) + count);
        while (_workers.Count < frame.Threads)
        {
            _workers.Add(new SubsampleWorker());
        }

        WorkerTeam.Run(
            frame.Threads,
            count,
            (worker, index) => _workers[worker].Draw(
                _surface, frame.Frame, frame.Pixels, frame.Pixels.Bands[bands.First + index], lists[list + index],
                merged is { } first ? lists[first + index] : null),
            frame.Cancellation);
    }

    /// <summary>Lays out lists of parts in rows, and makes room for their brightness.</summary>
    public double[] Lay(SampledFrame frame, List<PixelParts> lists, int count)
    {
        Rows.Begin(frame.Frame.View);
        _firstRows.Clear();
        for (int list = 0; list < count; list++)
        {
            _firstRows.Add(Rows.Add(lists[list]));
        }

        int room = Rows.Height * PartRows.RowLength;
        if (_factors.Length < room)
        {
            _factors = new double[room];
        }

        return _factors;
    }

    /// <summary>Finds light and brightness of each part of some lists.</summary>
    public void Light(SampledFrame frame, List<PixelParts> lists, int count) => frame.Lights.Run(
        Rows, frame.Light, frame.Options, new SampleWeight(1.0, IsFirst: true), Sunlight, Lay(frame, lists, count), frame.Threads,
        frame.Cancellation);

    /// <summary>The light on the parts of a list, as <see cref="PixelSunlight.Hidden"/> has it.</summary>
    public ReadOnlySpan<byte> StatesOf(int list, PixelParts parts) =>
        Sunlight.Hidden.AsSpan(_firstRows[list] * PartRows.RowLength, parts.Count);

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
