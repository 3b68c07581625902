using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Camera;

namespace Msisf.Core.Render.Visibility;

/// <summary>
/// Divides the image of a camera with a lens into tiles, in each of which a linear map puts the samples near the middles of their pixels.
/// </summary>
/// <param name="samples">Where its pixels sample the ideal image plane.</param>
internal sealed class LensTiling(CameraModel model, LensSamples samples)
{
    /// <summary>px: tiles are not halved below this side.</summary>
    private const int MinSide = 8;

    /// <summary>px: more than the rounding of a sample's column or row.</summary>
    private const double Rounding = 1e-9;

    /// <summary>Halves a rectangle until a linear map fits.</summary>
    /// <param name="maxMargin">px: maximum distance of a sample from its pixel's centre along columns or rows.</param>
    /// <param name="tiles">Receives the tiles.</param>
    public void Divide(PixelRange pixels, double maxMargin, List<LensTile> tiles)
    {
        LensTile tile = TileOf(pixels);
        (int width, int height) = (pixels.LastColumn - pixels.FirstColumn + 1, pixels.LastRow - pixels.FirstRow + 1);
        if (tile.Margin <= maxMargin || Math.Max(width, height) <= MinSide)
        {
            tiles.Add(tile);
            return;
        }

        if (width >= height)
        {
            int middle = pixels.FirstColumn + (width / 2);
            Divide(pixels with { LastColumn = middle - 1 }, maxMargin, tiles);
            Divide(pixels with { FirstColumn = middle }, maxMargin, tiles);
        }
        else
        {
            int middle = pixels.FirstRow + (height / 2);
            Divide(pixels with { LastRow = middle - 1 }, maxMargin, tiles);
            Divide(pixels with { FirstRow = middle }, maxMargin, tiles);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private LensTile TileOf(PixelRange pixels)
    {
        ImagePlaneMap map = MapOf(pixels);
        LaneRange across = LaneRange.Nothing;
        LaneRange down = LaneRange.Nothing;
        LaneRange right = LaneRange.Nothing;
        LaneRange below = LaneRange.Nothing;
        for (int row = pixels.FirstRow; row <= pixels.LastRow; row++)
        {
            int start = row * model.Width;
            for (int column = pixels.FirstColumn; column <= pixels.LastColumn; column += Vector512<double>.Count)
            {
                // The last vector goes back over pixels that were met already, or repeats the last one.
                int first = Math.Max(pixels.FirstColumn, Math.Min(column, pixels.LastColumn + 1 - Vector512<double>.Count));
                Vector512<double> columns = Vector512.Min(
                    Vector512.Create((double)first) + Vector512.Create(0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0),
                    Vector512.Create((double)pixels.LastColumn));
                Vector512<double> x = LensSamples.Read(samples.Right, start + first, start + pixels.LastColumn);
                Vector512<double> y = LensSamples.Read(samples.Down, start + first, start + pixels.LastColumn);
                across.Widen((map.ColumnPerRight * x) + (map.ColumnPerDown * y) + Vector512.Create(map.Column0) - columns);
                down.Widen((map.RowPerRight * x) + (map.RowPerDown * y) + Vector512.Create(map.Row0 - row));
                right.Widen(x);
                below.Widen(y);
            }
        }

        map = map with { Column0 = map.Column0 - across.Middle, Row0 = map.Row0 - down.Middle };
        return new LensTile(
            pixels, map, (0.5 * Math.Max(across.Width, down.Width)) + Rounding,
            new TangentBox(right.Min, below.Min, right.Max, below.Max));
    }

    /// <summary>The linear map that follows the lens from one side of a rectangle to the other.</summary>
    private ImagePlaneMap MapOf(PixelRange pixels)
    {
        double x = (0.5 * (pixels.FirstColumn + pixels.LastColumn)) + 1.0;
        double y = (0.5 * (pixels.FirstRow + pixels.LastRow)) + 1.0;

        // The chord over 0.7 of the side leaves the smallest greatest distance from a cubic.
        double across = Math.Max(0.5, 0.35 * (pixels.LastColumn - pixels.FirstColumn));
        double down = Math.Max(0.5, 0.35 * (pixels.LastRow - pixels.FirstRow));
        (double rightOfLeft, double downOfLeft) = model.ToIdeal(x - across, y);
        (double rightOfRight, double downOfRight) = model.ToIdeal(x + across, y);
        (double rightOfTop, double downOfTop) = model.ToIdeal(x, y - down);
        (double rightOfBottom, double downOfBottom) = model.ToIdeal(x, y + down);
        double a = (rightOfRight - rightOfLeft) / (2.0 * across);
        double b = (rightOfBottom - rightOfTop) / (2.0 * down);
        double c = (downOfRight - downOfLeft) / (2.0 * across);
        double d = (downOfBottom - downOfTop) / (2.0 * down);
        double determinant = (a * d) - (b * c);
        (double middleRight, double middleDown) = model.ToIdeal(x, y);
        ImagePlaneMap map = new(d / determinant, -b / determinant, 0.0, -c / determinant, a / determinant, 0.0);
        return map with
        {
            Column0 = x - 1.0 - map.Column(middleRight, middleDown),
            Row0 = y - 1.0 - map.Row(middleRight, middleDown),
        };
    }
}

/// <summary>Some pixels of an image with a lens, small enough that a linear map puts each sample near its pixel.</summary>
/// <param name="Map">
/// The linear map; it is not an approximation of the samples, which stay where they are, but the plane that is drawn in.
/// </param>
/// <param name="Margin">px: maximum distance of a sample from its pixel along columns or rows.</param>
/// <param name="Tangents">The samples lie in this part of the ideal image plane.</param>
internal sealed record LensTile(PixelRange Pixels, ImagePlaneMap Map, double Margin, TangentBox Tangents);
