using Msisf.Core.Surface;

namespace Msisf.Core.Certainty;

/// <summary>
/// All forms that a facet takes while its corners rise and fall within limits, each for itself. Seen from the body's centre it keeps its
/// outline, and a higher corner makes it higher in every direction: so all of them lie between the highest and the lowest one.
/// </summary>
internal sealed class FacetBand
{
    /// <summary>Part of a normal by which it may change at most: beyond, nothing is said of its direction.</summary>
    private const double GreatestChange = 0.5;

    private readonly Vector3D _besideAb;
    private readonly Vector3D _besideBc;
    private readonly Vector3D _besideCa;
    private readonly (Vector3D Normal, double Offset) _highest;
    private readonly (Vector3D Normal, double Offset) _lowest;

    private FacetBand(FacetId facet, (Vector3D A, Vector3D B, Vector3D C) corners, double reach)
    {
        (Vector3D a, Vector3D b, Vector3D c) = corners;
        Facet = facet;
        (_besideAb, _besideBc, _besideCa) = (
            Vector3D.Cross(a, b).Normalized(), Vector3D.Cross(b, c).Normalized(), Vector3D.Cross(c, a).Normalized());
        _highest = PlaneOf(corners, reach);
        _lowest = PlaneOf(corners, -reach);
        Vector3D normal = Vector3D.Cross(b - a, c - a);
        double length = normal.Length;
        Normal = normal / length;

        // N = a x b + b x c + c x a is linear in the height of each corner.
        (Vector3D upA, Vector3D upB, Vector3D upC) = (a.Normalized(), b.Normalized(), c.Normalized());
        (Vector3D byA, Vector3D byB, Vector3D byC) = (
            Vector3D.Cross(upA, b - c) / length, Vector3D.Cross(upB, c - a) / length, Vector3D.Cross(upC, a - b) / length);
        double both = reach * reach / length
            * (Vector3D.Cross(upA, upB).Length + Vector3D.Cross(upB, upC).Length + Vector3D.Cross(upC, upA).Length);
        double around = (b - a).Length + (c - b).Length + (a - c).Length + (6.0 * (reach + Tolerances.VertexLattice));
        double ofLattice = Tolerances.VertexLattice * around / length;
        double change = (reach * (byA.Length + byB.Length + byC.Length)) + both + ofLattice;

        // x + y with |y| <= e < 1, divided by its length, is x plus the part of y across it, and no more than this.
        double rest = change * change * ((0.5 / ((1.0 - change) * (1.0 - change))) + (1.0 / (1.0 - change)));
        Turns = (reach * Across(byA), reach * Across(byB), reach * Across(byC));
        Rest = change < GreatestChange ? rest + both + ofLattice : double.PositiveInfinity;
        Tilt = Turns.A.Length + Turns.B.Length + Turns.C.Length + Rest;

        Vector3D Across(Vector3D turn) => turn - (Vector3D.Dot(turn, Normal) * Normal);
    }

    /// <summary>Which facet it is.</summary>
    public FacetId Facet { get; }

    /// <summary>Outward normal of the facet as it is drawn, length 1.</summary>
    public Vector3D Normal { get; }

    /// <summary>By what the normal changes to first order where a corner rises as far as it may.</summary>
    public (Vector3D A, Vector3D B, Vector3D C) Turns { get; }

    /// <summary>Length of what the normal changes beside that, at most.</summary>
    public double Rest { get; }

    /// <summary>Length of the normal's whole change, at most.</summary>
    public double Tilt { get; }

    /// <summary>Takes a facet; null for one without area.</summary>
    /// <param name="corners">m, body-fixed, counter-clockwise seen from outside.</param>
    /// <param name="reach">m: by which each corner may be higher or lower.</param>
    public static FacetBand? Of(FacetId facet, (Vector3D A, Vector3D B, Vector3D C) corners, double reach)
    {
        Vector3D normal = Vector3D.Cross(corners.B - corners.A, corners.C - corners.A);
        return normal == default || Vector3D.Cross(corners.A, corners.B) == default || Vector3D.Cross(corners.B, corners.C) == default
            || Vector3D.Cross(corners.C, corners.A) == default
            ? null
            : new FacetBand(facet, corners, reach);
    }

    /// <summary>Where a ray of a beam can meet one of the forms, m along the beam; empty if its low end is above its high one.</summary>
    public Interval Met(in Beam beam, Interval within)
    {
        within = Seen(in beam, within);
        within = beam.Touching(within, -_highest.Normal, -_highest.Offset);
        return beam.Touching(within, _lowest.Normal, _lowest.Offset);
    }

    /// <summary>Where all rays of a beam are below all forms, as far as they are in the facet's directions at all.</summary>
    public Interval Below(in Beam beam, Interval within) =>
        beam.Inside(Seen(in beam, within), -_lowest.Normal, -_lowest.Offset);

    /// <summary>Whether the part of a ball that lies in the facet's directions is below all of its forms.</summary>
    public bool IsAbove(Vector3D centre, double radius) =>
        Vector3D.Dot(_besideAb, centre) < -radius || Vector3D.Dot(_besideBc, centre) < -radius || Vector3D.Dot(_besideCa, centre) < -radius
        || Vector3D.Dot(_lowest.Normal, centre) <= _lowest.Offset - radius;

    /// <summary>Whether one of the forms may face away from a direction.</summary>
    /// <param name="angle">rad, at least: by which the direction may turn.</param>
    public bool MayFaceAway(Vector3D direction, double angle) => !(Vector3D.Dot(Normal, direction) > Tilt + angle);

    private Interval Seen(in Beam beam, Interval within)
    {
        within = beam.Touching(within, _besideAb, 0.0);
        within = beam.Touching(within, _besideBc, 0.0);
        return beam.Touching(within, _besideCa, 0.0);
    }

    private static (Vector3D Normal, double Offset) PlaneOf((Vector3D A, Vector3D B, Vector3D C) corners, double raised)
    {
        (Vector3D a, Vector3D b, Vector3D c) = (Raised(corners.A), Raised(corners.B), Raised(corners.C));
        Vector3D normal = Vector3D.Cross(b - a, c - a).Normalized();
        return (normal, Vector3D.Dot(normal, a));

        Vector3D Raised(Vector3D corner) => (1.0 + (raised / corner.Length)) * corner;
    }
}
