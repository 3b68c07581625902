using Msisf.Core.Ephemeris;
using Msisf.Core.Terrain;

namespace Msisf.Core.Orbit;

/// <summary>From a state vector to Kepler elements (thesis section 6.2.3); the way back is <see cref="KeplerOrbit.StateAt"/>.</summary>
/// <remarks>
/// Thesis eq. 6.12-6.22, with atan2 in place of each arccos (docs/deviations.md, rows 2 and 3). The angles are measured so that their
/// sums keep their digits where one alone is undefined: omega is the spacecraft's angle from the node minus its true anomaly, so for e
/// near 0 both may have any value, but the position is not affected.
/// </remarks>
public static class StateConversion
{
    /// <summary>The orbit through a state, in the same frame and at the same epoch.</summary>
    /// <param name="state">m and m/s, relative to the Moon's centre.</param>
    /// <returns>i in [0, pi]; omega, Omega and M0 in [-pi, pi], where a double has more digits than in [0, 2 pi).</returns>
    /// <exception cref="BadInputException">
    /// A component is not finite, position or velocity is zero, they are parallel, or the orbit is a parabola or hyperbola.
    /// </exception>
    public static KeplerElements ToElements(StateVector state)
    {
        double distance = LengthOf(state.Position, "position", "m");
        double speed = LengthOf(state.Velocity, "velocity", "m/s");

        double kineticRatio = distance * speed / MoonConstants.GravitationalParameter * speed;
        double distanceOverAxis = 2.0 - kineticRatio;
        if (distanceOverAxis <= 0.0)
        {
            double escapeSpeed = Math.Sqrt(2.0 * MoonConstants.GravitationalParameter / distance);
            string unit = speed / 1000.0 < escapeSpeed
                ? Invariant($" Velocities are in m/s: is {speed:R} mm/s, or km/s multiplied twice? Then write {speed / 1000.0:R}.")
                : string.Empty;
            throw new BadInputException(Invariant(
                $"The speed {speed:R} m/s is not below the escape speed, {escapeSpeed:R} m/s at {distance:R} m from the centre: "
                    + $"the orbit is a parabola or hyperbola; only ellipses can be followed.{unit}"));
        }

        double semiMajorAxis = distance / distanceOverAxis;
        Vector3D momentum = Vector3D.Cross(state.Position, state.Velocity);
        if (momentum.Length <= Tolerances.ParallelSine * distance * speed)
        {
            throw new BadInputException(
                "Position and velocity are parallel: the orbit is a straight line through the Moon's centre, not an ellipse; "
                    + "check their components.");
        }

        double axisSpeed = Math.Sqrt(MoonConstants.GravitationalParameter) / Math.Sqrt(semiMajorAxis);
        double radial = Vector3D.Dot(state.Position / semiMajorAxis, state.Velocity / axisSpeed);
        double eccentricity = double.Hypot(kineticRatio - 1.0, radial);
        if (eccentricity >= 1.0)
        {
            throw new BadInputException(
                "The eccentricity is 1 to the last digit: the orbit is a parabola or a straight line through the Moon's centre, "
                    + "not an ellipse; check position (m) and velocity (m/s).");
        }

        EccentricAnomaly anomaly = new(Trigonometry.Atan2(radial, kineticRatio - 1.0), eccentricity);
        OrbitPlane plane = OrbitPlane.WithNormal(momentum);
        double fromNode = plane.AngleFromNode(state.Position);
        bool isCircle = eccentricity == 0.0;
        return new KeplerElements(
            semiMajorAxis,
            eccentricity,
            argumentOfPeriapsis: isCircle ? 0.0 : AngleReduction.ToHalfTurn(fromNode - anomaly.TrueAnomaly),
            longitudeOfAscendingNode: plane.LongitudeOfAscendingNode,
            inclination: plane.Inclination,
            meanAnomalyAtEpoch: isCircle ? fromNode : anomaly.MeanAnomaly);
    }

    private static double LengthOf(Vector3D vector, string what, string unit)
    {
        double length = vector.Length;
        if (!double.IsFinite(length))
        {
            throw new BadInputException($"The {what} ({unit}) is not finite or too long; three finite numbers are needed.");
        }

        return length > 0.0 ? length : throw new BadInputException($"The {what} ({unit}) is zero; no orbit follows from it.");
    }
}

/// <summary>The plane of an orbit and the angles that place it; no angle loses digits near 0 or pi. <c>default</c> is not one.</summary>
internal readonly record struct OrbitPlane
{
    private readonly Vector3D _towardsNode;
    private readonly Vector3D _acrossNode;

    private OrbitPlane(Vector3D normal)
    {
        double horizontal = double.Hypot(normal.X, normal.Y);
        Inclination = Trigonometry.Atan2(horizontal, normal.Z);

        // An equatorial orbit, of either sense, has its node on the x axis by convention.
        _towardsNode = horizontal > 0.0 ? new Vector3D(-normal.Y / horizontal, normal.X / horizontal, 0.0) : Vector3D.UnitX;
        _acrossNode = Vector3D.Cross(normal.Normalized(), _towardsNode);
        LongitudeOfAscendingNode = Trigonometry.Atan2(_towardsNode.Y, _towardsNode.X);
    }

    /// <summary>i, rad, [0, pi].</summary>
    public double Inclination { get; }

    /// <summary>Omega, rad, [-pi, pi].</summary>
    public double LongitudeOfAscendingNode { get; }

    /// <summary>The plane whose motion is right-handed about <paramref name="normal"/>, e.g. the angular momentum; not zero.</summary>
    public static OrbitPlane WithNormal(Vector3D normal) => new(normal);

    /// <summary>The angle from the ascending node to a position in the plane, in the sense of the motion, rad, [-pi, pi].</summary>
    public double AngleFromNode(Vector3D position) =>
        Trigonometry.Atan2(Vector3D.Dot(position, _acrossNode), Vector3D.Dot(position, _towardsNode));
}
