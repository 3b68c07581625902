using Msisf.Core.Surface;

namespace Msisf.Core.Illumination;

/// <summary>
/// Finds the horizon of places: from near to far down the tree of each model, leaving out all that can't rise above what was found before,
/// to the edges of facets. Each thread has its own.
/// </summary>
internal sealed class HorizonFinder
{
    /// <summary>Children of a node: 4 x 4.</summary>
    private const int MaxChildren = 16;

    /// <summary>rad: the columns' rounding and more is added to the width of nodes.</summary>
    private const double AzimuthMargin = 1e-5;

    private readonly HorizonTerrain _terrain;
    private readonly PatchPoints _points = new();
    private readonly HashSet<PatchPlace> _done = [];
    private readonly List<PatchPlace> _raised = [];
    private readonly List<PatchPlace> _before = [];
    private readonly HashSet<int> _kept = [];
    private readonly HorizonWindows _windows;
    private LocalFrame _frame;
    private bool _hasBefore;
    private bool _hasWindows;
    private double _radius;
    private int _part;

    /// <summary>Makes a finder.</summary>
    /// <param name="terrain">The terrain, which several finders share.</param>
    /// <param name="columns">Columns of a turn.</param>
    public HorizonFinder(HorizonTerrain terrain, int columns)
    {
        _terrain = terrain;
        (Buffer, _windows) = (new HorizonBuffer(columns), new HorizonWindows(columns));
    }

    /// <summary>The horizon that was found last.</summary>
    public HorizonBuffer Buffer { get; }

    /// <summary>Patches of 8 x 8 cells that were looked at so far.</summary>
    public long Patches { get; private set; }

    /// <summary>
    /// Forgets the place before, from which the search would start: so what is found does not depend on what this thread did before.
    /// </summary>
    public void Forget() => _hasBefore = false;

    /// <summary>Finds the horizon of a place.</summary>
    /// <param name="frame">The place, above the ground.</param>
    /// <param name="bottom">Tangent of an elevation below which nothing needs to be known.</param>
    /// <param name="tops">For each group of columns the tangent of one above which nothing needs to be known.</param>
    public void Find(LocalFrame frame, double bottom, float[] tops)
    {
        (_frame, _radius) = (frame, frame.PositionBodyFixed.Length);
        KeepOwners();
        Buffer.Clear((float)bottom, tops);
        _done.Clear();
        _hasWindows = false;

        // What made the horizon of the place before mostly makes this one too.
        foreach (PatchPlace place in _before)
        {
            SeenNode node = See(_terrain.NodeOf(place.Part, new NodePlace(SquareLayout.PatchLevel, place.Row, place.Column)));
            if (MayRise(node))
            {
                RaiseTo(place, node);
            }
        }

        _hasWindows = _before.Count > 0;
        if (_hasWindows)
        {
            _windows.Take(Buffer.Tangents);
        }

        for (_part = _terrain.Surface.Parts.Count - 1; _part >= 0; _part--)
        {
            GridPatch part = _terrain.Surface.Parts[_part];
            if (!part.IsLeftOut)
            {
                int level = part.Layout.Levels - 1;
                Visit(level, new NodeRange(0, part.Layout.Rows(level), 0, part.Layout.Columns(level)));
            }
        }

        VisitSeams();
    }

    /// <summary>Keeps the patches that made the horizon that was found last.</summary>
    private void KeepOwners()
    {
        _before.Clear();
        int last = -1;
        foreach (int owner in _hasBefore ? Buffer.Owners : [])
        {
            if (owner >= 0 && owner != last && _kept.Add(owner))
            {
                _before.Add(_raised[owner]);
            }

            last = owner;
        }

        _hasBefore = true;
        _kept.Clear();
        _raised.Clear();
    }

    /// <summary>Visits neighbouring nodes of a level, the nearest first.</summary>
    private void Visit(int level, NodeRange nodes)
    {
        int count = (nodes.EndRow - nodes.FirstRow) * (nodes.EndColumn - nodes.FirstColumn);
        Span<SeenNode> seen = count <= MaxChildren ? stackalloc SeenNode[MaxChildren] : new SeenNode[count];
        int kept = 0;
        for (int row = nodes.FirstRow; row < nodes.EndRow; row++)
        {
            for (int column = nodes.FirstColumn; column < nodes.EndColumn; column++)
            {
                SeenNode node = See(_terrain.NodeOf(_part, new NodePlace(level, row, column))) with { Row = row, Column = column };
                int at = kept++;
                for (; at > 0 && seen[at - 1].Sine > node.Sine; at--)
                {
                    seen[at] = seen[at - 1];
                }

                seen[at] = node;
            }
        }

        BoundsLayout layout = _terrain.Surface.Parts[_part].Layout;
        foreach (ref readonly SeenNode node in seen[..kept])
        {
            if (!MayRise(node))
            {
                continue;
            }

            if (level > SquareLayout.PatchLevel)
            {
                Visit(level - 1, layout.ChildrenOf(level, node.Row, node.Column));
            }
            else
            {
                RaiseTo(new PatchPlace(_part, node.Row, node.Column), node);
            }
        }
    }

