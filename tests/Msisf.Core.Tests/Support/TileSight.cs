using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Surface;
using Msisf.Core.Tiles;

namespace Msisf.Core.Tests.Support;

/// <summary>Whether anything of a tile can be seen, by rays to points of its facets at 4 px/deg.</summary>
internal static class TileSight
{
    private const int Cells = 20;

    public static bool IsSeen(BruteForceMoon moon, PinholeCamera camera, TileId tile)
    {
        int tileRow = (85 - tile.SouthDegrees) / 5;
        int firstRow = tileRow == 0 ? 0 : (tileRow * Cells) + 1;
        int endRow = ((tileRow + 1) * Cells) + 1;
        for (int row = firstRow; row < endRow; row++)
        {
            for (int column = tile.WestDegrees * 4; column < (tile.WestDegrees + 5) * 4; column++)
            {
                if (IsFacetSeen(moon, camera, row, column, 0) || IsFacetSeen(moon, camera, row, column, 1))
                {
                    return true;
                }
            }
        }

        return false;
    }

    private static bool IsFacetSeen(BruteForceMoon moon, PinholeCamera camera, int row, int column, int half)
    {
        (Vector3D a, Vector3D b, Vector3D c) = moon.Corners(row, column, half);
        Vector3D middle = (a + b + c) / 3.0;
        if (a == b || b == c || c == a || Vector3D.Dot(moon.Normal(new(row, column, half)), middle - camera.PositionBodyFixed) >= 0.0)
        {
            return false;
        }

        // The middle, and points just inside the corners and the sides.
        const double Inside = 0.98;
        return new[] { middle, a, b, c, (a + b) / 2.0, (b + c) / 2.0, (c + a) / 2.0 }
            .Select(point => middle + (Inside * (point - middle)))
            .Any(point => IsPointSeen(moon, camera, point, (row, column, half)));
    }

    private static bool IsPointSeen(BruteForceMoon moon, PinholeCamera camera, Vector3D point, (int Row, int Column, int Half) facet)
    {
        Vector3D toPoint = point - camera.PositionBodyFixed;
        double depth = Vector3D.Dot(toPoint, camera.ForwardBodyFixed) / camera.Direction.Length;
        return depth > 0.0
            && Math.Abs(Vector3D.Dot(toPoint, camera.Right)) / camera.Right.LengthSquared <= 0.5 * depth
            && Math.Abs(Vector3D.Dot(toPoint, camera.Up)) <= 0.5 * depth
            && moon.FirstHit(camera.PositionBodyFixed, toPoint)?.Facet == new BruteForceMoon.FacetId(facet.Row, facet.Column, facet.Half);
    }
}
