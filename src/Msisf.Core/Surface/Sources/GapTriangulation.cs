namespace Msisf.Core.Surface.Sources;

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
