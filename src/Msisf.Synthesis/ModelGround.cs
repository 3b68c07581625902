using System.Collections.Concurrent;
using Msisf.Core.Terrain;

namespace Msisf.Synthesis;

/// <summary>
/// The smooth ground through a model's samples (bicubic, C1), less the detail at the samples: with the detail added, each sample has the
/// model's own height. If the model holds means of cells, the smooth ground with these means, less those of the detail: with the detail
/// added, each cell has the model's own mean. Safe for several threads.
/// </summary>
/// <remarks>
/// Interpolation: R. G. Keys, "Cubic convolution interpolation for digital image processing", IEEE Trans. ASSP 29 (1981), 1153. In a
/// model of the whole Moon the samples beyond 70 degrees of latitude are smoothed along the parallel (<see cref="BaseHeights"/>).
/// </remarks>
internal sealed class ModelGround
{
    /// <summary>Samples whose detail is remembered at most; all are forgotten when there are more.</summary>
    private const int MostKnown = 1 << 19;

    /// <summary>Cells whose smooth ground is remembered at most.</summary>
    private const int MostSplines = 4096;

    /// <summary>For means over all of a cell: of so many samples a side.</summary>
    private static readonly PixelMeanKernel Kernel = new(64);

    private readonly ulong _seed;
    private readonly MareMask _maria;
    private readonly GroundMemory _memory;
    private readonly ModelSlopes _slopes;
    private readonly ITerrainGrid _model;
    private readonly BorderGround? _beyond;
    private readonly BaseHeights? _base;
    private readonly int _around;
    private readonly ConcurrentDictionary<double, DetailLayer> _layers = new();
    private readonly ConcurrentDictionary<(double Cell, int Line, int Sample), double> _known = new();
    private readonly ConcurrentDictionary<(double Cell, int Line, int Sample), double> _beyondHeights = new();
    private readonly ConcurrentDictionary<(double Cell, int Line, int Sample), MeanSpline> _splines = new();

    /// <summary>Takes a model.</summary>
    /// <param name="model">The model.</param>
    /// <param name="seed">The user's seed.</param>
    /// <param name="maria">Where the ground is smoother.</param>
    /// <param name="memory">Keeps what layers find.</param>
    /// <param name="beyond">The ground around a map of a part of the Moon; null for a model of the whole Moon.</param>
    public ModelGround(ITerrainGrid model, ulong seed, MareMask maria, GroundMemory memory, BorderGround? beyond)
    {
        (_model, _seed, _maria, _memory, _beyond) = (model, seed, maria, memory, beyond);
        IGlobalGrid? moon = model as IGlobalGrid;
        _base = moon is null ? null : new BaseHeights(moon);
        _slopes = moon is null ? new ModelSlopes(null, null) : ModelSlopes.Of(moon, maria);
        _around = model.Projection is Equirectangular && model.Window.Samples == model.Samples ? model.Samples : 0;
    }

    /// <summary>m between the model's samples.</summary>
    public double Spacing => _model.Projection.Resolution.MetresPerPixel;

    /// <summary>The detail that cells of a width show.</summary>
    public DetailLayer LayerOf(double cell) =>
        _layers.GetOrAdd(cell, key => new DetailLayer(_seed, _maria, _slopes, Spacing, key, _memory));

    /// <summary>Line and sample of a place, px from the centre of the first pixel.</summary>
    public (double Line, double Sample) PixelOf(GroundPoints points, int index) => _model.Projection is Equirectangular(var perDegree)
        ? (((90.0 - points.Latitudes[index]) * perDegree) - 0.5, (points.Longitudes[index] * perDegree) - 0.5)
        : _model.Projection.PixelOf(points[index]);

    /// <summary>Heights of the smooth ground at places with a weight above 0.</summary>
    /// <param name="points">The places.</param>
    /// <param name="weights">Weights of the model there; only whether they are above 0 matters.</param>
    /// <param name="cell">m: width of the cells.</param>
    /// <param name="heights">Filled with m over the reference radius.</param>
    public void Interpolate(GroundPoints points, ReadOnlySpan<double> weights, double cell, Span<double> heights)
    {
        (double Line, double Sample)[] places = new (double, double)[points.Count];
        (double minLine, double maxLine, double minSample, double maxSample) = (1e300, -1e300, 1e300, -1e300);
        for (int i = 0; i < places.Length; i++)
        {
            if (weights[i] > 0.0)
            {
                (double line, double sample) = PixelOf(points, i);
                if (_around > 0 && minSample <= maxSample)
                {
                    sample -= Math.Round((sample - minSample) / _around) * _around;
                }

                places[i] = (line, sample);
                (minLine, maxLine) = (Math.Min(minLine, line), Math.Max(maxLine, line));
                (minSample, maxSample) = (Math.Min(minSample, sample), Math.Max(maxSample, sample));
            }
        }

        if (minLine > maxLine)
        {
            return;
        }

        if (_model.HoldsMeans)
        {
            InterpolateMeans(places, (minLine, maxLine), (minSample, maxSample), weights, cell, heights);
            return;
        }

        int firstLine = (int)Math.Floor(minLine) - 1;
        int firstSample = (int)Math.Floor(minSample) - 1;
        int width = (int)Math.Floor(maxSample) + 3 - firstSample;
        double[] rest = Rest(firstLine, (int)Math.Floor(maxLine) + 3 - firstLine, firstSample, width, cell);
        for (int i = 0; i < places.Length; i++)
        {
            if (weights[i] > 0.0)
            {
                heights[i] = Cubic(rest, width, places[i].Line - firstLine, places[i].Sample - firstSample);
            }
        }
    }

