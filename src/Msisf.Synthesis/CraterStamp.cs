using System.Runtime.Intrinsics;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;

namespace Msisf.Synthesis;

/// <summary>Adds a crater's profile to the samples of a block that it reaches.</summary>
internal static class CraterStamp
{
    private const int Lanes = 4;

    /// <summary>Adds one crater.</summary>
    /// <param name="crater">The crater, anywhere on the Moon; nothing is added if it does not reach the block.</param>
    /// <param name="frame">The block, at most 180 degrees wide.</param>
    /// <param name="heights">m, lines of the frame's stride.</param>
    public static void AddTo(Crater crater, TileFrame frame, Span<float> heights)
    {
        CraterProfile profile = new(crater);
        double radius = crater.Radius / MoonConstants.ReferenceRadius;
        double reach = Crater.Reach * radius;
        (double sinLongitude, double cosLongitude) = PortableMath.SinCosDegrees(crater.LongitudeDegrees);
        Vector256<double> x = Vector256.Create(crater.CosLatitude * cosLongitude);
        Vector256<double> y = Vector256.Create(crater.CosLatitude * sinLongitude);
        Vector256<double> scale = Vector256.Create(2.0 / (radius * radius));
        (int firstLine, int lastLine) = LinesReached(crater, frame, reach);
        for (int line = firstLine; line <= lastLine; line++)
        {
            (int first, int last) = ColumnsReached(crater, frame, line, reach);
            Vector256<double> cos = Vector256.Create(frame.CosLatitude[line]);
            Vector256<double> along = Vector256.Create(1.0 - (crater.SinLatitude * frame.SinLatitude[line]));
            Span<float> row = heights.Slice(line * frame.Stride, frame.Stride);
            for (int column = first / Lanes * Lanes; column <= last; column += Lanes)
            {
                // The squared chord between two unit vectors is 2 - 2 u.v.
                Vector256<double> across = (x * Vector256.Create(frame.CosLongitude.AsSpan(column)))
                    + (y * Vector256.Create(frame.SinLongitude.AsSpan(column)));
                Vector256<double> square = Vector256.Max((along - (cos * across)) * scale, Vector256<double>.Zero);
                Vector256<double> height = profile.HeightAt(square);
                Span<float> four = row.Slice(column, Lanes);
                Vector128<float> sum = Vector128.Create((ReadOnlySpan<float>)four)
                    + Vector128.Narrow(height.GetLower(), height.GetUpper());
                sum.CopyTo(four);
            }
        }
    }

    // Beyond its reach a profile is exactly 0, so these ranges may be too wide by a sample, never too narrow.
    private static (int First, int Last) LinesReached(Crater crater, TileFrame frame, double reach)
    {
        double degrees = (reach * (180.0 / Math.PI) * 1.01) + (1.0 / frame.PixelsPerDegree);
        double latitude = crater.LatitudeDegrees;
        double north = latitude + degrees;
        double south = latitude - degrees;

        // A mirror line beyond a pole has the latitude +-180 - latitude.
        if (frame.FirstLine < 0)
        {
            north = Math.Max(north, 180.0 - south);
        }

        if (frame.FirstLine + frame.Lines > 180 * frame.PixelsPerDegree)
        {
            south = Math.Min(south, -180.0 - north);
        }

        double first = ((90.0 - north) * frame.PixelsPerDegree) - 0.5 - frame.FirstLine;
        double last = ((90.0 - south) * frame.PixelsPerDegree) - 0.5 - frame.FirstLine;
        return ((int)Math.Clamp(first, 0.0, frame.Lines), (int)Math.Clamp(last, -1.0, frame.Lines - 1));
    }

    private static (int First, int Last) ColumnsReached(Crater crater, TileFrame frame, int line, double reach)
    {
        // The crater reaches columns where cos(longitude difference) >= bound.
        double product = frame.CosLatitude[line] * crater.CosLatitude;
        double min = 1.0 - (0.5 * reach * reach * 1.01) - (crater.SinLatitude * frame.SinLatitude[line]);
        double bound = min / Math.Abs(product);
        if (bound > 1.0)
        {
            return (0, -1);
        }

        if (!(bound > 0.0))
        {
            return (0, frame.Samples - 1);
        }

        double half = Math.Atan2(Math.Sqrt((1.0 - bound) * (1.0 + bound)), bound) * (180.0 / Math.PI) * frame.PixelsPerDegree;
        double centre = ((crater.LongitudeDegrees + (product < 0.0 ? 180.0 : 0.0)) * frame.PixelsPerDegree) - 0.5 - frame.FirstSample;

        // Adds whole turns so that the centre is as near as possible to the block's middle.
        double around = 360.0 * frame.PixelsPerDegree;
        centre -= around * Math.Floor(((centre - (0.5 * frame.Samples)) / around) + 0.5);
        return (
            (int)Math.Clamp(centre - half - 1.0, 0.0, frame.Samples),
            (int)Math.Clamp(centre + half + 1.0, -1.0, frame.Samples - 1));
    }
}