    private void VisitSeams()
    {
        IReadOnlyList<TerrainNode> seams = _terrain.Seams;
        for (int block = 0; block < seams.Count; block++)
        {
            if (MayRise(See(seams[block])))
            {
                (BlockVertices vertices, Vector3D origin) = _terrain.BlockAt(_terrain.Surface.Parts.Count, 0, block);
                Buffer.Owner = -1;
                for (int line = 0; line < vertices.Lines; line += 2)
                {
                    uint cells = vertices.CellsOfLine(line);
                    for (int sample = 0; cells != 0; sample++, cells >>= 1)
                    {
                        if ((cells & 1) != 0)
                        {
                            HorizonPoint a = HorizonPoint.Of(Buffer.Columns, _frame, vertices[line, sample] + origin);
                            HorizonPoint b = HorizonPoint.Of(Buffer.Columns, _frame, vertices[line + 1, sample] + origin);
                            HorizonPoint c = HorizonPoint.Of(Buffer.Columns, _frame, vertices[line + 1, sample + 1] + origin);
                            Buffer.Raise(a, b);
                            Buffer.Raise(b, c);
                            Buffer.Raise(c, a);
                        }
                    }
                }
            }
        }
    }

    /// <summary>Where a node is seen, and how high it can rise.</summary>
    private SeenNode See(in TerrainNode node)
    {
        SphericalCap cap = node.Cap;
        Vector3D local = _frame.ToLocal(cap.Centre);
        double sine = double.Sqrt((local.X * local.X) + (local.Y * local.Y)); // directions: no overflow
        double nearSine = (sine * cap.CosRadius) - (local.Z * cap.SinRadius);
        double nearCosine = (local.Z * cap.CosRadius) + (sine * cap.SinRadius);
        if (!(nearSine > 1e-12) || local.Z <= 0.0)
        {
            // Around the place; or beyond a right angle from it, where no terrain can be above its horizon.
            bool isAround = local.Z > 0.0 || nearCosine > 0.0;
            return new SeenNode { Bound = isAround ? float.PositiveInfinity : float.NegativeInfinity, Count = Buffer.Columns, Sine = sine };
        }

        double highest = node.MaxRadius;
        double bound = ((highest * nearCosine) - _radius) / (highest * nearSine);
        double tangent = highest / _radius;
        if (tangent < 1.0 && nearCosine > tangent)
        {
            double farCosine = (local.Z * cap.CosRadius) - (sine * cap.SinRadius);
            double farSine = (sine * cap.CosRadius) + (local.Z * cap.SinRadius);
            bound = farCosine < tangent
                ? -double.Sqrt((1.0 - tangent) * (1.0 + tangent)) / tangent
                : ((highest * farCosine) - _radius) / (highest * farSine);
        }

        double part = cap.SinRadius / sine;
        double half = part + (0.5708 * part * part * part) + AzimuthMargin; // at least the arc sine
        double toColumns = Buffer.Columns / (2.0 * Math.PI);
        double first = (Math.Atan2(local.X, local.Y) - half) * toColumns;
        int from = (int)Math.Floor(first);
        int count = Math.Min(Buffer.Columns, (int)Math.Ceiling(first + (2.0 * half * toColumns)) - from + 1);
        return new SeenNode { Bound = (float)(bound + 1e-7), First = from & (Buffer.Columns - 1), Count = count, Sine = sine };
    }

    private bool MayRise(in SeenNode node) => node.Bound > Buffer.LeastFrom(node.First, node.Count);

    /// <summary>Raises the horizon to the edges of a patch of 8 x 8 cells, unless that was done before.</summary>
    private void RaiseTo(PatchPlace place, in SeenNode node)
    {
        if (!_done.Add(place))
        {
            return;
        }

        const int PerBlock = CellBlock.Size / PatchPoints.Cells;
        GridPatch part = _terrain.Surface.Parts[place.Part];
        CellRange cells = part.Layout.Cells(SquareLayout.PatchLevel, place.Row, place.Column);
        (BlockVertices vertices, Vector3D origin) = _terrain.BlockAt(place.Part, place.Row / PerBlock, place.Column / PerBlock);
        float highest = _points.Place(
            vertices, origin, place.Row % PerBlock * PatchPoints.Cells, place.Column % PerBlock * PatchPoints.Cells, cells, _frame);
        if (Buffer.HighestOf(highest, node.Count) > Buffer.LeastFrom(node.First, node.Count))
        {
            Patches++;
            _points.FindColumns(cells.Lines + 1, Buffer.Columns);
            if (_points.FindHigh(_hasWindows ? _windows : null, cells))
            {
                Buffer.Owner = _raised.Count;
                _raised.Add(place);
                _points.RaiseAll(Buffer, cells, part);
            }
        }
    }

    /// <summary>A node as it is seen from a place.</summary>
    private struct SeenNode
    {
        public int Row;
        public int Column;
        public int First;
        public int Count;
        public float Bound;
        public double Sine;
    }

    private readonly record struct PatchPlace(int Part, int Row, int Column);
}
