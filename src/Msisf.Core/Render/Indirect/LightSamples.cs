using Msisf.Core.Camera;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Render.Shading;
using Msisf.Core.Surface;

namespace Msisf.Core.Render.Indirect;

/// <summary>
/// Samples of the light that places of the ground throw on a point, with the frame's law at both ends. Keeps buffers, so each thread needs
/// its own object.
/// </summary>
/// <param name="surface">The surface.</param>
/// <param name="camera">The camera, by whose pixels maps are read.</param>
/// <param name="options">The settings of the renderer.</param>
internal sealed class LightSamples(SurfaceModel surface, FrameCamera camera, NativeRenderOptions options)
{
    private readonly RowReflection _reflection = new(surface);
    private readonly SunlitPoints _targets = new();
    private double[] _values = [];
    private int _samples;

    private SunlitPoints Sources => _reflection.Points;

    /// <summary>Forgets all samples.</summary>
    /// <param name="samples">How many will be added, those without light too.</param>
    public void Clear(int samples)
    {
        if (_values.Length < samples)
        {
            _values = new double[samples];
        }

        _samples = samples;
        Sources.Clear(2 * samples);
        _targets.Clear(2 * samples);
        _values.AsSpan(0, samples).Clear();
    }

    /// <summary>Adds the light of a place: the Sun's, and the ground's own.</summary>
    /// <param name="group">The group.</param>
    /// <param name="receiver">The point of it that gets the light.</param>
    /// <param name="sample">Number of the sample.</param>
    /// <param name="direction">Direction from the point to the place, length 1.</param>
    /// <param name="place">The place.</param>
    /// <param name="lights">Points of the ground.</param>
    /// <param name="light">The point among them that is the place, or near it: what light the place has.</param>
    /// <param name="fromSun">Sunlight on the place, over what comes from there if nothing hides the Sun.</param>
    public void Add(
        Receivers group, int receiver, int sample, Vector3D direction, LitPlace place, GroundLights lights, int light, double fromSun)
    {
        if (fromSun > 0.0)
        {
            Add(group, receiver, sample, direction, place, lights.ToSun[light], fromSun);
        }

        if (lights.FromGround[light] > 0.0)
        {
            Add(group, receiver, sample, direction, place, lights.ToGround[light], lights.FromGround[light]);
        }
    }

    /// <summary>Takes the laws of both reflections, and sums up the samples of a point.</summary>
    /// <param name="receiver">The point.</param>
    /// <param name="found">Receives the sum.</param>
    /// <param name="hasMap">Whether the weights of the places count what the map says; otherwise it is looked up.</param>
    public void SumUp(int receiver, GatheredLight found, bool hasMap)
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

        if (!hasMap)
        {
            _reflection.FindScales(camera, options);
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

        (double sum, double steps, double squares, double sizes) = (0.0, 0.0, 0.0, 0.0);
        for (int sample = 0; sample < _samples; sample++)
        {
            double value = _values[sample];
            double step = value - _values[(sample + 1) % _samples];
            (sum, steps, squares, sizes) = (sum + value, steps + (step * step), squares + (value * value), sizes + Math.Abs(value));
        }

        found.Values[receiver] += sum;
        found.Variance += 0.5 * steps;
        found.Bound += ((sizes * sizes) - squares) * _samples / Math.Max(1, _samples - 1);
    }

    private void Add(
        Receivers group, int receiver, int sample, Vector3D direction, LitPlace place, Vector3D toLight, double strength)
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
            sample, 0.0, group.Points[receiver], direction, Math.Min(1.0, Vector3D.Dot(group.Normals[receiver], direction)));
        _targets.CosEmission[i] = Math.Min(1.0, Vector3D.Dot(group.Normals[receiver], group.ToCamera[receiver]));
        _targets.PhaseHaversine[i] = Haversine(direction, group.ToCamera[receiver]);
    }

    private static double Haversine(Vector3D one, Vector3D other) => Math.Min(1.0, 0.25 * (one - other).LengthSquared);
}

/// <summary>A place that light comes from.</summary>
/// <param name="Point">m, body-fixed.</param>
/// <param name="Normal">Normal of its facet, length 1.</param>
/// <param name="Weight">How its brightness counts: the solid angle for which it is, sr, and more.</param>
internal readonly record struct LitPlace(Vector3D Point, Vector3D Normal, double Weight);
