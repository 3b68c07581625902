namespace Msisf.Core.Surface.Sources;

/// <summary>Fills the gaps between models: those that a store knows with what it has kept, the others anew.</summary>
/// <remarks>
/// The facets of a gap follow from its borders alone (<see cref="SeamFront"/>), so that it makes no difference where they come from.
/// </remarks>
internal sealed class SeamTriangulator
{
    private readonly IReadOnlyList<GridPatch> _parts;
    private readonly SeamVertex[] _vertices;
    private readonly IReadOnlyList<(int From, int To)> _edges;
    private readonly bool _isDelaunay;
    private readonly SeamBorders _borders;
    private readonly Dictionary<string, int> _numbers = new(StringComparer.Ordinal);
    private readonly bool[] _isFilled;
    private readonly List<int> _corners = [];

    private SeamTriangulator(
        IReadOnlyList<GridPatch> parts, SeamVertex[] vertices, IReadOnlyList<(int From, int To)> edges, bool isDelaunay)
    {
        (_parts, _vertices, _edges, _isDelaunay) = (parts, vertices, edges, isDelaunay);
        _borders = new SeamBorders(vertices, edges, isDelaunay);
        _isFilled = new bool[_borders.Hashes.Count];
        for (int border = 0; border < _borders.Hashes.Count; border++)
        {
            _numbers[_borders.Hashes[border]] = border;
        }
    }

    /// <summary>Fills all gaps.</summary>
    /// <param name="parts">The models with their cells.</param>
    /// <param name="edges">The edges of the borders, with the gap on their left as seen from outside.</param>
    /// <param name="isDelaunay">Whether the facets are a constrained Delaunay triangulation, or what is found first.</param>
    /// <param name="store">Has fillings, and gets those that it does not have; null for none.</param>
    /// <returns>Three indices of vertices for each facet, in no order.</returns>
    /// <exception cref="BadInputException">A gap can't be filled: borders cross.</exception>
    public static int[] Fill(
        IReadOnlyList<GridPatch> parts, SeamVertex[] vertices, IReadOnlyList<(int From, int To)> edges, bool isDelaunay,
        ISeamStore? store) => store is null
            ? Filled(vertices, edges, isDelaunay)
            : new SeamTriangulator(parts, vertices, edges, isDelaunay).Fill(store);

    private static int[] Filled(SeamVertex[] vertices, IReadOnlyList<(int From, int To)> edges, bool isDelaunay)
    {
        int[] corners = new SeamFront(vertices, edges).Fill();
        return isDelaunay ? SeamDelaunay.Of(vertices, corners) : corners;
    }

    private int[] Fill(ISeamStore store)
    {
        for (int border = _isFilled.Length - 1; border >= 0; border--)
        {
            if (!_isFilled[border] && store.Find(ProductOf(border), _borders.Hashes[border]) is { } filling)
            {
                TryTake(filling);
            }
        }

        int[] made = Filled(_vertices, [.. _edges.Where(edge => !_isFilled[_borders.BorderOf(edge.From)])], _isDelaunay);
        Keep(made, store);
        return [.. _corners, .. made];
    }

    private void TryTake(GapTriangulation filling)
    {
        List<int> vertices = [];
        int[] borders = new int[filling.Borders.Count];
        for (int i = 0; i < borders.Length; i++)
        {
            if (!_numbers.TryGetValue(filling.Borders[i], out borders[i]) || _isFilled[borders[i]])
            {
                return; // of another gap
            }

            vertices.AddRange(_borders.VerticesOf(borders[i]));
        }

        if (filling.Corners.Any(corner => corner < 0 || corner >= vertices.Count))
        {
            return;
        }

        int[] corners = [.. filling.Corners.Select(corner => vertices[corner])];
        if (!HoldsOthers(corners, borders))
        {
            Array.ForEach(borders, border => _isFilled[border] = true);
            _corners.AddRange(corners);
        }
    }

    /// <summary>Whether another border lies within a filling: a model so small that it has room in the gap.</summary>
    private bool HoldsOthers(int[] corners, int[] borders)
    {
        HashSet<int> own = [.. borders];
        int[] others = [.. Enumerable.Range(0, _isFilled.Length).Where(border => !own.Contains(border))];
        if (others.Length == 0)
        {
            return false;
        }

        SeamPatch mesh = new(_vertices, corners);
        for (int block = 0; block < mesh.Blocks.Count; block++)
        {
            (Vector3D up, double cosine) = (mesh.Blocks[block].Box.Up, mesh.Blocks[block].Box.CapRadius.Cosine);
            foreach (int other in others)
            {
                Vector3D place = _vertices[_borders.VerticesOf(other)[0]].Position;
                if (Vector3D.Dot(up, place) < cosine * place.Length)
                {
                    continue;
                }

                int first = block * SeamPatch.BlockFacets;
                for (int facet = first; facet < first + mesh.FacetsOf(block); facet++)
                {
                    (Vector3D a, Vector3D b, Vector3D c) = mesh.CornersOf(facet);
                    if (Orientation.Of(a, b, place) >= 0 && Orientation.Of(b, c, place) >= 0 && Orientation.Of(c, a, place) >= 0)
                    {
                        return true;
                    }
                }
            }
        }

        return false;
    }

    /// <summary>Gives a store what fills each gap: the facets whose borders they join.</summary>
    private void Keep(int[] corners, ISeamStore store)
    {
        UnionFind together = new(_isFilled.Length);
        for (int i = 0; i < corners.Length; i += 3)
        {
            together.Unite(_borders.BorderOf(corners[i]), _borders.BorderOf(corners[i + 1]));
            together.Unite(_borders.BorderOf(corners[i]), _borders.BorderOf(corners[i + 2]));
        }

        Dictionary<int, List<int>> facets = [];
        for (int i = 0; i < corners.Length; i++)
        {
            int gap = together.Of(_borders.BorderOf(corners[i]));
            if (!facets.TryGetValue(gap, out List<int>? inGap))
            {
                facets[gap] = inGap = [];
            }

            inGap.Add(corners[i]);
        }

        Dictionary<int, List<int>> borders = [];
        for (int border = 0; border < _isFilled.Length; border++)
        {
            if (facets.ContainsKey(together.Of(border)))
            {
                if (!borders.TryGetValue(together.Of(border), out List<int>? ofGap))
                {
                    borders[together.Of(border)] = ofGap = [];
                }

                ofGap.Add(border);
            }
        }

        int[] starts = new int[_isFilled.Length];
        foreach ((int gap, List<int> ofGap) in borders)
        {
            int start = 0;
            foreach (int border in ofGap)
            {
                starts[border] = start;
                start += _borders.VerticesOf(border).Count;
            }

            store.Keep(new GapTriangulation(
                ProductOf(ofGap[^1]),
                [.. ofGap.Select(border => _borders.Hashes[border])],
                [.. facets[gap].Select(corner => starts[_borders.BorderOf(corner)] + _borders.PlaceOf(corner))]));
        }
    }

    private string ProductOf(int border) => _parts[_vertices[_borders.VerticesOf(border)[0]].Part].Grid.ProductId;
}
