namespace Msisf.Core.Orbit;

/// <summary>The plane of an orbit and the angles that place it; no angle loses digits near 0 or pi. <c>default</c> is no plane.</summary>
internal readonly record struct OrbitPlane
{
    private readonly Vector3D _towardsNode;
    private readonly Vector3D _acrossNode;

    private OrbitPlane(Vector3D normal)
    {
        double horizontal = double.Hypot(normal.X, normal.Y);
        Inclination = Math.Atan2(horizontal, normal.Z);

        // An equatorial orbit, of either sense, has its node on the x axis by convention.
        _towardsNode = horizontal > 0.0 ? new Vector3D(-normal.Y / horizontal, normal.X / horizontal, 0.0) : Vector3D.UnitX;
        _acrossNode = Vector3D.Cross(normal.Normalized(), _towardsNode);
        LongitudeOfAscendingNode = Math.Atan2(_towardsNode.Y, _towardsNode.X);
    }

    /// <summary>i, rad, [0, pi].</summary>
    public double Inclination { get; }

    /// <summary>Omega, rad, [-pi, pi].</summary>
    public double LongitudeOfAscendingNode { get; }

    /// <summary>The plane whose motion is right-handed about <paramref name="normal"/>, e.g. the angular momentum; not zero.</summary>
    public static OrbitPlane WithNormal(Vector3D normal) => new(normal);

    /// <summary>The angle from the ascending node to a position in the plane, in the sense of the motion, rad, [-pi, pi].</summary>
    public double AngleFromNode(Vector3D position) =>
        Math.Atan2(Vector3D.Dot(position, _acrossNode), Vector3D.Dot(position, _towardsNode));
}
