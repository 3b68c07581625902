using Msisf.Core.Surface;

namespace Msisf.Core.Tiles.Selection;

/// <summary>
/// Makes a horizon map of the model as seen from a viewpoint: first from the blocks' minimum radii, then from the facets' edges in the
/// blocks that hide most.
/// </summary>
internal sealed class HorizonSurvey(PolarView view, ElevationSummary summary, TerrainPatch patch)
{
    /// <summary>
    /// rad: maximum elevation of the viewpoint over the ground for which the map is made; under a higher viewpoint no tile is hidden
    /// completely, and hidden parts do not matter.
    /// </summary>
    private const double MaxElevation = Math.PI / 15.0;

    /// <summary>
    /// Maximum number of bins of a map; for the whole circle a bin is then 0.09 degrees wide, a third of a cell at 4 px/deg.
    /// </summary>
    private const int MaxBins = 4096;

    /// <summary>Bins per mesh cell at the limb; more bins cost time and hide no more.</summary>
    private const double BinsPerCell = 2.5;

    /// <summary>
    /// Maximum number of vertices that are read for one map, some milliseconds; terrain that is left out makes the map hide less, but
    /// never wrong.
    /// </summary>
    private const int VertexBudget = 9_000;

    private readonly SummaryLevel _blocks = summary.Levels[1];
    private readonly SummaryLevel _finest = summary.Levels[^1];
    private readonly double _cellAngle = Math.PI / 180.0 / summary.PixelsPerDegree;

    /// <summary>Whether terrain in a place could hide surface that the caller asks about.</summary>
    public delegate bool Relevance(in TerrainNode node, in PolarBounds bounds);

    /// <summary>Makes a map without terrain.</summary>
    /// <param name="middle">Middle of the azimuths that matter, rad.</param>
    /// <param name="width">Width of the range of azimuths, rad.</param>
    public HorizonMap EmptyMap(double middle, double width)
    {
        double min = (summary.MinRadius * MeshBounds.SagittaFactor(summary.PixelsPerDegree)) - Tolerances.VertexLattice;
        double toTangent = AngleOfCosine(min / view.Distance);
        double lastAngle = Math.Min(Math.PI, toTangent + AngleOfCosine(min / summary.MaxRadius));
        double sight = 0.5 * (summary.MinRadius + summary.MaxRadius) * Math.Cos(MaxElevation) / view.Distance;
        double firstAngle = Math.Max(0.0, AngleOfCosine(sight) - MaxElevation);
        AzimuthWindow window = new(middle, width, _cellAngle / BinsPerCell / Math.Sin(Math.Min(lastAngle, 0.5 * Math.PI)), MaxBins);
        HorizonMap map = new(window, Math.Sin(0.5 * firstAngle), Math.Sin(0.5 * lastAngle));
        if (view.Distance > min)
        {
            map.RaiseAll(Math.Sin(0.5 * toTangent), view.TangentSlope(min));
        }

        return map;
    }

    /// <summary>Adds the terrain to a map.</summary>
    public void Fill(HorizonMap map, Relevance relevant)
    {
        List<Candidate> candidates = Candidates(map, relevant);
        candidates.Sort((a, b) => a.Slope != b.Slope ? b.Slope.CompareTo(a.Slope) : a.Index.CompareTo(b.Index));
        RidgeTracer tracer = new(map, view, _cellAngle);
        int budget = VertexBudget;
        foreach (Candidate candidate in candidates)
        {
            if (budget <= 0)
            {
                return;
            }

            int row = candidate.Index / _blocks.Columns;
            Refine(map, relevant, tracer, row, candidate.Index % _blocks.Columns, candidate.Count, ref budget);
        }
    }

    private static double AngleOfCosine(double cos) => cos >= 1.0 ? 0.0 : Math.Atan2(Math.Sqrt((1.0 - cos) * (1.0 + cos)), cos);

