using System.Runtime.InteropServices;

namespace Msisf.Core.Surface.Sources;

/// <summary>Makes the seams between models: collects the borders of their cells, and fills the gaps between them.</summary>
internal sealed class SeamBuilder
{
    /// <summary>
    /// A facet's edges in steps of the finest lattice on which a corner of it lies must be below this, so that products of two differences
    /// have at most 52 bits, as in the models' own facets.
    /// </summary>
    private const double MaxSteps = 1 << 26;

    /// <summary>
    /// Rows of blocks between releases of memory: along the sides of a large map each line is on pages of its own, and the system maps
    /// fifteen neighbours with it.
    /// </summary>
    private const int RowsBetweenReleases = 16;

    private readonly IReadOnlyList<GridPatch> _parts;
    private readonly Dictionary<Vector3D, int> _numbers = [];
    private readonly List<SeamVertex> _vertices = [];
    private readonly List<(int From, int To)> _edges = [];

    private SeamBuilder(IReadOnlyList<GridPatch> parts) => _parts = parts;

    /// <summary>Makes the seams of models.</summary>
    /// <param name="parts">The models with their cells; if the first is not of the whole Moon there is nothing around them.</param>
    /// <param name="store">Keeps what fills the gaps; null to make all of it.</param>
    /// <param name="isDelaunay">Whether the facets are a constrained Delaunay triangulation, or what is found first.</param>
    /// <param name="more">Corners of further facets, three of each, whose vertices may belong to further parts; null for none.</param>
    /// <exception cref="BadInputException">The models can't be joined.</exception>
    public static SeamPatch Join(
        IReadOnlyList<GridPatch> parts, ISeamStore? store, bool isDelaunay = false, IReadOnlyList<SeamVertex>? more = null)
    {
        bool isOpen = !parts[0].Mesh.IsClosed;
        SeamBuilder builder = new(isOpen ? EmptySurroundings.Before(parts) : parts);
        for (int part = 0; part < builder._parts.Count; part++)
        {
            if (!builder._parts[part].IsLeftOut)
            {
                builder.AddBorders(part);
            }
        }

        SeamVertex[] vertices = [.. builder._vertices];
        int[] filling = SeamTriangulator.Fill(builder._parts, vertices, builder._edges, isDelaunay, store);
        int[] corners = InPlaces(vertices, isOpen ? EmptySurroundings.RemoveFrom(builder._parts, vertices, filling) : filling);
        builder.Check(vertices, corners);
        vertices = isOpen ? [.. vertices.Select(vertex => vertex with { Part = vertex.Part - 1 })] : vertices;
        return more is null
            ? new SeamPatch(vertices, corners)
            : new SeamPatch([.. vertices, .. more], [.. corners, .. Enumerable.Range(vertices.Length, more.Count)]);
    }

    /// <summary>Adds the sides of kept cells beyond which there is no kept cell.</summary>
    private void AddBorders(int number)
    {
        GridPatch part = _parts[number];
        CellMask kept = part.Kept!;
        for (int row = 0; row < kept.BlockRows; row++)
        {
            for (int column = 0; column < kept.BlockColumns; column++)
            {
                if (kept.StateOf(row, column) == CellMask.BlockState.Partial || IsBesideOthers(part, row, column))
                {
                    AddBorders(number, part, new CellBlock(row, column).Cells(part.Mesh));
                }
            }

            if (row % RowsBetweenReleases == RowsBetweenReleases - 1)
            {
                part.Grid.ReleasePages();
            }
        }
    }

    /// <summary>Whether a block that is kept has a neighbour that is not, or none.</summary>
    private static bool IsBesideOthers(GridPatch part, int row, int column)
    {
        CellMask kept = part.Kept!;
        if (kept.StateOf(row, column) == CellMask.BlockState.Empty)
        {
            return false;
        }

        CellRange cells = new CellBlock(row, column).Cells(part.Mesh);
        CellRange all = part.Mesh.Cells;
        int right = part.Mesh.SamplesOfTurn == all.Samples ? kept.BlockColumns : int.MaxValue;
        return (cells.FirstLine == all.FirstLine && !part.Mesh.IsClosed)
            || (cells.EndLine == all.EndLine && !part.Mesh.IsClosed)
            || (cells.FirstSample == all.FirstSample && right == int.MaxValue)
            || (cells.EndSample == all.EndSample && right == int.MaxValue)
            || (row > 0 && kept.StateOf(row - 1, column) != CellMask.BlockState.Whole)
            || (row + 1 < kept.BlockRows && kept.StateOf(row + 1, column) != CellMask.BlockState.Whole)
            || kept.StateOf(row, (column + kept.BlockColumns - 1) % kept.BlockColumns) != CellMask.BlockState.Whole
            || kept.StateOf(row, (column + 1) % kept.BlockColumns) != CellMask.BlockState.Whole;
    }

