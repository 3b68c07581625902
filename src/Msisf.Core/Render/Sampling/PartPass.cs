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
    private readonly List<int> _firstReceiverRows = [];
    private readonly PartRows _rows = new();
    private readonly PartRows _receiverRows = new();
    private readonly PixelSunlight _sunlight = new();
    private readonly PixelSunlight _receiverSunlight = new();
    private double[] _factors = [];
    private double[] _scales = [];
    private double[] _receiverScales = [];
    private double[] _indirectFactors = [];
    private bool _hasIndirect;

    /// <inheritdoc cref="SurfaceModel.ReferenceRadius"/>
    public double ReferenceRadius => _surface.ReferenceRadius;

    /// <summary>Draws another surface from the next frame on; the memory is kept.</summary>
    public void Show(SurfaceModel next) => _surface = next;

    /// <summary>Draws the samples of some bands and finds the parts of their pixels.</summary>
    /// <param name="bands">Numbers of the first band, and of the one after the last.</param>
    /// <param name="lists">Receives the parts, a list for each band.</param>
    /// <param name="withMerged">Whether further lists receive the parts without regard to borders of shadows.</param>
    public void Find(SampledFrame frame, SampledPixels pixels, (int First, int End) bands, List<PixelParts> lists, bool withMerged)
    {
        int count = bands.End - bands.First;
        while (lists.Count < (withMerged ? 2 * count : count))
        {
            lists.Add(new PixelParts());
        }

        while (_workers.Count < frame.Threads)
        {
            _workers.Add(new SubsampleWorker());
        }

        WorkerTeam.Run(
            frame.Threads,
            count,
            (worker, index) => _workers[worker].Draw(
                _surface, frame.Frame, pixels, pixels.Bands[bands.First + index], lists[index], withMerged ? lists[count + index] : null,
                frame.Pieces, frame.LensSamples),
            frame.Cancellation);
    }

    /// <summary>Finds light and brightness of each part of some lists.</summary>
    public void Light(SampledFrame frame, List<PixelParts> lists, int count)
    {
        _rows.Begin(frame.Frame.View);
        _receiverRows.Begin(frame.Frame.View);
        _firstRows.Clear();
        _firstReceiverRows.Clear();
        for (int list = 0; list < count; list++)
        {
            _firstRows.Add(_rows.Add(lists[list], lists[list].Points));
            _firstReceiverRows.Add(_receiverRows.Add(lists[list], lists[list].Receivers));
        }

        int room = _rows.Height * PartRows.RowLength;
        if (_factors.Length < room)
        {
            _factors = new double[room];
        }

        bool hasMap = frame.Lights.HasMap(frame.Options);
        int receivers = _receiverRows.Height * PartRows.RowLength;
        if (hasMap && _receiverScales.Length < receivers)
        {
            _receiverScales = new double[receivers];
        }

        frame.Lights.FindLight(
            _receiverRows, frame.Light, frame.Options, _receiverSunlight, hasMap ? _receiverScales : [], frame.Threads,
            frame.Cancellation);
        _scales = !hasMap ? [] : _scales.Length < room ? new double[room] : _scales;
        _sunlight.Prepare(room, hasFractions: true);
        WorkerTeam.Run(frame.Threads, count, (_, list) => Gather(list, lists[list]), frame.Cancellation);
        frame.Lights.Shade(
            _rows, frame.Light, frame.Options, _sunlight, _scales, _factors, frame.Threads, frame.Cancellation);
        _hasIndirect = frame.Options.Indirect is not null;
        if (_hasIndirect)
        {
            if (_indirectFactors.Length < room)
            {
                _indirectFactors = new double[room];
            }

            _indirectFactors.AsSpan(0, room).Clear();
            frame.Indirect.Add(_rows, frame.Options, _factors, _indirectFactors, frame.Threads, frame.Cancellation);
        }
    }

    /// <summary>The brightness of the parts of a list.</summary>
    public ReadOnlySpan<double> FactorsOf(int list, PixelParts parts) => Of(_factors, list, parts);

    /// <summary>The part of it that the ground's own light makes; empty if it is not asked for.</summary>
    public ReadOnlySpan<double> IndirectFactorsOf(int list, PixelParts parts) =>
        _hasIndirect ? Of(_indirectFactors, list, parts) : [];

    /// <summary>The visible fraction of the light at the receivers of a list, 0 to 1.</summary>
    public double[] FractionsOf(int list, PixelParts parts)
    {
        int first = _firstReceiverRows[list] * PartRows.RowLength;
        return [.. Enumerable.Range(first, parts.Receivers.Count).Select(_receiverSunlight.VisibleFraction)];
    }

    /// <summary>Adds the brightness of the parts of a list to that of their pixels.</summary>
    public void Collect(SampledFrame frame, int list, PixelParts parts)
    {
        Collect(parts, FactorsOf(list, parts), frame.RadianceFactors);
        Collect(parts, IndirectFactorsOf(list, parts), frame.IndirectFactors);
    }

    private static void Collect(PixelParts parts, ReadOnlySpan<double> factors, double[] sums)
    {
        for (int part = 0; part < factors.Length; part++)
        {
            sums[parts.Pixels[part]] += parts.Weights[part] * factors[part];
        }
    }

    private ReadOnlySpan<double> Of(double[] factors, int list, PixelParts parts) =>
        factors.AsSpan(_firstRows[list] * PartRows.RowLength, parts.Count);

    /// <summary>
    /// Finds the mean of what the receivers of each part have: their light and what the maps say. It puts each part where its lit receivers
    /// have their mean: brightness that is linear over the part is then exact.
    /// </summary>
    private void Gather(int list, PixelParts parts)
    {
        int first = _firstRows[list] * PartRows.RowLength;
        int receiver = _firstReceiverRows[list] * PartRows.RowLength;
        int shift = receiver;
        bool hasMap = _scales.Length > 0;
        for (int part = 0; part < parts.Count; part++)
        {
            int begin = receiver;
            int end = shift + parts.ReceiverEnds[part];
            double sum = 0.0;
            double cosines = 0.0;
            double scales = 0.0;
            FacetPlace place = default;
            for (; receiver < end; receiver++)
            {
                double fraction = _receiverSunlight.VisibleFraction(receiver);
                if (fraction <= 0.0)
                {
                    continue;
                }

                sum += fraction;
                cosines += fraction * _receiverSunlight.CosIncidence[receiver];
                scales += fraction * (hasMap ? _receiverScales[receiver] : 1.0);
                place += fraction * parts.Receivers.PlaceOf(receiver - shift);
            }

            if (hasMap)
            {
                _scales[first + part] = sum > 0.0 ? scales / sum : 1.0;
            }

            if (sum > 0.0 && sum < end - begin)
            {
                parts.Points.Move(part, (1.0 / sum) * place);
            }

            _sunlight.Hidden[first + part] = sum > 0.0 ? (byte)0 : (byte)1;
            _sunlight.VisibleFractions[first + part] = sum / (end - begin);
            _sunlight.CosIncidence[first + part] = sum > 0.0 ? cosines / sum : 0.0;
        }
    }
}
