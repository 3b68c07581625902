namespace Msisf.Core.Surface;

/// <summary>
/// A plane through the Moon's centre beside a rectangle of the polar stereographic plane, as an inward normal that is at most 1.5 long.
/// </summary>
/// <remarks>
/// In units of 2 R the direction of (u, v) is (2 v, 2 u, +-(1 - u u - v v)) / (1 + u u + v v), and a plane through the centre is a circle.
/// With f(u, v) = -2 c S v + 2 u (1 + P - c c) - 2 c (1 - u u - v v) the line u = c has f = 2 c (v v - S v + P): with S = v0 + v1 and
/// P = v0 v1 the circle passes through the line's points v0 and v1, and with S = 2 m and P = m m it touches the line in v = m. So for one
/// sign of c the first, for the other the second has the whole side from v0 to v1 on one side of it. f grows with u, because its
/// derivative 2 (1 + P - c c) + 4 c u is not below 0 for numbers up to 1/2 (<see cref="Terrain.PolarStereographic.MaxExtent"/>): so the
/// whole rectangle is on that side.
/// </remarks>
/// <param name="Across">Component along the axis on which u lies.</param>
/// <param name="Along">Component along the axis on which v lies.</param>
/// <param name="Up">Component along the axis of the map's pole.</param>
internal readonly record struct PlaneBorder(double Across, double Along, double Up)
{
    /// <summary>A border of a rectangle with u from <paramref name="c"/> on.</summary>
    /// <param name="c">u of the side, in 2 R.</param>
    /// <param name="v0">One end of the side.</param>
    /// <param name="v1">The other end.</param>
    public static PlaneBorder Below(double c, double v0, double v1) => c < 0.0 ? Chord(c, v0, v1) : Tangent(c, v0, v1);

    /// <summary>A border of a rectangle with u up to <paramref name="c"/>; parameters as of <see cref="Below"/>.</summary>
    public static PlaneBorder Above(double c, double v0, double v1)
    {
        (double across, double along, double up) = c < 0.0 ? Tangent(c, v0, v1) : Chord(c, v0, v1);
        return new PlaneBorder(-across, -along, -up);
    }

    private static PlaneBorder Chord(double c, double v0, double v1) => Of(c, v0 + v1, v0 * v1);

    private static PlaneBorder Tangent(double c, double v0, double v1)
    {
        double middle = 0.5 * (v0 + v1);
        return Of(c, 2.0 * middle, middle * middle);
    }

    private static PlaneBorder Of(double c, double sum, double product) => new(1.0 + product - (c * c), -c * sum, -2.0 * c);
}
