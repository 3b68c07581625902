using Msisf.Core.Render.Photometry;

namespace Msisf.Core.Render.Indirect;

/// <summary>How bright the points of the ground are that are not dark, as seen from a place. Keeps buffers for one thread.</summary>
/// <param name="lights">The points.</param>
/// <param name="law">The reflectance law, by which they are bright, roughly if it differs from place to place.</param>
internal sealed class LightPowers(GroundLights lights, IReflectance law)
{
    /// <summary>Least cosine of an emission angle: near the place others may see a point that it does not see.</summary>
    private const double LeastEmission = 0.02;

    /// <summary>Cosine of a typical angle to light or view, for light that ground throws on ground.</summary>
    private const double Typical = 0.5;

    private readonly double[] _incidence = new double[lights.Bright.Length];
    private readonly double[] _emission = new double[lights.Bright.Length];
    private readonly double[] _phases = new double[lights.Bright.Length];
    private readonly double[] _factors = new double[lights.Bright.Length];

    /// <summary>Finds how bright the points are towards a place.</summary>
    /// <param name="place">m, body-fixed.</param>
    /// <returns>
    /// Brightness times area of each point, m^2, over the Sun's irradiance. There are <see cref="BrightLights.PaddedLength"/> elements, the
    /// last ones 0.
    /// </returns>
    public float[] Towards(Vector3D place)
    {
        for (int i = 0; i < _incidence.Length; i++)
        {
            int light = lights.Bright[i];
            Vector3D away = place - lights.Points[light];
            away *= 1.0 / Math.Sqrt(away.LengthSquared);
            _incidence[i] = Math.Clamp(Vector3D.Dot(lights.Normals[light], lights.ToSun[light]), 0.0, 1.0);
            _emission[i] = Math.Clamp(Vector3D.Dot(lights.Normals[light], away), LeastEmission, 1.0);
            _phases[i] = Math.Min(1.0, 0.25 * (lights.ToSun[light] - away).LengthSquared);
        }

        law.RadianceFactors(_incidence, _emission, _phases, _factors);
        double ofGround = law.RadianceFactor(Typical, Typical, Typical);
        float[] powers = new float[lights.Bright.PaddedLength];
        for (int i = 0; i < _incidence.Length; i++)
        {
            int light = lights.Bright[i];
            double brightness = (lights.FromSun[light] * _factors[i]) + (lights.FromGround[light] * ofGround);
            powers[i] = (float)(lights.Areas[light] * lights.Scales[light] * brightness);
        }

        return powers;
    }
}
