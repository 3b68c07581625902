using Msisf.Core.Mesh.Bounds;
using Msisf.Core.Numerics;

namespace Msisf.Core.Tiles.Selection;

/// <summary>Is shown what of the surface may be in the image, coarse before fine.</summary>
internal interface ISurfaceVisitor
{
    /// <summary>A node that may be seen.</summary>
    /// <param name="node">Its place and bounds.</param>
    /// <param name="bounds">From the camera.</param>
    /// <param name="certain">It is wholly in the image and looking closer would not show it hidden.</param>
    /// <param name="place">Which one it is.</param>
    Visit Node(in TerrainNode node, in PolarBounds bounds, bool certain, NodePlace place);

    /// <summary>A facet that may be seen.</summary>
    /// <param name="part">Its part in the image, a convex polygon; m, MOON_ME.</param>
    /// <param name="bounds">The part's, from the camera.</param>
    /// <param name="facet">The whole facet.</param>
    Visit Facet(ReadOnlySpan<Vector3D> part, in PolarBounds bounds, in Facet facet);
}

/// <summary>A node of the summary's tree.</summary>
/// <param name="Depth">Index of its <see cref="ElevationSummary.Levels"/>; 0: a tile.</param>
/// <param name="Row">Row of that level, 0 northernmost.</param>
/// <param name="Column">Column of that level, 0 at longitude 0.</param>
internal readonly record struct NodePlace(int Depth, int Row, int Column);

/// <summary>What a visitor wants next.</summary>
internal enum Visit
{
    /// <summary>The parts of this node.</summary>
    Descend,

    /// <summary>Nothing more of this node.</summary>
    Skip,

    /// <summary>Nothing more at all.</summary>
    Stop,
}
