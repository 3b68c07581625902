namespace Msisf.Core.Tiles;

/// <summary>
/// Which samples the mesh of a tile joins and in which order; <c>default</c> is not a layout: use <see cref="For"/>. Vertices: the north
/// pole, if the mesh reaches it; then the samples line by line from the north, each from the west; then the south pole. A cell of four
/// samples belongs to the tile that holds its north-west sample, so each cell of the Moon belongs to exactly one tile.
/// </summary>
/// <param name="PixelsPerDegree">Resolution of the grid.</param>
/// <param name="MarginSamples">Rings of cells around the tile that are added (overlapping with its neighbours); usually 0.</param>
/// <param name="FirstLine">Northernmost line of the grid.</param>
/// <param name="FirstSample">Westernmost sample of the grid, in [0, 360 res).</param>
/// <param name="Samples">Number of samples of a line; they continue across the prime meridian.</param>
public readonly record struct TileMeshLayout(
    TileId Tile, int PixelsPerDegree, int MarginSamples, int FirstLine, int Lines, int FirstSample, int Samples)
{
    /// <summary>Whether the mesh ends in a fan around the north pole.</summary>
    public bool HasNorthPole => FirstLine == 0;

    /// <summary>Whether the mesh ends in a fan around the south pole.</summary>
    public bool HasSouthPole => FirstLine + Lines == 180 * PixelsPerDegree;

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

        int cells = TileId.SizeDegrees * pixelsPerDegree;
        int allSamples = 360 * pixelsPerDegree;
        int start = tile.FirstLine(pixelsPerDegree);

        // One line and one sample more than cells: the south-east corners of the last ones lie in the next tile.
        int firstLine = Math.Max(start - marginSamples, 0);
        int endLine = Math.Min(start + cells + marginSamples + 1, 180 * pixelsPerDegree);
        int firstSample = (tile.FirstSample(pixelsPerDegree) - marginSamples + allSamples) % allSamples;
        return new TileMeshLayout(
            tile, pixelsPerDegree, marginSamples, firstLine, endLine - firstLine, firstSample, cells + (2 * marginSamples) + 1);
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

    private static int Add(int[] faces, int next, int a, int b, int c)
    {
        faces[next] = a;
        faces[next + 1] = b;
        faces[next + 2] = c;
        return next + 3;
    }
}
