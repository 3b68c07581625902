using System.Collections.Concurrent;
using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Parallel;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Render.Shading;
using Msisf.Core.Render.Shadows;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Scene;
using Msisf.Core.Surface;

namespace Msisf.Core.Render.Indirect;

/// <summary>
/// Adds the light that the terrain around throws on surface points (docs/photometry.md). First a few samples for each point show how
/// unsure the light of each group of neighbours is; then each group gets as many as the error of the whole asks for, until no group turns
/// out to need more. One object serves many frames, one at a time.
/// </summary>
internal sealed class IndirectPass(SurfaceModel surface)
{
    /// <summary>Cells across the view, to an error of <see cref="ErrorOfCells"/>; then their number grows with its inverse.</summary>
    private const int Cells = 256;
    private const double ErrorOfCells = 0.01;

    /// <summary>First rays of each point to near ground.</summary>
    private const int FirstNear = 16;

    /// <summary>First rays of a group to near ground, if it has few points.</summary>
    private const int FirstNearOfGroup = 64;

    /// <summary>How often groups are sampled: with more samples some turn out to be less sure than with few.</summary>
    private const int MostRounds = 4;

    /// <summary>So many times the samples that a group has need not be taken yet.</summary>
    private const double Enough = 1.25;

    /// <summary>Most samples of a point.</summary>
    private const double Most = 65536.0;

    /// <summary>How much a ray costs over a point of far ground: the root of the ratio.</summary>
    private const double CostOfNear = 3.0;

    /// <summary>Most rows and columns of a group of pixels.</summary>
    private const int MostEdge = 8;

    /// <summary>Parts of pixels that make a group.</summary>
    private const int PartsOfGroup = 8;

    /// <summary>Near ground may stand higher than the first samples have met, rad and over what they met.</summary>
    private const double LeastTop = 0.02;
    private const double MarginOfTop = 1.2;

    /// <summary>rad: elevations from here on are looked at evenly.</summary>
    private const double MostTop = 0.5;

    /// <summary>The part of the error that samples may have; the rest is that of the points that stand for the ground.</summary>
    private const double PartOfSamples = 0.8;

    private SurfaceModel _surface = surface;
    private GroundTree? _tree;
    private GroundLights? _lights;
    private FrameCamera? _camera;
    private ConcurrentBag<IndirectWorker> _idle = [];
    private double[] _far = [];
    private double[] _near = [];
    private Trial[] _trials = [];
    private int _sets;
    private int _edge;

    /// <summary>Draws another surface from the next frame on.</summary>
    public void Show(SurfaceModel next) => _surface = next;

    /// <summary>Prepares the light of a frame.</summary>
    /// <param name="image">The surface points of its pixels.</param>
    /// <param name="light">The Sun.</param>
    /// <param name="options">The settings, with <see cref="NativeRenderOptions.Indirect"/>.</param>
    /// <param name="threads">Maximum number of threads; the result does not depend on it.</param>
    /// <param name="cancellation">Cancels the work.</param>
    public void Begin(ISurfaceRows image, SceneLight light, NativeRenderOptions options, int threads, CancellationToken cancellation)
    {
        _camera = image.View.Camera;
        (_lights, _idle, _sets) = (null, [], 0);
        IndirectLight indirect = options.Indirect!;
        if (GroundPlacing.FindView(image) is not { } view)
        {
            return;
        }

        _tree = new GroundTree(_surface, view.Middle);
        Vector3D[] sun = options.Sun == SunModel.Disc
            ? new SunDisc(light.PositionBodyFixed).PointsBodyFixed.ToArray()
            : [light.PositionBodyFixed];
        int cells = (int)Math.Ceiling(Cells * Math.Sqrt(Math.Max(1.0, ErrorOfCells / indirect.Error)));
        _lights = GroundPlacing.Place(_tree, view, sun, cells, threads, cancellation);
        double pixel = 2.0 * view.Angle * _surface.ReferenceRadius / Math.Max(image.Width, image.Height);
        _edge = MostEdge; // no wider than the ground that is looked at by rays: from wider groups few points look alike
        while (_edge > 1 && _edge * pixel > _lights.ReachOfView)
        {
            _edge /= 2;
        }

        GroundBounces bounces = new(_tree, _lights, _camera, options);
        bounces.Start(threads, cancellation);
        for (int bounce = 1; bounce < indirect.Bounces; bounce++)
        {
            bounces.Add(bounce, threads, cancellation);
        }
    }

