namespace Msisf.Core.Render.Visibility;

/// <summary>
/// Index offsets from a cell's north-western vertex to the corners of its facets, in the arrays of a <see cref="ProjectedBlock"/>.
/// </summary>
internal static class FacetCorners
{
    /// <summary>Offset to the cell's north-eastern vertex.</summary>
    public const int NorthEast = 1;

    /// <summary>Offset to the cell's south-western vertex.</summary>
    public const int SouthWest = ProjectedBlock.Stride;

    /// <summary>Offset to the cell's south-eastern vertex.</summary>
    public const int SouthEast = ProjectedBlock.Stride + 1;

    /// <summary>The bit of a cell's south-western facet, half 0.</summary>
    public const uint SouthWestHalf = 1;

    /// <summary>The bit of a cell's north-eastern facet, half 1.</summary>
    public const uint NorthEastHalf = 2;

    /// <summary>Offset to a facet's second corner; the first corner is the north-western vertex.</summary>
    public static int Second(int half) => SouthWest + half;

    /// <summary>Offset to a facet's third corner.</summary>
    public static int Third(int half) => NorthEast + ((1 - half) * SouthWest);
}
