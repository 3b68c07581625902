using Msisf.Core.Camera;
using Msisf.Core.Numerics;

namespace Msisf.Core.Blocks;

/// <summary>How far from the camera some boxes reach, in the cells of a grid over its image.</summary>
/// <param name="frustum">What the image shows.</param>
internal sealed class CoverGrid(ViewFrustum frustum)
{
    /// <summary>Cells along each edge: more than there are nodes along the edge of most images.</summary>
    private const int Size = 128;

    private readonly double[] _farthest = new double[Size * Size];

    /// <summary>Notes a box.</summary>
    public void Add(in OrientedBox box)
    {
        (double distance, double reach) = DistanceOf(box);
        if (TryFindCells(box, out (int Left, int Top, int Right, int Bottom) cells))
        {
            for (int row = cells.Top; row <= cells.Bottom; row++)
            {
                for (int column = cells.Left; column <= cells.Right; column++)
                {
                    ref double farthest = ref _farthest[(row * Size) + column];
                    farthest = Math.Max(farthest, distance + reach);
                }
            }
        }
    }

    /// <summary>Whether a ray of the image may meet a box before one that was noted.</summary>
    public bool IsAnyBehind(in OrientedBox box)
    {
        (double distance, double reach) = DistanceOf(box);
        if (TryFindCells(box, out (int Left, int Top, int Right, int Bottom) cells))
        {
            for (int row = cells.Top; row <= cells.Bottom; row++)
            {
                if (_farthest.AsSpan((row * Size) + cells.Left, cells.Right - cells.Left + 1).ContainsAnyInRange(
                    Math.Max(distance - reach, double.Epsilon), double.PositiveInfinity))
                {
                    return true;
                }
            }
        }

        return false;
    }

    private (double Distance, double Reach) DistanceOf(in OrientedBox box) =>
        ((box.Centre - frustum.CameraBodyFixed).Length, (box.HalfX + box.HalfY + box.HalfZ).Length);

    private bool TryFindCells(in OrientedBox box, out (int Left, int Top, int Right, int Bottom) cells)
    {
        cells = default;
        if (!frustum.TryFindRows(box, out _))
        {
            return false;
        }

        TangentBox image = frustum.Tangents;
        TangentBox tangents = frustum.TangentsOf(box);
        cells = (
            CellOf(tangents.Left, image.Left, image.Right), CellOf(tangents.Top, image.Top, image.Bottom),
            CellOf(tangents.Right, image.Left, image.Right), CellOf(tangents.Bottom, image.Top, image.Bottom));
        return true;
    }

    private static int CellOf(double tangent, double first, double last) =>
        (int)Math.Clamp(Math.Floor((tangent - first) / (last - first) * Size), 0.0, Size - 1.0);
}
