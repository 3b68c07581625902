using Msisf.Core.Numerics;
using Msisf.Core.Surface;

namespace Msisf.Core.Tiles.Selection;

/// <summary>Finds out whether any part of a tile may be seen, and whether in sunlight.</summary>
/// <param name="sun">The Moon from the Sun; null if the light is at the camera.</param>
internal sealed class VisibleTileVisitor(SunView? sun) : ISightVisitor
{
    /// <summary>Whether part of the tile may be seen in sunlight.</summary>
    public bool SeenLit { get; private set; }

    /// <summary>Whether a dark part of the tile may be seen.</summary>
    public bool SeenDark { get; private set; }

    public Visit Node(in SeenNode seen)
    {
        PolarBounds? fromSun = sun?.View.Bounds(seen.Node);
        if (fromSun is { } bounds && sun!.Map.Hides(bounds))
        {
            SeenDark |= seen.IsCertain;
            return SeenDark ? Visit.Skip : Visit.Descend;
        }

        SeenLit |= seen.IsCertain && (fromSun is not { } lit || sun!.Map.NeverHides(lit));
        return SeenLit ? Visit.Stop : Visit.Descend;
    }

    public Visit Facet(ReadOnlySpan<Vector3D> part, in PolarBounds bounds, in Facet facet)
    {
        bool isDark = sun is not null && (facet.TurnsAwayFrom(sun.Position) || sun.Map.Hides(sun.View.Bounds(part)));
        SeenDark |= isDark;
        SeenLit |= !isDark;
        return isDark ? Visit.Descend : Visit.Stop;
    }
}