    private List<Candidate> Candidates(HorizonMap map, Relevance relevant)
    {
        List<Candidate> candidates = [];
        bool[] tiles = RelevantTiles(map, relevant);
        int factor = _blocks.Subdivisions;
        for (int row = 0; row < _blocks.Rows; row++)
        {
            // Towards the poles blocks are narrow, so neighbours are joined until the group is about as wide as high.
            int group = Math.Clamp(
                (int)(1.0 / Math.Cos(MeshBounds.CentreLatitude(_blocks.Cells(row, 0), _blocks.Lines))), 1, _blocks.Columns / 4);
            double inner = _blocks.InnerRadius(row);
            for (int column = 0; column < _blocks.Columns; column += group)
            {
                int count = Math.Min(group, _blocks.Columns - column);
                int first = (row / factor * TileId.Columns) + (column / factor);
                int last = (row / factor * TileId.Columns) + ((column + count - 1) / factor);
                if (Array.IndexOf(tiles, true, first, last - first + 1) < 0
                    || (_blocks.NodeUnread(row, column, count) is { IsUnread: true } unread
                        && !Concerns(map, relevant, unread, view.Bounds(unread))))
                {
                    continue;
                }

                TerrainNode node = _blocks.Node(row, column, count);
                PolarBounds bounds = view.Bounds(node);
                if (Concerns(map, relevant, node, bounds))
                {
                    candidates.Add(new Candidate(bounds.MaxSlope, (row * _blocks.Columns) + column, count));
                    if (count == 1)
                    {
                        RaiseByInnerCap(map, node, inner);
                    }
                }
            }
        }

        return candidates;
    }

    private bool[] RelevantTiles(HorizonMap map, Relevance relevant)
    {
        SummaryLevel level = summary.Levels[0];
        bool[] tiles = new bool[level.Count];
        for (int tile = 0; tile < tiles.Length; tile++)
        {
            TerrainNode node = summary.IsOnDemand
                ? level.NodeOfLimits(tile / level.Columns, tile % level.Columns)
                : level.Node(tile / level.Columns, tile % level.Columns);
            tiles[tile] = Concerns(map, relevant, node, view.Bounds(node));
        }

        return tiles;
    }

    private static bool Concerns(HorizonMap map, Relevance relevant, in TerrainNode node, in PolarBounds bounds) =>
        bounds.Near < map.LastArc && !map.NeverHides(bounds)
        && map.Window.Touched(bounds.Azimuth, bounds.HalfWidth).Count > 0 && relevant(node, bounds);

    /// <summary>
    /// Raises the map with the cap inside a block: each half plane that meets the cap meets the block's terrain there, at its minimum
    /// radius or higher.
    /// </summary>
    private void RaiseByInnerCap(HorizonMap map, in TerrainNode node, double inner)
    {
        (double sin, double cos) = Math.SinCos(inner);
        PolarBounds bounds = view.Bounds(node with { Cap = new SphericalCap(node.Cap.Centre, cos, sin) });
        if (bounds.HalfWidth >= Math.PI)
        {
            return;
        }

        double place = map.Window.Place(bounds.Azimuth);
        double half = bounds.HalfWidth / map.Window.BinWidth;
        int last = (int)Math.Floor(place + half) - 1;
        for (int bin = (int)Math.Ceiling(place - half); bin <= last; bin++)
        {
            map.Raise(bin, bounds.Far, bounds.MinSlope);
        }
    }

    private void Refine(HorizonMap map, Relevance relevant, RidgeTracer tracer, int row, int column, int count, ref int budget)
    {
        int factor = _finest.Subdivisions / _blocks.Subdivisions;
        for (int fineRow = row * factor; fineRow < (row + 1) * factor; fineRow++)
        {
            for (int part = 0; part < factor; part++)
            {
                int fineColumn = (column * factor) + (part * count);
                TerrainNode node = _finest.Node(fineRow, fineColumn, count);
                PolarBounds bounds = view.Bounds(node);
                if (map.CouldRise(bounds) && relevant(node, bounds))
                {
                    patch.Load(_finest.Cells(fineRow, fineColumn, count));
                    tracer.Trace(patch);
                    budget -= patch.Lines * patch.Samples;
                }
            }
        }
    }

    private readonly record struct Candidate(double Slope, int Index, int Count);
}
