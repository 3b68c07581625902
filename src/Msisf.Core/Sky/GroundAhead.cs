namespace Msisf.Core.Sky;

/// <summary>How fast ground that may hide a direction of the sky moves over it while the camera flies.</summary>
internal static class GroundAhead
{
    /// <summary>m: nearer ground counts as this far away, so that the time of a camera between mountains stays bounded.</summary>
    private const double Nearest = 1000.0;

    /// <summary>rad/s: an upper bound of the rate; 0 where no ground can come in front of the direction.</summary>
    /// <param name="position">m, body-fixed: where the camera is in the middle of the time.</param>
    /// <param name="velocity">m/s, body-fixed.</param>
    /// <param name="span">s: the time.</param>
    /// <param name="direction">Middle of a circle of the sky, length 1, body-fixed.</param>
    /// <param name="radius">Angular radius of the circle, rad; 0 for a direction alone.</param>
    /// <param name="highest">m: no ground is farther from the body's centre.</param>
    public static double Rate(Vector3D position, Vector3D velocity, double span, Vector3D direction, double radius, double highest)
    {
        double speed = velocity.Length;
        double way = 0.5 * speed * span;
        double distance = position.Length;
        if (distance <= highest + way)
        {
            return speed / Nearest;
        }

        double aside = Math.Max(0.0, Vector3D.AngleBetween(-position, direction) - radius);
        double nearestApproach = distance * Trigonometry.Sin(Math.Min(aside, 0.5 * Math.PI)) - way;
        if (nearestApproach > highest)
        {
            return 0.0;
        }

        // A ray enters the sphere of the highest ground half a chord before it comes nearest to the centre.
        double halfChord = Math.Sqrt((highest - nearestApproach) * (highest + nearestApproach));
        double toGround = (distance * Trigonometry.Cos(aside)) - halfChord - way;
        return speed / Math.Max(Nearest, toGround);
    }
}