    /// <summary>Adds the light to radiance factors.</summary>
    /// <param name="points">The points.</param>
    /// <param name="options">The settings.</param>
    /// <param name="weight">Weight of the points in the sum.</param>
    /// <param name="radianceFactors">Radiance factors by rows; receive the light.</param>
    /// <param name="indirect">The same for this light alone; empty if nobody wants it.</param>
    /// <param name="threads">Maximum number of threads; the result does not depend on it.</param>
    /// <param name="cancellation">Cancels the work.</param>
    public void Add(
        ISurfaceRows points, NativeRenderOptions options, double weight, double[] radianceFactors, double[] indirect, int threads,
        CancellationToken cancellation)
    {
        if (_lights is not { Bright.Length: > 0 })
        {
            return;
        }

        int count = points.Width * points.Height;
        if (_far.Length < count)
        {
            (_far, _near) = (new double[count], new double[count]);
        }

        _far.AsSpan(0, count).Clear();
        _near.AsSpan(0, count).Clear();
        int rows = points is VisibleSurface ? _edge : 1; // of an image, squares of pixels; parts of pixels lie in no squares
        int columns = points is VisibleSurface ? _edge : PartsOfGroup;
        int strips = (points.Height + rows - 1) / rows;
        int groups = (points.Width + columns - 1) / columns;
        _trials = new Trial[groups * strips];

        // With several samples a pixel the errors of each may be larger, because their mean counts.
        double error = PartOfSamples * options.Indirect!.Error * options.SubsamplesPerAxis;
        for (int number = 0; number < MostRounds; number++)
        {
            double perDeviation = number == 0 ? 0.0 : SamplesPerDeviation(count, error);
            if (number > 0 && !Array.Exists(_trials, trial => MoreFar(trial, perDeviation) + MoreNear(trial, perDeviation) > 0))
            {
                break;
            }

            Round round = new(points, options, rows, columns, groups, ((long)MostRounds * _sets) + number, perDeviation);
            WorkerTeam.Run(threads, strips, (_, strip) => SampleStrip(round, strip), cancellation);
        }

        WorkerTeam.Run(
            threads, points.Height, (_, row) => AddRow(points, options, row, weight, radianceFactors, indirect), cancellation);
        _sets++;
    }

    /// <summary>
    /// How many samples a group needs for each unit of its samples' standard deviation, so that all errors together are the asked part of
    /// the light's rms: with such numbers they take the least work.
    /// </summary>
    private double SamplesPerDeviation(int points, double error)
    {
        (double squares, double deviations) = (0.0, 0.0);
        for (int i = 0; i < points; i++)
        {
            squares += LightOf(i) * LightOf(i);
        }

        foreach (Trial trial in _trials)
        {
            deviations += trial.Points * (trial.Far.OfOne + (CostOfNear * trial.Near.OfOne));
        }

        return squares > 0.0 ? deviations / (error * error * squares) : 0.0;
    }

    private double LightOf(int point) => _far[point] + _near[point];

    /// <summary>Samples the points of some rows, for the first time or as often as the times before have shown to be necessary.</summary>
    private void SampleStrip(Round round, int strip)
    {
        IndirectWorker worker = Take(round.Options);
        worker.Read(round, strip);
        for (int group = 0; group < round.Groups; group++)
        {
            ref Trial trial = ref _trials[(strip * round.Groups) + group];
            bool isFirst = round.SamplesPerDeviation == 0.0;
            (int far, int near) = (MoreFar(trial, round.SamplesPerDeviation), MoreNear(trial, round.SamplesPerDeviation));
            if ((!isFirst && far + near == 0)
                || !worker.TryFill(round, strip, group, _camera!.PositionBodyFixed, _lights!.ReachOfView))
            {
                continue;
            }

            int count = worker.Gather.Group.Count;
            (far, near) = isFirst ? (LightGather.FirstChoices, Math.Max(FirstNear, FirstNearOfGroup / count)) : (far, near);
            if (far > 0)
            {
                double variance = worker.FindFar(far, round.Number, _far).Variance;
                trial = trial with { Points = count, Far = new Deviation(Math.Sqrt(far * variance / count), far) };
            }

            if (near > 0)
            {
                GatheredLight light = worker.FindNear(near, trial.Top, round.Number, _near);
                trial = trial with
                {
                    Near = new Deviation(Math.Sqrt(near * light.Variance / count), near),
                    Top = isFirst ? Math.Min(MostTop, (MarginOfTop * light.Top) + LeastTop) : trial.Top,
                };
            }
        }

        _idle.Add(worker);
    }

    private static int MoreFar(Trial trial, double perDeviation) => More(trial.Far, perDeviation);

    private static int MoreNear(Trial trial, double perDeviation) => More(trial.Near, perDeviation / CostOfNear);

    /// <summary>How many samples a group needs in place of those that it has; 0 if these are enough.</summary>
    private static int More(Deviation found, double perDeviation)
    {
        double wanted = Math.Min(Math.Ceiling(found.OfOne * perDeviation), Most);
        return wanted > Enough * found.Samples ? (int)wanted : 0;
    }

    private void AddRow(
        ISurfaceRows points, NativeRenderOptions options, int row, double weight, double[] radianceFactors, double[] indirect)
    {
        IndirectWorker worker = Take(options);
        worker.Scale(points, row, _camera!, options);
        SunlitPoints scaled = worker.Reflection.Points;
        int start = row * points.Width;
        for (int i = 0; i < scaled.Count; i++)
        {
            int at = start + scaled.Columns[i];
            double value = weight * scaled.Factors[i] * LightOf(at);
            radianceFactors[at] += value;
            if (indirect.Length > 0)
            {
                indirect[at] += value;
            }
        }

        _idle.Add(worker);
    }

    private IndirectWorker Take(NativeRenderOptions options) =>
        _idle.TryTake(out IndirectWorker? idle) ? idle : new IndirectWorker(_surface, new LightGather(_tree!, _lights!, _camera!, options));

    /// <summary>What the samples of a group have shown.</summary>
    /// <param name="Points">Number of its points.</param>
    /// <param name="Far">Of far ground.</param>
    /// <param name="Near">Of near ground.</param>
    /// <param name="Top">rad: how far up near ground was found.</param>
    private readonly record struct Trial(int Points, Deviation Far, Deviation Near, double Top);

    /// <summary>How unsure light is.</summary>
    /// <param name="OfOne">Standard deviation of one sample.</param>
    /// <param name="Samples">How many samples each point has.</param>
    private readonly record struct Deviation(double OfOne, int Samples);
}
