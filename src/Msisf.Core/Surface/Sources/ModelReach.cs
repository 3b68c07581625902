using Msisf.Core.Terrain;

namespace Msisf.Core.Surface.Sources;

/// <summary>How far away the cells of a model are, and whether another model holds them; no sample is read.</summary>
internal static class ModelReach
{
    /// <summary>The angle is found up to this part of itself.</summary>
    private const double Precision = 0.05;

    /// <summary>Cells along a model's border that do not count as covering: the seam lies there.</summary>
    private const double Margin = 2.0;

    /// <summary>rad: lower bound of the angle, seen from the Moon's centre, from a direction to the nearest cell of a model.</summary>
    /// <param name="direction">Unit vector, body-fixed.</param>
    public static double AngleTo(GridPatch part, Vector3D direction)
    {
        BoundsTree tree = part.Bounds;
        PriorityQueue<(int Level, int Row, int Column, double Radius), (double Bound, int Order)> nodes = new();
        int order = 0;
        int top = tree.Layout.Levels - 1;
        Add(top, new NodeRange(0, tree.Layout.Rows(top), 0, tree.Layout.Columns(top)), 0.0);
        while (nodes.TryDequeue(out (int Level, int Row, int Column, double Radius) node, out (double Bound, int) found))
        {
            if (node.Level == SquareLayout.CellBlockLevel || 2.0 * node.Radius < Precision * found.Bound)
            {
                return found.Bound;
            }

            Add(node.Level - 1, tree.Layout.ChildrenOf(node.Level, node.Row, node.Column), found.Bound);
        }

        throw new InvalidOperationException($"{part.Grid.ProductId} has no cells.");

        void Add(int level, NodeRange range, double least)
        {
            for (int row = range.FirstRow; row < range.EndRow; row++)
            {
                for (int column = range.FirstColumn; column < range.EndColumn; column++)
                {
                    SphericalCap cap = tree.CapOf(level, row, column);
                    double radius = Math.Atan2(cap.SinRadius, cap.CosRadius);
                    double bound = Math.Max(least, Vector3D.AngleBetween(cap.Centre, direction) - radius);
                    nodes.Enqueue((level, row, column, radius), (bound, order++)); // of equal ones the first
                }
            }
        }
    }

    /// <summary>Whether a model has data wherever another one has, well within its border.</summary>
    /// <param name="whole">The model that may hold the other.</param>
    /// <param name="part">The other one.</param>
    public static bool Covers(GridPatch whole, GridPatch part)
    {
        if (whole.Grid.MayHaveGaps)
        {
            return false;
        }

        HeldNodes held = new(whole, part);
        return whole.Mesh.IsClosed || NodeWalk.All(part.Layout, ref held);
    }

    private static bool Holds(FacetMesh mesh, CellRange range)
    {
        CellRange all = mesh.Cells;
        bool isRing = mesh.Grid.Projection is Equirectangular && mesh.SamplesOfTurn == all.Samples;
        return range.FirstLine >= all.FirstLine && range.EndLine <= all.EndLine
            && (isRing || (range.FirstSample >= all.FirstSample && range.EndSample <= all.EndSample));
    }

    /// <summary>Stops at a block that a model does not hold.</summary>
    private readonly struct HeldNodes(GridPatch whole, GridPatch part) : INodeTester
    {
        public Visit Test(NodePlace node)
        {
            FacetMesh mesh = whole.Mesh;
            SphericalCap cap = part.Bounds.CapOf(node.Level, node.Row, node.Column);
            bool isHeld = Array.Exists(CapWindow.Of(mesh, cap, Margin * whole.CellAngle), range => Holds(mesh, range));
            return isHeld ? Visit.Skip : node.Level > SquareLayout.CellBlockLevel ? Visit.Descend : Visit.Stop;
        }
    }
}
