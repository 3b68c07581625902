namespace Msisf.Core.Surface.Sources;

/// <summary>Keeps what fills the gaps between models, since finding it takes long. Safe for several threads.</summary>
public interface ISeamStore
{
    /// <summary>What was kept for a gap; null if there is none.</summary>
    /// <param name="productId">Name of the finest model at the gap.</param>
    /// <param name="border">Hash of the last border of the gap.</param>
    GapTriangulation? Find(string productId, string border);

    /// <summary>Keeps what fills a gap.</summary>
    void Keep(GapTriangulation filling);
}

/// <summary>The facets that fill one gap between models. They follow from the gap's borders alone.</summary>
/// <param name="ProductId">Name of the finest model at the gap.</param>
/// <param name="Borders">Hashes of the borders of the gap, SHA-256 in hexadecimal digits, in the order of the models.</param>
/// <param name="Corners">
/// Three corners for each facet, counter-clockwise seen from outside: numbers of vertices, those of the first border first.
/// </param>
public sealed record GapTriangulation(string ProductId, IReadOnlyList<string> Borders, int[] Corners)
{
    /// <summary>Hash of the last border, by which the filling is found.</summary>
    public string Key => Borders[^1];
}
