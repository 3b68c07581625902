namespace Msisf.Core.Tiles;

/// <summary>
/// Which samples the mesh of a tile or a part of it joins and in which order; <c>default</c> is not a layout: use
/// <see cref="For(TileId, int, int)"/>. Vertices: the north pole, if the mesh reaches it; then the samples line by line from the north,
/// each from the west; then the south pole. A cell of four samples belongs to the tile (and the part) that holds its north-west sample,
/// so each cell of the Moon belongs to exactly one tile.
/// </summary>
/// <param name="PixelsPerDegree">Resolution of the grid.</param>
/// <param name="MarginSamples">Rings of cells around the tile that are added (overlapping with its neighbours); usually 0.</param>
/// <param name="FirstLine">Northernmost line of the grid.</param>
/// <param name="FirstSample">Westernmost sample of the grid, in [0, 360 res).</param>
/// <param name="Samples">Number of samples of a line; they continue across the prime meridian.</param>
public readonly record struct TileMeshLayout(
    SurfacePart Part, int PixelsPerDegree, int MarginSamples, int FirstLine, int Lines, int FirstSample, int Samples)
{
    /// <summary>Whether the mesh ends in a fan around the north pole.</summary>
    public bool HasNorthPole => FirstLine == 0;

    /// <summary>Whether the mesh ends in a fan around the south pole.</summary>
    public bool HasSouthPole => FirstLine + Lines == 180 * PixelsPerDegree;

    /// <summary>
    /// Whether the part has a skirt that reaches below the lowest ground of the Moon. Parts of coarser levels have one: where levels
    /// meet, their surfaces differ, and the skirt closes the gap to all rays.
    /// </summary>
    public bool HasSkirt => Part.Level > 0;

    /// <summary>Vertices of samples and poles.</summary>
    public int VertexCount => (Lines * Samples) + (HasNorthPole ? 1 : 0) + (HasSouthPole ? 1 : 0);

    /// <summary>Triangles.</summary>
    public int FaceCount => (Samples - 1) * ((2 * (Lines - 1)) + (HasNorthPole ? 1 : 0) + (HasSouthPole ? 1 : 0));

    /// <summary>The layout of a tile.</summary>
    /// <param name="pixelsPerDegree">Samples a degree, at least 1.</param>
    /// <param name="marginSamples">Rings of cells to add, 0 to the samples of a degree; rings beyond a pole are left out.</param>
    public static TileMeshLayout For(TileId tile, int pixelsPerDegree, int marginSamples = 0)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(pixelsPerDegree, 1);
        ArgumentOutOfRangeException.ThrowIfNegative(marginSamples);
        ArgumentOutOfRangeException.ThrowIfGreaterThan(marginSamples, pixelsPerDegree);
        return Around(SurfacePart.Whole(tile), pixelsPerDegree, marginSamples, marginSamples, marginSamples);
    }

    /// <summary>
    /// The layout of a part. The cells of a coarser level lie half a cell farther to the south and east than the tile's borders: such a
    /// part has one more ring of cells in the north and west, so that it covers at least the area of the parts of any other level in its
    /// place.
    /// </summary>
    /// <param name="modelPixelsPerDegree">Samples a degree of the model itself, level 0.</param>
    public static TileMeshLayout For(SurfacePart part, int modelPixelsPerDegree)
    {
        return Around(part, modelPixelsPerDegree >> part.Level, marginSamples: 0, ringsBefore: part.Level > 0 ? 1 : 0, ringsAfter: 0);
    }

    /// <summary>
    /// The triangles, three vertex numbers each, counter-clockwise seen from outside: the north fan (pole, SW, SE); for each
    /// cell, line by line, (NW, SW, SE) and (NW, SE, NE), so that the diagonal runs from north-west to south-east; the south
    /// fan (NW, pole, NE).
    /// </summary>
    public int[] CreateFaces()
    {
        int[] faces = new int[3 * FaceCount];
        int next = 0;
        int firstRow = HasNorthPole ? 1 : 0;
        if (HasNorthPole)
        {
            for (int column = 0; column < Samples - 1; column++)
            {
                next = Add(faces, next, 0, firstRow + column, firstRow + column + 1);
            }
        }

        for (int northWest = firstRow; northWest < firstRow + ((Lines - 1) * Samples); northWest++)
        {
            if ((northWest - firstRow) % Samples < Samples - 1)
            {
                int southWest = northWest + Samples;
                next = Add(faces, next, northWest, southWest, southWest + 1);
                next = Add(faces, next, northWest, southWest + 1, northWest + 1);
            }
        }

        if (HasSouthPole)
        {
            int southPole = VertexCount - 1;
            for (int northWest = southPole - Samples; northWest < southPole - 1; northWest++)
            {
                next = Add(faces, next, northWest, southPole, northWest + 1);
            }
        }

        return faces;
    }

    /// <summary>
    /// The part's cells with some rings of cells before them (north and west) and after them; rings beyond a pole are left out.
    /// </summary>
    private static TileMeshLayout Around(SurfacePart part, int pixelsPerDegree, int marginSamples, int ringsBefore, int ringsAfter)
    {
        int cells = TileId.SizeDegrees * pixelsPerDegree / part.Subdivisions;
        int allSamples = 360 * pixelsPerDegree;
        int start = part.Tile.FirstLine(pixelsPerDegree) + (part.Row * cells);

        // One line and one sample more than cells: the south-east corners of the last ones lie in the next part.
        int firstLine = Math.Max(start - ringsBefore, 0);
        int endLine = Math.Min(start + cells + ringsAfter + 1, 180 * pixelsPerDegree);
        int firstSample = (part.Tile.FirstSample(pixelsPerDegree) + (part.Column * cells) - ringsBefore + allSamples) % allSamples;
        return new TileMeshLayout(
            part, pixelsPerDegree, marginSamples, firstLine, endLine - firstLine, firstSample, ringsBefore + cells + ringsAfter + 1);
    }

    private static int Add(int[] faces, int next, int a, int b, int c)
    {
        faces[next] = a;
        faces[next + 1] = b;
        faces[next + 2] = c;
        return next + 3;
    }
}