    private void AddBorders(int number, GridPatch part, CellRange cells)
    {
        for (int line = cells.FirstLine; line < cells.EndLine; line++)
        {
            for (int sample = cells.FirstSample; sample < cells.EndSample; sample++)
            {
                if (!part.Has(line, sample))
                {
                    continue;
                }

                // The cell lies on the left of its sides in this order, so the gap on the left of the same backwards.
                AddSide(IsKept(part, line, sample - 1), (line + 1, sample), (line, sample));
                AddSide(IsKept(part, line + 1, sample), (line + 1, sample + 1), (line + 1, sample));
                AddSide(IsKept(part, line, sample + 1), (line, sample + 1), (line + 1, sample + 1));
                AddSide(IsKept(part, line - 1, sample), (line, sample), (line, sample + 1));
            }
        }

        void AddSide(bool hasNeighbour, (int Line, int Sample) from, (int Line, int Sample) to)
        {
            if (!hasNeighbour)
            {
                (int start, int end) = (NumberOf(number, part, from), NumberOf(number, part, to));
                if (start != end)
                {
                    _edges.Add((start, end)); // at a pole a side has no length
                }
            }
        }
    }

    private static bool IsKept(GridPatch part, int line, int sample)
    {
        CellRange all = part.Mesh.Cells;
        if (part.Mesh.SamplesOfTurn == all.Samples)
        {
            sample = (sample + all.Samples) % all.Samples;
        }

        return line >= all.FirstLine && line < all.EndLine && sample >= all.FirstSample && sample < all.EndSample
            && part.Has(line, sample);
    }

    private int NumberOf(int number, GridPatch part, (int Line, int Sample) place)
    {
        int sample = part.Mesh.SamplesOfTurn == part.Mesh.Cells.Samples ? place.Sample % part.Mesh.Samples : place.Sample;
        Span<double> radius = stackalloc double[1];
        part.Mesh.ReadRadii(place.Line, sample, radius);
        Vector3D position = part.Vertex(place.Line, sample, radius[0]);
        ref int known = ref CollectionsMarshal.GetValueRefOrAddDefault(_numbers, position, out bool isKnown);
        if (!isKnown)
        {
            known = _vertices.Count;
            _vertices.Add(new SeamVertex(position, number, place.Line, sample));
        }

        return known;
    }

    private void Check(SeamVertex[] vertices, int[] corners)
    {
        if (corners.Length / 3 >= SeamPatch.MaxFacets)
        {
            throw new BadInputException(
                $"The borders of the elevation models need {corners.Length / 3} facets; up to {SeamPatch.MaxFacets} are possible. "
                    + "Take fewer models.");
        }

        for (int i = 0; i < corners.Length; i++)
        {
            int first = i / 3 * 3;
            SeamVertex a = vertices[corners[i]];
            SeamVertex b = vertices[corners[i % 3 == 2 ? first : i + 1]];
            double stepsPerMetre = Math.Max(
                StepsAt(vertices[corners[first]]), Math.Max(StepsAt(vertices[corners[first + 1]]), StepsAt(vertices[corners[first + 2]])));
            if ((a.Position - b.Position).Length > MaxSteps / stepsPerMetre)
            {
                throw new BadInputException(
                    $"{_parts[Math.Max(a.Part, b.Part)].Grid.ProductId} lies in {_parts[Math.Min(a.Part, b.Part)].Grid.ProductId}, whose "
                        + $"cells are too large beside its own. Give a model between the two as well.");
            }
        }
    }

    private double StepsAt(SeamVertex vertex) => _parts[vertex.Part].Geometry.StepsPerMetre;

    /// <summary>Sorts facets so that those near each other follow each other.</summary>
    private static int[] InPlaces(SeamVertex[] vertices, int[] corners)
    {
        int[] order = [.. Enumerable.Range(0, corners.Length / 3)];
        ulong[] places = [.. order.Select(facet => Place(
            (vertices[corners[3 * facet]].Position + vertices[corners[(3 * facet) + 1]].Position
                + vertices[corners[(3 * facet) + 2]].Position) / 3.0))];
        Array.Sort(places, order);
        for (int start = 0, end; start < order.Length; start = end)
        {
            for (end = start + 1; end < order.Length && places[end] == places[start]; end++)
            {
            }

            // Those at one place lie in the order of their vertices, in which order ever they were found.
            order.AsSpan(start, end - start).Sort((one, other) => VerticesOf(one).CompareTo(VerticesOf(other)));
        }

        return [.. order.SelectMany(facet => corners.AsSpan(3 * facet, 3).ToArray())];

        (int, int, int) VerticesOf(int facet)
        {
            (int a, int b, int c) = (corners[3 * facet], corners[(3 * facet) + 1], corners[(3 * facet) + 2]);
            int least = Math.Min(a, Math.Min(b, c));
            int most = Math.Max(a, Math.Max(b, c));
            return (least, most, a + b + c - least - most);
        }
    }

    /// <summary>A number whose order keeps places that are near each other together: the bits of the three coordinates in turn.</summary>
    private static ulong Place(Vector3D position)
    {
        const double Half = 1 << 20;
        const double StepsPerMetre = 0.5;
        return Spread((ulong)(Half + (StepsPerMetre * position.X))) | (Spread((ulong)(Half + (StepsPerMetre * position.Y))) << 1)
            | (Spread((ulong)(Half + (StepsPerMetre * position.Z))) << 2);
    }

    private static ulong Spread(ulong value)
    {
        ulong spread = 0;
        for (int bit = 0; bit < 21; bit++)
        {
            spread |= (value >> bit & 1) << (3 * bit);
        }

        return spread;
    }
}
