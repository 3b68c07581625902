namespace Msisf.Core.Surface.Sources;

/// <summary>
/// The facets between a window and the one inside it, whose cells are half as wide: a ring one cell of the outer window wide, in which
/// each of its cells beside the inner window has three facets and each in a corner two.
/// </summary>
internal sealed class WindowSeam(GridPatch outer, int outerPart, GridPatch inner, int innerPart)
{
    private readonly List<SeamVertex> _corners = [];

    /// <summary>Makes the facets.</summary>
    /// <param name="hole">The cells of the outer window that the ring and the inner window stand for.</param>
    /// <returns>Three corners of each facet, counter-clockwise seen from outside.</returns>
    public IReadOnlyList<SeamVertex> Fill(CellRange hole)
    {
        SeamVertex[][] around = [.. Sides(hole).Select(side => side.Select(at => At(outer, outerPart, at)).ToArray())];
        SeamVertex[][] within = [.. Sides(inner.Mesh.Cells).Select(side => side.Select(at => At(inner, innerPart, at)).ToArray())];
        for (int side = 0; side < around.Length; side++)
        {
            (SeamVertex[] o, SeamVertex[] i) = (around[side], within[side]);
            SeamVertex[] before = around[(side + 3) % 4];
            Add(o[0], before[^2], i[0]); // the corner where the side begins
            Add(o[0], i[0], o[1]);
            for (int cell = 1; cell + 2 < o.Length; cell++)
            {
                int first = 2 * (cell - 1);
                Add(o[cell], i[first], i[first + 1]);
                Add(o[cell], i[first + 1], o[cell + 1]);
                Add(o[cell + 1], i[first + 1], i[first + 2]);
            }
        }

        return _corners;
    }

    /// <summary>The vertices on the four sides of a rectangle, clockwise from its first line and sample; sides share their ends.</summary>
    private static IEnumerable<(int Line, int Sample)[]> Sides(CellRange cells)
    {
        yield return [.. Enumerable.Range(0, cells.Samples + 1).Select(i => (cells.FirstLine, cells.FirstSample + i))];
        yield return [.. Enumerable.Range(0, cells.Lines + 1).Select(i => (cells.FirstLine + i, cells.EndSample))];
        yield return [.. Enumerable.Range(0, cells.Samples + 1).Select(i => (cells.EndLine, cells.EndSample - i))];
        yield return [.. Enumerable.Range(0, cells.Lines + 1).Select(i => (cells.EndLine - i, cells.FirstSample))];
    }

    private static SeamVertex At(GridPatch surface, int part, (int Line, int Sample) at)
    {
        Span<double> radius = stackalloc double[1];
        surface.Mesh.ReadRadii(at.Line, at.Sample, radius);
        Vector3D position = surface.Vertex(at.Line, at.Sample, radius[0]);
        return new SeamVertex(position, part, at.Line, at.Sample);
    }

    private void Add(SeamVertex a, SeamVertex b, SeamVertex c) => _corners.AddRange([a, b, c]);
}
