using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Render.Shading;

namespace Msisf.Core.Render.Indirect;

/// <summary>
/// Samples the light that ground throws on a group of points: far ground by points that stand for it, near ground by rays in all
/// directions. The group shares its points of far ground: each is looked at from one point of the group. Where that is not what another
/// point sees, further rays of each point tell. Keeps buffers, so each thread needs its own object.
/// </summary>
/// <param name="tree">The ground.</param>
/// <param name="lights">The points that stand for it.</param>
/// <param name="camera">The camera, by whose pixels maps are read.</param>
/// <param name="options">The settings of the renderer.</param>
internal sealed partial class LightGather(GroundTree tree, GroundLights lights, FrameCamera camera, NativeRenderOptions options)
{
    /// <summary>m: a way to a point ends so much before it.</summary>
    private const double Gap = 1e-3;

    /// <summary>Added to cosines of groups, so that no point is left out that may count.</summary>
    private const double Slack = 0.1;

    /// <summary>Parts of equal power of all far ground, of which is found out how much the group sees.</summary>
    private const int Bins = 128;

    /// <summary>How much a part of far ground counts of which nothing was seen.</summary>
    private const double Unseen = 0.1;

    /// <summary>No bright point within so many times the reach of near ground: no near ground is bright.</summary>
    private const double MarginOfReach = 1.5;

    /// <summary>The golden section: directions that follow each other by it are spread evenly round a circle.</summary>
    private const double Golden = 0.618_033_988_749_894_9;

    private readonly RowReflection _reflection = new(tree.Surface);
    private readonly SunlitPoints _targets = new();
    private readonly double[] _sums = new double[lights.Count + 1];
    private readonly double[] _binSums = new double[Bins + 1];
    private double[] _values = [];
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
        double reach = Group.LeastReach;
        double closest = double.PositiveInfinity;
        _hasNear = false;
        double sum = 0.0;
        for (int i = 0; i < lights.Bright.Length; i++)
        {
            int light = lights.Bright[i];
            Vector3D away = lights.Points[light] - Group.Middle;
            double distance = Math.Sqrt(away.LengthSquared);
            if (distance > reach - Group.Radius)
            {
                // What the light may give to any point of the group at most, but for the normals.
                double margin = Group.Radius / distance;
                double emitted = margin - (Vector3D.Dot(lights.Normals[light], away) / distance);
                double received = Slack + margin + Math.Max(0.0, Vector3D.Dot(Group.MeanNormal, away) / distance);
                double nearest = Math.Max(distance - Group.Radius, reach);
                sum += emitted > 0.0 ? lights.Powers[light] * Math.Min(emitted, 1.0) * Math.Min(received, 1.0) / (nearest * nearest) : 0.0;
            }

            _hasNear |= distance < Group.Radius + (MarginOfReach * Group.MostReach);
            (closest, _nearest) = distance < closest ? (distance, light) : (closest, _nearest);
            _sums[i] = sum;
        }

        _total = sum;
    }

    /// <summary>Adds light of far or near ground to the points of the group.</summary>
    /// <param name="samples">Rays for each point.</param>
    /// <param name="isNear">Of near ground, or by how much that of far ground differs from what the group shares.</param>
    /// <param name="round">Tells rounds of samples apart.</param>
    /// <param name="found">Receives the light.</param>
    public void Add(int samples, bool isNear, long round, GatheredLight found)
    {
        if (isNear && _hasNear)
        {
            AddNear(samples, round, found);
        }
        else if (!isNear)
        {
            AddDifference(samples, round, found);
        }
    }

    /// <summary>Sends rays to near ground.</summary>
    private void AddNear(int samples, long round, GatheredLight found)
    {
        for (int receiver = 0; receiver < Group.Count; receiver++)
        {
            Clear(samples);
            SplitMix64 random = SplitMix64.For(0, purpose: 33, Group.Numbers[receiver], round);
            (double offset, double turn) = (random.NextUniform(), random.NextUniform());
            Vector3D up = Group.Facets[receiver];
            Vector3D right = Vector3D.Cross(Math.Abs(up.Z) < 0.9 ? Vector3D.UnitZ : Vector3D.UnitX, up).Normalized();
            Vector3D forward = Vector3D.Cross(up, right);
            for (int sample = 0; sample < samples; sample++)
            {
                // Elevations over the facet's plane grow with a square, because near ground mostly stands low over it.
                double u = (sample + offset) / samples;
                (double sine, double cosine) = Math.SinCos(0.5 * Math.PI * u * u);
                (double across, double along) = Math.SinCos(2.0 * Math.PI * (((sample * Golden) + turn) % 1.0));
                Vector3D direction = (cosine * along * right) + (cosine * across * forward) + (sine * up);
                AddNear(receiver, sample, direction, 2.0 * Math.PI * Math.PI * u * cosine / samples);
            }

            Collect(receiver, samples, found, isNear: true);
        }
    }

    private void AddNear(int receiver, int sample, Vector3D direction, double solidAngle)
    {
        Vector3D point = Group.Points[receiver];
        if (Faces(receiver, direction) && tree.FirstGround(point, direction, Group.Reaches[receiver]) is { } ground)
        {
            Vector3D met = point + (ground.Distance * direction);
            Vector3D toSun = lights.ToSun[_nearest];
            bool isLit = Vector3D.Dot(ground.Normal, toSun) > 0.0 && !tree.IsBlocked(met, toSun, point.Length);
            Add(receiver, sample, direction, new Place(met, ground.Normal, solidAngle), isLit ? toSun : null, _nearest);
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
