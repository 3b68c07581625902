namespace Msisf.Core.Surface;

/// <summary>The four vertices of a cell, m, body-fixed; two of them coincide on the polar side of a fan.</summary>
/// <param name="NorthWest">m.</param>
/// <param name="NorthEast">m.</param>
/// <param name="SouthWest">m.</param>
/// <param name="SouthEast">m.</param>
internal readonly record struct CellCorners(Vector3D NorthWest, Vector3D NorthEast, Vector3D SouthWest, Vector3D SouthEast)
{
    /// <summary>The corners of one of the two facets, counter-clockwise seen from outside.</summary>
    public (Vector3D A, Vector3D B, Vector3D C) Facet(FacetHalf half) => half == FacetHalf.SouthWest
        ? (NorthWest, SouthWest, SouthEast)
        : (NorthWest, SouthEast, NorthEast);

    /// <summary>Outward normal of a facet; its length grows with the facet's area and is zero if it has no area.</summary>
    /// <remarks>The corners are multiples of 2^-7 m and the edges are short, so the products are exact.</remarks>
    public Vector3D NormalOf(FacetHalf half)
    {
        (Vector3D a, Vector3D b, Vector3D c) = Facet(half);
        return Vector3D.Cross(b - a, c - a);
    }
}
