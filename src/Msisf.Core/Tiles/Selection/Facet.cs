using Msisf.Core.Numerics;

namespace Msisf.Core.Tiles.Selection;

/// <summary>A triangle of the mesh, counter-clockwise from outside.</summary>
/// <param name="A">m, MOON_ME.</param>
/// <param name="B">m, MOON_ME.</param>
/// <param name="C">m, MOON_ME.</param>
internal readonly record struct Facet(Vector3D A, Vector3D B, Vector3D C)
{
    /// <summary>Whether a point is certainly behind the facet's plane, wherever rounding puts the vertices.</summary>
    /// <param name="viewpoint">m, MOON_ME.</param>
    public bool TurnsAwayFrom(Vector3D viewpoint) => Side(viewpoint, out double margin) < -margin;

    /// <summary>Whether a point is certainly before the facet's plane; a facet without area faces all.</summary>
    /// <param name="viewpoint">m, MOON_ME.</param>
    public bool FacesCertainly(Vector3D viewpoint) => Side(viewpoint, out double margin) > margin || A == B || B == C || C == A;

    private double Side(Vector3D viewpoint, out double margin)
    {
        Vector3D u = B - A;
        Vector3D v = C - A;
        Vector3D toViewpoint = viewpoint - A;
        double side = Vector3D.Dot(Vector3D.Cross(u, v), toViewpoint);
        double reach = Math.Sqrt(toViewpoint.LengthSquared) + Math.Sqrt(u.LengthSquared) + Math.Sqrt(v.LengthSquared);
        margin = 2.0 * Tolerances.VertexLattice * (Math.Sqrt(u.LengthSquared) + Math.Sqrt(v.LengthSquared) + Tolerances.VertexLattice)
            * reach;
        return side;
    }
}