    private void InterpolateMeans(
        (double Line, double Sample)[] places, (double Min, double Max) lines, (double Min, double Max) samples,
        ReadOnlySpan<double> weights, double cell, Span<double> heights)
    {
        const int Reach = PixelMeanKernel.Reach;
        (int top, int left) = ((int)Math.Floor(lines.Min + 0.5), (int)Math.Floor(samples.Min + 0.5));
        (int down, int across) = ((int)Math.Floor(lines.Max + 0.5) + 1 - top, (int)Math.Floor(samples.Max + 0.5) + 1 - left);
        double meanCell = DetailMeans.CellFor(Spacing, cell);
        if (_splines.Count > MostSplines)
        {
            _splines.Clear();
        }

        // Close to the ground whole blocks, and single places, lie in one cell.
        MeanSpline spline = down == 1 && across == 1
            ? _splines.GetOrAdd((meanCell, top, left), _ => New())
            : New();
        for (int i = 0; i < places.Length; i++)
        {
            if (weights[i] > 0.0)
            {
                heights[i] = spline.HeightAt(places[i].Line + 0.5 - top, places[i].Sample + 0.5 - left);
            }
        }

        MeanSpline New() => new(
            Rest(top - Reach, down + (2 * Reach), left - Reach, across + (2 * Reach), meanCell), down, across, Kernel);
    }

    private static double Cubic(double[] samples, int width, double line, double sample)
    {
        (int row, int column) = ((int)line, (int)sample);
        (double n0, double n1, double n2, double n3) = Weights(line - row);
        (double w0, double w1, double w2, double w3) = Weights(sample - column);
        int at = ((row - 1) * width) + column - 1;
        return (n0 * Along(at)) + (n1 * Along(at + width)) + (n2 * Along(at + (2 * width))) + (n3 * Along(at + (3 * width)));

        double Along(int first) =>
            (w0 * samples[first]) + (w1 * samples[first + 1]) + (w2 * samples[first + 2]) + (w3 * samples[first + 3]);
    }

    private static (double Before, double First, double Second, double After) Weights(double t) => (
        0.5 * t * (-1.0 + (t * (2.0 - t))),
        1.0 + (0.5 * t * t * (-5.0 + (3.0 * t))),
        0.5 * t * (1.0 + (t * (4.0 - (3.0 * t)))),
        0.5 * t * t * (t - 1.0));

    /// <summary>The samples of a rectangle less the detail there, m over the reference radius, line by line.</summary>
    private double[] Rest(int firstLine, int lines, int firstSample, int samples, double cell)
    {
        if (_known.Count + _beyondHeights.Count > MostKnown)
        {
            _known.Clear();
            _beyondHeights.Clear();
        }

        double[] rest = new double[lines * samples];
        DetailLayer layer = LayerOf(cell);
        for (int row = 0; row < lines; row++)
        {
            int line = firstLine + row;
            Span<double> own = rest.AsSpan(row * samples, samples);
            double honoured = ReadHeights(line, firstSample, own, cell);
            for (int column = 0; column < samples && honoured > 0.0; column++)
            {
                int sample = Around(firstSample + column);
                if (!_known.TryGetValue((cell, line, sample), out double detail))
                {
                    detail = _model.HoldsMeans
                        ? DetailMeans.Of(_model, _maria, layer, cell, line, sample)
                        : DetailAt(layer, _model.Projection.DirectionOf(line, sample));
                    _known[(cell, line, sample)] = detail;
                }

                own[column] -= honoured * detail;
            }
        }

        return rest;
    }

    private double DetailAt(DetailLayer layer, Vector3D direction)
    {
        SelenographicPoint point = SelenographicPoint.Below(direction);
        return layer.At(
            direction, (float)_maria.At(double.RadiansToDegrees(point.Latitude), double.RadiansToDegrees(point.Longitude)));
    }

    /// <summary>
    /// Reads heights of a model, and tells how much of the detail's own height at the samples is taken off. Where a map has no data the
    /// ground beyond it goes on, so that it is joined without a step and its own samples stay.
    /// </summary>
    private double ReadHeights(int line, int firstSample, Span<double> heights, double cell)
    {
        if (_base is not null)
        {
            ReadRing(firstSample, heights, (first, part) => _base.ReadHeights(line, first, part));
            return _base.HonouredPart(line);
        }

        for (int column = 0; column < heights.Length; column++)
        {
            int sample = Around(firstSample + column);
            heights[column] = _beyond!.Border.HasData(line, sample)
                ? HeightOf(line, sample)
                : _beyondHeights.GetOrAdd(
                    (cell, line, sample), at => _beyond.HeightAt(_model.Projection.DirectionOf(at.Line, at.Sample), at.Cell));
        }

        return 1.0;
    }

    private double HeightOf(int line, int sample)
    {
        Span<double> radius = stackalloc double[1];
        _model.ReadRadii(line, sample, radius);
        return radius[0] - MoonConstants.ReferenceRadius;
    }

    private int Around(int sample) => _around > 0 ? (((sample % _around) + _around) % _around) : sample;

    private void ReadRing(int firstSample, Span<double> heights, ReadPart read)
    {
        int turn = _around > 0 ? _around : int.MaxValue;
        for (int done = 0; done < heights.Length; done += Math.Min(turn, heights.Length - done))
        {
            read(Around(firstSample + done), heights.Slice(done, Math.Min(turn, heights.Length - done)));
        }
    }

    private delegate void ReadPart(int firstSample, Span<double> heights);
}
