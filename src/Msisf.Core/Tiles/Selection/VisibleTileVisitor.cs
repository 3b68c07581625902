using Msisf.Core.Numerics;
using Msisf.Core.Surface;

namespace Msisf.Core.Tiles.Selection;

/// <summary>Finds out whether any part of a tile may be seen, and whether in sunlight.</summary>
internal sealed class VisibleTileVisitor : ISurfaceVisitor
{
    private readonly SunView? _sun;

    /// <param name="sun">The Moon from the Sun; null if the light is at the camera.</param>
    public VisibleTileVisitor(SunView? sun) => _sun = sun;

    /// <summary>Whether part of the tile may be seen in sunlight.</summary>
    public bool SeenLit { get; private set; }

    /// <summary>Whether a dark part of the tile may be seen.</summary>
    public bool SeenDark { get; private set; }

    /// <summary>Prepares for the next tile.</summary>
    public void Reset() => (SeenLit, SeenDark) = (false, false);

    public Visit Node(in TerrainNode node, in PolarBounds bounds, bool certain, NodePlace place)
    {
        if (_sun is null)
        {
            SeenLit |= certain;
            return certain ? Visit.Stop : Visit.Descend;
        }

        PolarBounds fromSun = _sun.View.Bounds(node);
        if (_sun.Map.Hides(fromSun))
        {
            SeenDark |= certain;
            return SeenDark ? Visit.Skip : Visit.Descend;
        }

        SeenLit |= certain && _sun.Map.NeverHides(fromSun);
        return SeenLit ? Visit.Stop : Visit.Descend;
    }

    public Visit Facet(ReadOnlySpan<Vector3D> part, in PolarBounds bounds, in Facet facet)
    {
        if (_sun is not null && (facet.TurnsAwayFrom(_sun.Position) || _sun.Map.Hides(SurfaceWalk.BoundsOf(_sun.View, part))))
        {
            SeenDark = true;
            return Visit.Descend;
        }

        SeenLit = true;
        return Visit.Stop;
    }
}
