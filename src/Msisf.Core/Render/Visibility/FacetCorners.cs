namespace Msisf.Core.Render.Visibility;

/// <summary>
/// Where the corners of a cell's facets are among the vertices of a <see cref="ProjectedBlock"/>, from its north-western one.
/// </summary>
internal static class FacetCorners
{
    /// <summary>To the cell's north-eastern vertex.</summary>
    public const int NorthEast = 1;

    /// <summary>To its south-western vertex.</summary>
    public const int SouthWest = ProjectedBlock.Stride;

    /// <summary>To its south-eastern vertex.</summary>
    public const int SouthEast = ProjectedBlock.Stride + 1;

    /// <summary>The bit of a cell's south-western facet, half 0.</summary>
    public const uint SouthWestHalf = 1;

    /// <summary>The bit of its north-eastern facet, half 1.</summary>
    public const uint NorthEastHalf = 2;

    /// <summary>To a facet's second corner; the first one is the north-western vertex.</summary>
    public static int Second(int half) => SouthWest + half;

    /// <summary>To its third corner.</summary>
    public static int Third(int half) => NorthEast + ((1 - half) * SouthWest);
}
