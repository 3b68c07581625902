using Msisf.Core.Numerics;
using Msisf.Core.Surface;

namespace Msisf.Core.Sensitivity;

/// <summary>A facet that hides the Sun from others, seen along the Sun's rays.</summary>
/// <param name="facet">The facet.</param>
/// <param name="corners">m, body-fixed.</param>
internal sealed class Caster(FacetId facet, (Vector3D A, Vector3D B, Vector3D C) corners)
{
    /// <summary>The facet.</summary>
    public FacetId Facet { get; } = facet;

    /// <summary>m: its longest edge.</summary>
    public double Width { get; } = Math.Sqrt(Math.Max(
        (corners.B - corners.A).LengthSquared,
        Math.Max((corners.C - corners.A).LengthSquared, (corners.C - corners.B).LengthSquared)));

    /// <summary>Edges behind which the ground is known to be lit: AB, BC and CA.</summary>
    public bool[] EndsAt { get; } = new bool[3];

    /// <summary>m, body-fixed: an edge, 0 for AB, 1 for BC, 2 for CA.</summary>
    public Vector3D EdgeOf(int index) => index switch
    {
        0 => corners.B - corners.A,
        1 => corners.C - corners.B,
        _ => corners.A - corners.C,
    };

    /// <summary>Whether the ray from a point to the Sun meets the facet.</summary>
    public bool Hides(Vector3D point, Vector3D toSun)
    {
        (Vector3D a, Vector3D b, Vector3D c) = (corners.A - point, corners.B - point, corners.C - point);
        double ab = Vector3D.Dot(Times(a, b), toSun);
        double bc = Vector3D.Dot(Times(b, c), toSun);
        double ca = Vector3D.Dot(Times(c, a), toSun);
        bool isInside = (ab > 0.0 && bc > 0.0 && ca > 0.0) || (ab < 0.0 && bc < 0.0 && ca < 0.0);
        return isInside && Vector3D.Dot((bc * a) + (ca * b) + (ab * c), toSun) / (ab + bc + ca) > 0.0;
    }

    /// <summary>Finds where a way, seen along the Sun's rays, leaves the facet.</summary>
    /// <param name="start">Where the way begins, m.</param>
    /// <param name="toSun">Length 1.</param>
    /// <param name="way">From its start to its end, m.</param>
    /// <param name="part">The part of the way from which on it is on the facet; receives that at which it leaves it.</param>
    /// <param name="edge">Receives the edge: 0 for AB, 1 for BC, 2 for CA.</param>
    /// <param name="height">m: how far the edge is from the way there, towards the Sun.</param>
    /// <returns>False if the way ends before that.</returns>
    public bool TryLeave(Vector3D start, Vector3D toSun, Vector3D way, ref double part, out int edge, out double height)
    {
        (Vector3D a, Vector3D b, Vector3D c) = (corners.A - start, corners.B - start, corners.C - start);
        double area = Vector3D.Dot(Times(b - a, c - a), toSun);
        double nearest = double.PositiveInfinity;
        (edge, height) = (-1, 0.0);
        for (int i = 0; i < 3; i++)
        {
            (Vector3D from, Vector3D to) = i switch
            {
                0 => (a, b),
                1 => (b, c),
                _ => (c, a),
            };

            // The weight of the opposite corner falls to 0 at the edge.
            double weight = Vector3D.Dot(Times(from, to), toSun) / area;
            double slope = Vector3D.Dot(Times(way, to - from), toSun) / area;
            double leaves = weight / slope;
            if (slope > 0.0 && leaves < nearest)
            {
                (nearest, edge) = (leaves, i);
                Vector3D there = leaves * way;
                Vector3D along = to - from;
                Vector3D across = along - (Vector3D.Dot(along, toSun) * toSun);
                double along01 = Vector3D.Dot(there - from, across) / across.LengthSquared;
                height = Vector3D.Dot(from + (along01 * along) - there, toSun);
            }
        }

        if (!(nearest <= 1.0))
        {
            return false;
        }

        part = Math.Max(part, nearest);
        return true;
    }

    private static Vector3D Times(Vector3D u, Vector3D v) =>
        new((u.Y * v.Z) - (u.Z * v.Y), (u.Z * v.X) - (u.X * v.Z), (u.X * v.Y) - (u.Y * v.X));
}
