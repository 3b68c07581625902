using Msisf.Core.Numerics;
using Msisf.Core.Surface;

namespace Msisf.Core.Tiles.Selection;

/// <summary>Receives the nodes and facets that may be seen, from <see cref="SurfaceWalk"/>, coarse nodes before fine ones.</summary>
internal interface ISurfaceVisitor
{
    /// <summary>A node that may be seen.</summary>
    /// <param name="node">
    /// Its place and bounds. Those of a node that is not of the finest level may be the model's limits
    /// (<see cref="TerrainNode.IsUnread"/>), so that it is not read where its parts can be asked.
    /// </param>
    /// <param name="bounds">Bounds of the node from the camera.</param>
    /// <param name="certain">Whether it is certainly seen: wholly in the image, and too near for the horizon map to hide it.</param>
    /// <param name="place">Its place in the summary's tree.</param>
    Visit Node(in TerrainNode node, in PolarBounds bounds, bool certain, NodePlace place);

    /// <summary>A facet that may be seen.</summary>
    /// <param name="part">Part of the facet that is in the image, a convex polygon; m, MOON_ME.</param>
    /// <param name="bounds">Bounds of this part from the camera.</param>
    /// <param name="facet">The whole facet.</param>
    Visit Facet(ReadOnlySpan<Vector3D> part, in PolarBounds bounds, in Facet facet);
}

/// <summary>A node of the summary's tree.</summary>
/// <param name="Depth">Index of its <see cref="ElevationSummary.Levels"/>; 0: a tile.</param>
/// <param name="Row">Row of that level, 0 northernmost.</param>
/// <param name="Column">Column of that level, 0 at longitude 0.</param>
internal readonly record struct NodePlace(int Depth, int Row, int Column);

/// <summary>How a walk continues after a node.</summary>
internal enum Visit
{
    /// <summary>Continue with the parts of this node.</summary>
    Descend,

    /// <summary>Skip the parts of this node.</summary>
    Skip,

    /// <summary>Ask again with the bounds that the node has when it is read; only for one with the limits of the model.</summary>
    Read,

    /// <summary>End the walk.</summary>
    Stop,
}
