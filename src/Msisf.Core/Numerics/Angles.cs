namespace Msisf.Core.Numerics;

/// <summary>Angles on a full turn that starts at 0.</summary>
public static class Angles
{
    /// <summary>An angle of <see cref="Math.Atan2"/> on the turn [0, 2 pi); never -0.</summary>
    /// <param name="angle">rad, [-pi, pi].</param>
    public static double OnFullTurn(double angle)
    {
        double turned = angle < 0.0 ? angle + (2.0 * Math.PI) : angle;

        // A tiny negative angle rounds to 2 pi, which is 0; adding 0 makes -0 a 0.
        return turned >= 2.0 * Math.PI ? 0.0 : turned + 0.0;
    }
}
