using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Render.Shading;

namespace Msisf.Core.Render.Indirect;

/// <summary>
/// Samples the light that ground throws on a group of points: far ground by points that stand for it, which the group shares, each looked
/// at from all points of the group together; near ground by rays of each point. Keeps buffers, so each thread needs its own object.
/// </summary>
/// <param name="tree">The ground.</param>
/// <param name="lights">The points that stand for it.</param>
/// <param name="camera">The camera, by whose pixels maps are read.</param>
/// <param name="options">The settings of the renderer.</param>
internal sealed partial class LightGather(GroundTree tree, GroundLights lights, FrameCamera camera, NativeRenderOptions options)
{
    /// <summary>No bright point within so many times the reach of near ground: no near ground is bright.</summary>
    private const double MarginOfReach = 1.5;

    /// <summary>The golden section: numbers that follow each other by it are spread evenly between 0 and 1.</summary>
    private const double Golden = 0.618_033_988_749_894_9;

    private readonly RowReflection _reflection = new(tree.Surface);
    private readonly SunlitPoints _targets = new();
    private readonly double[] _sums = new double[lights.Count + 1];
    private readonly double[] _binSums = new double[Bins + 1];
    private double[] _values = [];
    private readonly GroundFan _fan = new();
    private Choice[] _chosen = [];
    private int _choices;
    private double _total;
    private int _nearest;
    private bool _hasNear;

    /// <summary>The group; set before <see cref="Begin"/>.</summary>
    public Receivers Group { get; } = new();

    private SunlitPoints Sources => _reflection.Points;

    /// <summary>Prepares the group that was set.</summary>
    public void Begin()
    {
        Group.Close();
        tree.Start(_fan, Group);
        _hasNear = false;
        _total = 0.0;
        if (lights.Bright.Length > 0)
        {
            (_nearest, double distance) = lights.Bright.AddUp(Group, _sums);
            _hasNear = distance < Group.Radius + (MarginOfReach * Group.MostReach);
            _total = _sums[lights.Bright.Length - 1];
        }
    }

    private bool Faces(int receiver, Vector3D direction) =>
        Vector3D.Dot(Group.Facets[receiver], direction) > 0.0 && Vector3D.Dot(Group.Normals[receiver], direction) > 0.0;

    /// <summary>Adds the light that comes from a place: the Sun's, and the ground's own that a point near the place has.</summary>
    private void Add(int receiver, int sample, Vector3D direction, Place place, Vector3D? toSun, int light)
    {
        if (toSun is { } sun)
        {
            Add(receiver, sample, direction, place, sun, 1.0);
        }

        if (lights.FromGround[light] > 0.0)
        {
            Add(receiver, sample, direction, place, lights.ToGround[light], lights.FromGround[light]);
        }
    }

    private void Add(int receiver, int sample, Vector3D direction, Place place, Vector3D toLight, double strength)
    {
        double incidence = Math.Min(1.0, Vector3D.Dot(place.Normal, toLight));
        if (incidence <= 0.0)
        {
            return;
        }

        SunlitPoints sources = Sources;
        int i = sources.Count;
        sources.Add(sample, strength * place.Weight, place.Point, place.Normal, incidence);
        sources.CosEmission[i] = Math.Min(1.0, -Vector3D.Dot(place.Normal, direction));
        sources.PhaseHaversine[i] = Haversine(toLight, -direction);
        _targets.Add(
            sample, 0.0, Group.Points[receiver], direction, Math.Min(1.0, Vector3D.Dot(Group.Normals[receiver], direction)));
        _targets.CosEmission[i] = Math.Min(1.0, Vector3D.Dot(Group.Normals[receiver], Group.ToCamera[receiver]));
        _targets.PhaseHaversine[i] = Haversine(direction, Group.ToCamera[receiver]);
    }

    private static double Haversine(Vector3D one, Vector3D other) => Math.Min(1.0, 0.25 * (one - other).LengthSquared);

    private void Clear(int samples)
    {
        if (_values.Length < samples)
        {
            _values = new double[samples];
        }

        Sources.Clear(2 * samples);
        _targets.Clear(2 * samples);
        _values.AsSpan(0, samples).Clear();
    }

    /// <summary>Takes the laws of both reflections, and adds the samples of a point.</summary>
    private void Collect(int receiver, int samples, GatheredLight found, bool isNear)
    {
        int count = Sources.Count;
        if (count == 0)
        {
            return;
        }

        RowReflection.FindLawFactors(Sources, options);
        for (int i = 0; i < count; i++)
        {
            Sources.Weights[i] *= Sources.Factors[i] / Math.PI;
        }

        if (isNear)
        {
            _reflection.FindScales(camera, options); // those of far ground are known
            for (int i = 0; i < count; i++)
            {
                Sources.Weights[i] *= Sources.Factors[i];
            }
        }

        if (!found.IsIrradiance)
        {
            RowReflection.FindLawFactors(_targets, options);
        }

        for (int i = 0; i < count; i++)
        {
            double value = Sources.Weights[i] * (found.IsIrradiance ? _targets.CosIncidence[i] : _targets.Factors[i]);
            _values[Sources.Columns[i]] += value;
            if (found.IsIrradiance)
            {
                found.Directions[receiver] +=
                    value * new Vector3D(_targets.NormalX[i], _targets.NormalY[i], _targets.NormalZ[i]);
            }
        }

        (double sum, double steps) = (0.0, 0.0);
        for (int sample = 0; sample < samples; sample++)
        {
            double step = _values[sample] - _values[(sample + 1) % samples];
            sum += _values[sample];
            steps += step * step;
        }

        found.Values[receiver] += sum;
        found.Variance += 0.5 * steps;
    }

    /// <summary>A place that light comes from, and how its brightness counts.</summary>
    private readonly record struct Place(Vector3D Point, Vector3D Normal, double Weight);
}
