using Msisf.Core.Numerics;
using Msisf.Core.Surface;

namespace Msisf.Core.Tiles.Selection;

/// <summary>A triangle of the mesh, counter-clockwise from outside; corners in m, MOON_ME.</summary>
internal readonly record struct Facet(Vector3D A, Vector3D B, Vector3D C)
{
    /// <summary>The two facets of a cell of a patch.</summary>
    public static (Facet SouthWest, Facet NorthEast) OfCell(TerrainPatch patch, int line, int sample)
    {
        (Vector3D northWest, Vector3D southEast) = (patch[line, sample], patch[line + 1, sample + 1]);
        return (new Facet(northWest, patch[line + 1, sample], southEast), new Facet(northWest, southEast, patch[line, sample + 1]));
    }

    /// <summary>Whether a point (m, MOON_ME) is certainly behind the facet's plane, wherever rounding puts the vertices.</summary>
    public bool TurnsAwayFrom(Vector3D viewpoint) => Side(viewpoint, out double margin) < -margin;

    /// <summary>Whether a point (m, MOON_ME) is certainly before the facet's plane; a facet without area faces all.</summary>
    public bool FacesCertainly(Vector3D viewpoint) => Side(viewpoint, out double margin) > margin || A == B || B == C || C == A;

    private double Side(Vector3D viewpoint, out double margin)
    {
        (Vector3D u, Vector3D v, Vector3D toViewpoint) = (B - A, C - A, viewpoint - A);
        double sides = Math.Sqrt(u.LengthSquared) + Math.Sqrt(v.LengthSquared);
        double reach = Math.Sqrt(toViewpoint.LengthSquared) + Math.Sqrt(u.LengthSquared) + Math.Sqrt(v.LengthSquared);
        margin = 2.0 * Tolerances.VertexLattice * (sides + Tolerances.VertexLattice) * reach;
        return Vector3D.Dot(Vector3D.Cross(u, v), toViewpoint);
    }
}
