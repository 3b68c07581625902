namespace Msisf.Core.Render.Indirect;

/// <summary>The light of near ground on the points of a group, by rays of each point.</summary>
/// <param name="tree">The ground.</param>
/// <param name="lights">The points that stand for it.</param>
/// <param name="sight">The group.</param>
/// <param name="samples">Receives the rays.</param>
internal sealed class NearLight(GroundTree tree, GroundLights lights, GroupSight sight, LightSamples samples)
{
    /// <summary>Part of the rays that look where near ground was found before.</summary>
    private const double PartOfLow = 0.75;

    /// <summary>Adds the light to the points.</summary>
    /// <param name="rays">For each point, or a few less.</param>
    /// <param name="top">rad over the facet: how far up near ground was found; 0 if that is not known.</param>
    /// <param name="nearest">The light nearest to the group.</param>
    /// <param name="round">Tells rounds of samples apart.</param>
    /// <param name="found">Receives the light.</param>
    public void Add(int rays, double top, int nearest, long round, GatheredLight found)
    {
        int low = top > 0.0 ? (int)(PartOfLow * rays) : 0;
        for (int receiver = 0; receiver < sight.Group.Count; receiver++)
        {
            samples.Clear(rays);
            SplitMix64 random = SplitMix64.For(0, purpose: 33, sight.Group.Numbers[receiver], round);
            int count = 0;
            if (low > 0)
            {
                // As often as light from there counts: elevations grow with a root.
                Look(receiver, low, v => (top * Math.Sqrt(v), 0.5 * top / Math.Sqrt(v)), nearest, ref count, ref random, found);
            }

            // Elevations grow with a square, because near ground is mostly low.
            double span = (0.5 * Math.PI) - top;
            Look(receiver, rays - low, v => (top + (span * v * v), 2.0 * span * v), nearest, ref count, ref random, found);
            samples.SumUp(receiver, found, hasMap: false);
        }
    }

    /// <summary>Sends rays, one into each part of rings round the zenith. Those that follow each other are neighbours.</summary>
    /// <param name="receiver">From which point.</param>
    /// <param name="rays">How many, or a few less.</param>
    /// <param name="elevation">Elevation, rad, and its slope, of a number between 0 and 1.</param>
    /// <param name="nearest">The light nearest to the group.</param>
    /// <param name="count">Number of rays so far.</param>
    /// <param name="random">Tells the places in the parts.</param>
    /// <param name="found">Receives how high ground was met.</param>
    private void Look(
        int receiver, int rays, Func<double, (double Angle, double Slope)> elevation, int nearest, ref int count, ref SplitMix64 random,
        GatheredLight found)
    {
        int rings = Math.Max(1, (int)(0.5 * Math.Sqrt(rays)));
        int parts = rays / rings;
        Vector3D up = sight.Group.Facets[receiver];
        Vector3D right = Vector3D.Cross(Math.Abs(up.Z) < 0.9 ? Vector3D.UnitZ : Vector3D.UnitX, up).Normalized();
        Vector3D forward = Vector3D.Cross(up, right);
        for (int part = 0; part < rings * parts; part++)
        {
            (double angle, double slope) = elevation(((part / parts) + random.NextUniform()) / rings);
            (double sine, double cosine) = Math.SinCos(angle);
            (double across, double along) = Math.SinCos(2.0 * Math.PI * ((part % parts) + random.NextUniform()) / parts);
            Vector3D direction = (cosine * along * right) + (cosine * across * forward) + (sine * up);
            if (Meets(receiver, count++, direction, 2.0 * Math.PI * slope * cosine / (rings * parts), nearest))
            {
                found.Top = Math.Max(found.Top, angle);
            }
        }
    }

    /// <summary>Adds what a ray meets; false if that is not near ground.</summary>
    private bool Meets(int receiver, int ray, Vector3D direction, double solidAngle, int nearest)
    {
        Vector3D point = sight.Group.Points[receiver];
        if (!sight.Faces(receiver, direction)
            || tree.FirstGround(point, direction, sight.Group.Reaches[receiver]) is not { } ground)
        {
            return false;
        }

        Vector3D met = point + (ground.Distance * direction);
        Vector3D toSun = lights.ToSun[nearest];
        bool isLit = Vector3D.Dot(ground.Normal, toSun) > 0.0 && !tree.IsBlocked(met, toSun, point.Length);
        samples.Add(
            sight.Group, receiver, ray, direction, new LitPlace(met, ground.Normal, solidAngle), lights, nearest, isLit ? 1.0 : 0.0);
        return true;
    }
}
