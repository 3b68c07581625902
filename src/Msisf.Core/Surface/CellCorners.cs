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
}
