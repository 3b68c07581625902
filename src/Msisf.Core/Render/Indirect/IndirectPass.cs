using System.Collections.Concurrent;
using Msisf.Core.Camera;
using Msisf.Core.Parallel;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
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
    /// <summary>Cells across the view; for errors below <see cref="ErrorOfCells"/> more, with the root of its inverse.</summary>
    private const int Cells = 256;
    private const double ErrorOfCells = 0.01;

    /// <summary>First points of far ground for each group, without ways to them and with.</summary>
    private const int FirstShared = 64;
    private const int FirstOther = 16;

    /// <summary>First rays of each point to near ground.</summary>
    private const int FirstNear = 16;

    /// <summary>First rays of a group to near ground, if it has few points.</summary>
    private const int FirstNearOfGroup = 512;

    /// <summary>How often groups are sampled: with more samples some turn out to be less sure than with few.</summary>
    private const int MostRounds = 6;

    /// <summary>Most rows and columns of a group of pixels.</summary>
    private const int MostEdge = 8;

    /// <summary>Parts of pixels that make a group.</summary>
    private const int PartsOfGroup = 8;

    /// <summary>Near ground may be higher than the first samples have met, rad and over what they met.</summary>
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
    private SharedSight? _shared;
    private ConcurrentBag<IndirectWorker> _idle = [];
    private double[] _far = [];
    private double[] _other = [];
    private double[] _near = [];
    private double[] _light = [];
    private TrialGrid _trials = new(0, 0);
    private IndirectProgress? _progress;
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
        (_lights, _idle, _sets, _progress) = (null, [], 0, new IndirectProgress(options));
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
        _lights = GroundPlacing.Place(_tree, view, sun, cells, threads, cancellation, _progress.Prepare);
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

        _shared = SharedSight.Find(image, _tree, _lights, threads, cancellation, _progress.Prepare);
    }

    /// <summary>Ends a frame: reports that all is done.</summary>
    public void End() => _progress?.Finish();

    /// <summary>Adds the light to radiance factors.</summary>
    /// <param name="points">The points.</param>
    /// <param name="options">The settings.</param>
    /// <param name="radianceFactors">Radiance factors by rows; receive the light.</param>
    /// <param name="indirect">The same for this light alone; empty if nobody wants it.</param>
    /// <param name="threads">Maximum number of threads; the result does not depend on it.</param>
    /// <param name="cancellation">Cancels the work.</param>
    public void Add(
        ISurfaceRows points, NativeRenderOptions options, double[] radianceFactors, double[] indirect, int threads,
        CancellationToken cancellation)
    {
        if (_lights is not { Bright.Length: > 0 })
        {
            return;
        }

        int count = points.Width * points.Height;
        if (_far.Length < count)
        {
            (_far, _other, _near, _light) = (new double[count], new double[count], new double[count], new double[count]);
        }

        _far.AsSpan(0, count).Clear();
        _other.AsSpan(0, count).Clear();
        _near.AsSpan(0, count).Clear();
        int rows = points is VisibleSurface ? _edge : 1; // of an image, squares of pixels; parts of pixels lie in no squares
        int columns = points is VisibleSurface ? _edge : PartsOfGroup;
        int strips = (points.Height + rows - 1) / rows;
        int groups = (points.Width + columns - 1) / columns;
        _trials = new TrialGrid(groups, strips);
        double effort = 0.0;
        _progress!.Begin(strips);

        double error = PartOfSamples * options.Indirect!.Error;
        for (int number = 0; number < MostRounds && (number == 0 || effort > 0.0); number++)
        {
            Round round = new(points, options, rows, columns, groups, ((long)MostRounds * _sets) + number, effort);
            WorkerTeam.Run(threads, strips, (_, strip) => _progress.Add(SampleStrip(round, strip)), cancellation);
            _trials.LookAround();
            effort = _trials.EffortFor(error * error * SumUp(points, rows, columns));
            _progress.Expect(_trials.CostWith(effort));
        }

        WorkerTeam.Run(
            threads, points.Height, (_, row) => AddRow(points, options, row, radianceFactors, indirect), cancellation);
        _sets++;
        _progress.End();
    }

    /// <summary>Sums up the light of each point.</summary>
    /// <returns>The sum of the squares.</returns>
    private double SumUp(ISurfaceRows points, int rows, int columns)
    {
        double squares = 0.0;
        for (int i = 0; i < points.Width * points.Height; i++)
        {
            double part = _trials.Known(i / points.Width / rows, i % points.Width / columns).PartOfOther;
            _light[i] = Math.Max(0.0, _far[i] + (part * _other[i])) + _near[i];
            squares += _light[i] * _light[i];
        }

        return squares;
    }

    /// <summary>Samples the points of some rows, for the first time or as often as the times before have shown to be necessary.</summary>
    /// <returns>What it cost (<see cref="Trial.CostOf"/>).</returns>
    private double SampleStrip(Round round, int strip)
    {
        IndirectWorker worker = Take(round.Options);
        worker.Read(round, strip);
        double cost = 0.0;
        for (int group = 0; group < round.Groups; group++)
        {
            ref Trial trial = ref _trials[strip, group];
            bool isFirst = round.Effort == 0.0;
            (int shared, int other, int near) = _trials.Known(strip, group).Next(round.Effort);
            if ((!isFirst && shared + other + near == 0)
                || !worker.TryFill(round, strip, group, _camera!.PositionBodyFixed, _lights!.ReachOfView, _shared!))
            {
                continue;
            }

            int count = worker.Gather.Group.Count;
            if (isFirst)
            {
                (shared, other, near) = (FirstShared, FirstOther, Math.Max(FirstNear, FirstNearOfGroup / count));
                trial = trial with { Points = count };
            }

            cost += count * Trial.CostOf(shared, other, near);
            if (shared > 0)
            {
                trial = trial with { Shared = Of(worker.FindShared(shared, round.Number, _far), shared, count) };
            }

            if (other > 0)
            {
                GatheredLight light = worker.FindOther(other, round.Number, _other);
                trial = trial with { Other = Of(light, other, count), Bound = light.Bound / count };
            }

            if (near > 0)
            {
                GatheredLight light = worker.FindNear(near, trial.Top, round.Number, _near);
                double top = isFirst ? Math.Min(MostTop, (MarginOfTop * light.Top) + LeastTop) : trial.Top;
                trial = trial with { Near = Of(light, near, count), Top = top };
            }
        }

        _idle.Add(worker);
        return cost;
    }

    private static Deviation Of(GatheredLight light, int samples, int points) =>
        new(Math.Sqrt(samples * light.Variance / points), samples);

    private void AddRow(
        ISurfaceRows points, NativeRenderOptions options, int row, double[] radianceFactors, double[] indirect)
    {
        IndirectWorker worker = Take(options);
        worker.Scale(points, row, _camera!, options);
        SunlitPoints scaled = worker.Reflection.Points;
        int start = row * points.Width;
        for (int i = 0; i < scaled.Count; i++)
        {
            int at = start + scaled.Columns[i];
            double value = scaled.Factors[i] * _light[at];
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
}
