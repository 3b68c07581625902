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
/// unsure the light of each group of neighbours is; then each group gets as many as the error of the whole asks for. One object serves
/// many frames, one at a time.
/// </summary>
internal sealed class IndirectPass(SurfaceModel surface)
{
    /// <summary>Cells across the view at the usual error; the number of cells grows with its inverse.</summary>
    private const int Cells = 256;

    /// <summary>First samples of each point.</summary>
    private const int FirstFar = 4;
    private const int FirstNear = 8;

    /// <summary>Points of far ground of each group of pixels at the usual error.</summary>
    private const int Choices = 256;

    /// <summary>Most rows and columns of a group of pixels.</summary>
    private const int MostEdge = 8;

    /// <summary>Parts of pixels that make a group.</summary>
    private const int PartsOfGroup = 8;

    /// <summary>By how much more points there are at most where the error is smaller.</summary>
    private const double MostChoices = 64.0;

    /// <summary>Most further samples of a point at the usual error: what rough ground near by hides takes very many.</summary>
    private const double MostFar = 16.0;

    /// <summary>The same for near ground, whose rays are short.</summary>
    private const double MostNear = 64.0;

    /// <summary>The part of the error that samples may have; the rest is that of the points that stand for the ground.</summary>
    private const double PartOfSamples = 0.8;

    /// <summary>Part of its whole brightness by which the error of a place is measured too: where the Sun shines, it counts less.</summary>
    private const double PartOfBrightness = 0.1;

    private SurfaceModel _surface = surface;
    private GroundTree? _tree;
    private GroundLights? _lights;
    private FrameCamera? _camera;
    private ConcurrentBag<IndirectWorker> _idle = [];
    private double[] _shared = [];
    private double[] _hidden = [];
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
        int cells = (int)Math.Ceiling(Cells * Math.Sqrt(IndirectLight.DefaultError / indirect.Error));
        _lights = GroundPlacing.Place(_tree, view, sun, cells, threads, cancellation);
        double pixel = 2.0 * view.Angle * _surface.ReferenceRadius / Math.Max(image.Width, image.Height);
        _edge = MostEdge; // no wider than the ground that is looked at by rays: so none of the points for the rest is too near to a group
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
    /// <param name="sum">Sum of the weights so far, with this one.</param>
    /// <param name="radianceFactors">Radiance factors by rows; receive the light.</param>
    /// <param name="indirect">The same for this light alone; empty if nobody wants it.</param>
    /// <param name="threads">Maximum number of threads; the result does not depend on it.</param>
    /// <param name="cancellation">Cancels the work.</param>
    public void Add(
        ISurfaceRows points, NativeRenderOptions options, double weight, double sum, double[] radianceFactors, double[] indirect,
        int threads, CancellationToken cancellation)
    {
        if (_lights is not { Bright.Length: > 0 })
        {
            return;
        }

        int count = points.Width * points.Height;
        if (_far.Length < count)
        {
            (_shared, _hidden, _far, _near) = (new double[count], new double[count], new double[count], new double[count]);
        }

        _shared.AsSpan(0, count).Clear();
        _hidden.AsSpan(0, count).Clear();
        _far.AsSpan(0, count).Clear();
        _near.AsSpan(0, count).Clear();
        int rows = points is VisibleSurface ? _edge : 1; // of an image, squares of pixels; parts of pixels lie in no squares
        int columns = points is VisibleSurface ? _edge : PartsOfGroup;
        int strips = (points.Height + rows - 1) / rows;
        int groups = (points.Width + columns - 1) / columns;
        _trials = new Trial[groups * strips];
        Round first = new(points, options, rows, columns, groups, 2L * _sets, 0.0);
        WorkerTeam.Run(threads, strips, (_, strip) => SampleStrip(first, strip), cancellation);

        // With several samples a pixel the errors of each may be larger, because their mean counts.
        double error = PartOfSamples * options.Indirect!.Error * options.SubsamplesPerAxis;
        Round second = first with
        {
            Number = (2L * _sets) + 1,
            SamplesPerDeviation = SamplesPerDeviation(first, error, radianceFactors, sum),
        };
        WorkerTeam.Run(threads, strips, (_, strip) =>
        {
            SampleStrip(second, strip);
            for (int row = strip * rows; row < Math.Min(points.Height, (strip + 1) * rows); row++)
            {
                AddRow(points, options, row, weight, radianceFactors, indirect);
            }
        }, cancellation);
        _sets++;
    }

