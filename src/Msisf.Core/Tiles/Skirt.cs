namespace Msisf.Core.Tiles;

/// <summary>
/// The skirt of a part: a strip of triangles from its border straight down, which closes the gaps between parts of different levels.
/// </summary>
internal static class Skirt
{
    /// <summary>
    /// m: depth of the skirt's foot below the lowest sample of the model; it must be below all facets, whose middles are at most 140 m
    /// below their corners (1 px/deg).
    /// </summary>
    public const double DepthBelowLowest = 1000.0;

    /// <summary>
    /// Number of edges, and of vertices, of the border; a pole is one vertex where its line would be
    /// <see cref="TileMeshLayout.Samples"/>.
    /// </summary>
    public static int Edges(TileMeshLayout layout)
    {
        int across = layout.Samples - 2; // between the corners
        return (2 * layout.Lines) + (layout.HasNorthPole ? 1 : across) + (layout.HasSouthPole ? 1 : across);
    }

    /// <summary>The vertices of the border, once around, counter-clockwise seen from outside the Moon.</summary>
    public static int[] Border(TileMeshLayout layout)
    {
        int firstRow = layout.HasNorthPole ? 1 : 0;
        int lastLine = firstRow + ((layout.Lines - 1) * layout.Samples);
        List<int> border = [];
        for (int line = firstRow; line <= lastLine; line += layout.Samples)
        {
            border.Add(line); // the western side, southwards
        }

        if (layout.HasSouthPole)
        {
            border.Add(layout.VertexCount - 1);
            border.Add(lastLine + layout.Samples - 1);
        }
        else
        {
            border.AddRange(Enumerable.Range(lastLine + 1, layout.Samples - 1));
        }

        for (int line = lastLine - layout.Samples; line >= firstRow; line -= layout.Samples)
        {
            border.Add(line + layout.Samples - 1); // the eastern side, northwards
        }

        if (layout.HasNorthPole)
        {
            border.Add(0);
        }
        else
        {
            border.AddRange(Enumerable.Range(firstRow + 1, layout.Samples - 2).Reverse());
        }

        return [.. border];
    }

    /// <summary>The triangles, counter-clockwise seen from beside the part.</summary>
    /// <param name="border">The vertices of <see cref="Border"/>.</param>
    /// <param name="firstFoot">Number of the vertex below the border's first one; the others follow in order.</param>
    public static IEnumerable<int> Faces(IReadOnlyList<int> border, int firstFoot)
    {
        for (int here = 0; here < border.Count; here++)
        {
            int next = here + 1 == border.Count ? 0 : here + 1;
            foreach (int vertex in (int[])[border[here], firstFoot + here, firstFoot + next, border[here], firstFoot + next, border[next]])
            {
                yield return vertex;
            }
        }
    }
}
