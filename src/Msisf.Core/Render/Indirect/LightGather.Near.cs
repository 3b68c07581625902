using Msisf.Core.Numerics;

namespace Msisf.Core.Render.Indirect;

/// <content>Near ground.</content>
internal sealed partial class LightGather
{
    /// <summary>Part of the rays that look where near ground was found before.</summary>
    private const double PartOfLow = 0.75;

    /// <summary>Adds the light of near ground to the points of the group.</summary>
    /// <param name="samples">Rays for each point.</param>
    /// <param name="top">rad over the facet: how far up near ground was found; 0 if that is not known.</param>
    /// <param name="round">Tells rounds of samples apart.</param>
    /// <param name="found">Receives the light.</param>
    public void AddNear(int samples, double top, long round, GatheredLight found)
    {
        int low = top > 0.0 ? (int)(PartOfLow * samples) : 0;
        for (int receiver = 0; _hasNear && receiver < Group.Count; receiver++)
        {
            Clear(samples);
            SplitMix64 random = SplitMix64.For(0, purpose: 33, Group.Numbers[receiver], round);
            int count = 0;
            if (low > 0)
            {
                // As often as light from there counts: elevations grow with a root.
                Look(receiver, low, v => (top * Math.Sqrt(v), 0.5 * top / Math.Sqrt(v)), ref count, ref random, found);
            }

            // Elevations grow with a square, because near ground mostly stands low.
            double span = (0.5 * Math.PI) - top;
            Look(receiver, samples - low, v => (top + (span * v * v), 2.0 * span * v), ref count, ref random, found);
            Collect(receiver, count, found, isNear: true);
        }
    }

    /// <summary>Sends rays, one into each part of rings round the zenith. Those that follow each other are neighbours.</summary>
    /// <param name="receiver">From which point.</param>
    /// <param name="samples">How many, or a few less.</param>
    /// <param name="elevation">Elevation, rad, and its slope, of a number between 0 and 1.</param>
    /// <param name="count">Number of rays so far.</param>
    /// <param name="random">Tells the places in the parts.</param>
    /// <param name="found">Receives how high ground was met.</param>
    private void Look(
        int receiver, int samples, Func<double, (double Angle, double Slope)> elevation, ref int count, ref SplitMix64 random,
        GatheredLight found)
    {
        int rings = Math.Max(1, (int)(0.5 * Math.Sqrt(samples)));
        int parts = samples / rings;
        Vector3D up = Group.Facets[receiver];
        Vector3D right = Vector3D.Cross(Math.Abs(up.Z) < 0.9 ? Vector3D.UnitZ : Vector3D.UnitX, up).Normalized();
        Vector3D forward = Vector3D.Cross(up, right);
        for (int part = 0; part < rings * parts; part++)
        {
            (double angle, double slope) = elevation(((part / parts) + random.NextUniform()) / rings);
            (double sine, double cosine) = Math.SinCos(angle);
            (double across, double along) = Math.SinCos(2.0 * Math.PI * ((part % parts) + random.NextUniform()) / parts);
            Vector3D direction = (cosine * along * right) + (cosine * across * forward) + (sine * up);
            if (AddNear(receiver, count++, direction, 2.0 * Math.PI * slope * cosine / (rings * parts)))
            {
                found.Top = Math.Max(found.Top, angle);
            }
        }
    }

    /// <summary>Adds what a ray meets; false if that is no near ground.</summary>
    private bool AddNear(int receiver, int sample, Vector3D direction, double solidAngle)
    {
        Vector3D point = Group.Points[receiver];
        if (!Faces(receiver, direction) || tree.FirstGround(point, direction, Group.Reaches[receiver]) is not { } ground)
        {
            return false;
        }

        Vector3D met = point + (ground.Distance * direction);
        Vector3D toSun = lights.ToSun[_nearest];
        bool isLit = Vector3D.Dot(ground.Normal, toSun) > 0.0 && !tree.IsBlocked(met, toSun, point.Length);
        Add(receiver, sample, direction, new Place(met, ground.Normal, solidAngle), isLit ? toSun : null, _nearest);
        return true;
    }
}