    /// <summary>
    /// How many samples a group needs for each unit of its samples' standard deviation, so that all errors together are what is asked for:
    /// with such numbers they take the fewest samples. Deviations become parts of the light that errors are measured by.
    /// </summary>
    private double SamplesPerDeviation(Round round, double error, double[] radianceFactors, double sum)
    {
        int points = round.Points.Width * round.Points.Height;
        double squares = 0.0;
        for (int i = 0; i < points; i++)
        {
            double value = LightOf(i);
            squares += value * value;
        }

        (double deviations, long count) = (0.0, 0);
        foreach (Trial trial in _trials)
        {
            count += trial.Points;
        }

        for (int group = 0; squares > 0.0 && group < _trials.Length; group++)
        {
            ref Trial trial = ref _trials[group];
            double bright = PartOfBrightness / sum * MeanOf(radianceFactors, round, group);
            double light = Math.Sqrt((squares / count) + (bright * bright));
            trial = trial with { Far = trial.Far / light, Near = trial.Near / light };
            deviations += trial.Points * (trial.Far + trial.Near);
        }

        return squares > 0.0 ? deviations / (error * error * count) : 0.0;
    }

    /// <summary>The light of a point: of far ground no more than if nothing hid it, whatever few samples say.</summary>
    private double LightOf(int point) =>
        _near[point] + _shared[point] + Math.Clamp(_far[point], -_shared[point], _hidden[point]);

    /// <summary>Mean of the values of a group.</summary>
    private double MeanOf(double[] values, Round round, int group)
    {
        int left = group % round.Groups * round.Columns;
        int top = group / round.Groups * round.Rows;
        double sum = 0.0;
        for (int row = top; row < Math.Min(top + round.Rows, round.Points.Height); row++)
        {
            foreach (double value in values.AsSpan((row * round.Points.Width) + left, Math.Min(round.Points.Width - left, round.Columns)))
            {
                sum += value;
            }
        }

        return sum / Math.Max(1, _trials[group].Points);
    }

    /// <summary>Samples the points of some rows, for the first time or as often as the first time has shown to be necessary.</summary>
    private void SampleStrip(Round round, int strip)
    {
        IndirectWorker worker = Take(round.Options);
        worker.Read(round, strip);
        for (int group = 0; group < round.Groups; group++)
        {
            ref Trial trial = ref _trials[(strip * round.Groups) + group];
            bool isFirst = round.SamplesPerDeviation == 0.0;
            double ratio = IndirectLight.DefaultError / round.Options.Indirect!.Error;
            ratio *= ratio;
            int far = isFirst ? FirstFar : MoreThan(FirstFar, trial.Far * round.SamplesPerDeviation, MostFar * ratio);
            int near = isFirst ? FirstNear : MoreThan(FirstNear, trial.Near * round.SamplesPerDeviation, MostNear * ratio);
            if (far + near == 0 || !worker.TryFill(round, strip, group, _camera!.PositionBodyFixed, _lights!.ReachOfView))
            {
                continue;
            }

            int choices = (int)Math.Ceiling(Choices * Math.Min(ratio, MostChoices));
            if (far > 0)
            {
                worker.Gather.Choose(choices / 2, choices, 2L * _sets); // the same ones in both rounds
            }

            if (isFirst)
            {
                worker.Share(areSeen: true, _shared);
                worker.Share(areSeen: false, _hidden);
            }

            double farVariance = worker.Sample(far, isNear: false, round.Number, _far, isFirst ? 0 : FirstFar);
            double nearVariance = worker.Sample(near, isNear: true, round.Number, _near, isFirst ? 0 : FirstNear);
            if (isFirst)
            {
                int count = worker.Gather.Group.Count;
                trial = new Trial(count, Math.Sqrt(far * farVariance / count), Math.Sqrt(near * nearVariance / count));
            }
        }

        _idle.Add(worker);
    }

    private static int MoreThan(int first, double wanted, double most) => (int)Math.Clamp(Math.Ceiling(wanted) - first, 0.0, most);

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

    /// <summary>What the first samples of a group have shown.</summary>
    /// <param name="Points">Number of its points.</param>
    /// <param name="Far">Standard deviation of a sample of far ground.</param>
    /// <param name="Near">That of near ground.</param>
    private readonly record struct Trial(int Points, double Far, double Near);
}
