namespace Msisf.Core.Surface;

/// <summary>A node of a tree of bounds (<see cref="BoundsLayout"/>).</summary>
/// <param name="Level">Its level, 0 for the finest.</param>
/// <param name="Row">Its row in the level, from the top.</param>
/// <param name="Column">Its column in the level, from the left.</param>
internal readonly record struct NodePlace(int Level, int Row, int Column);

/// <summary>A node of the tree of bounds of one of a surface's patches.</summary>
/// <param name="Part">Number of the patch in <see cref="SurfaceModel.Patches"/>.</param>
/// <param name="Place">The node.</param>
internal readonly record struct SurfaceNode(int Part, NodePlace Place);

/// <summary>How a walk goes on after a node.</summary>
internal enum Visit
{
    /// <summary>Go on with the nodes that make up this one.</summary>
    Descend,

    /// <summary>Leave out what is in this node.</summary>
    Skip,

    /// <summary>End the walk.</summary>
    Stop,
}

/// <summary>What a search asks of a node; a structure, so that it is compiled into the walk. It keeps what it finds itself.</summary>
internal interface INodeTester
{
    /// <summary>Is called with each node that is reached, coarse ones before those in them; descends to level 0 at most.</summary>
    Visit Test(NodePlace node);
}

/// <summary>The one walk down a tree of bounds, for all that look for something on the surface.</summary>
internal static class NodeWalk
{
    /// <summary>Walks a whole tree; false if the tester ended it.</summary>
    public static bool All<TTester>(BoundsLayout layout, ref TTester tester)
        where TTester : struct, INodeTester
    {
        int top = layout.Levels - 1;
        (int rows, int columns) = (layout.Rows(top), layout.Columns(top));
        for (int node = 0; node < rows * columns; node++)
        {
            if (!From(layout, new NodePlace(top, node / columns, node % columns), ref tester))
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>Walks a node and what is in it; false if the tester ended it.</summary>
    public static bool From<TTester>(BoundsLayout layout, NodePlace node, ref TTester tester)
        where TTester : struct, INodeTester
    {
        Visit wanted = tester.Test(node);
        if (wanted != Visit.Descend)
        {
            return wanted == Visit.Skip;
        }

        NodeRange children = layout.ChildrenOf(node.Level, node.Row, node.Column);
        int edge = layout.ChildrenPerEdge(node.Level);
        for (int child = 0; child < edge * edge; child++)
        {
            (int down, int right) = layout.ChildAt(child, edge);
            NodePlace place = new(node.Level - 1, children.FirstRow + down, children.FirstColumn + right);
            if (place.Row < children.EndRow && place.Column < children.EndColumn && !From(layout, place, ref tester))
            {
                return false;
            }
        }

        return true;
    }
}
