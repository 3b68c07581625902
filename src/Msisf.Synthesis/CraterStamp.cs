using System.Runtime.Intrinsics;
using Msisf.Core.Terrain;

namespace Msisf.Synthesis;

/// <summary>Adds a crater's profile to the samples that it reaches, of a block of latitude and longitude or of a polar map.</summary>
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

    /// <summary>Adds one crater to a block of a polar map.</summary>
    /// <param name="crater">The crater, anywhere on the Moon; nothing is added if it does not reach the block.</param>
    /// <param name="frame">The block.</param>
    /// <param name="heights">m, as the frame's directions.</param>
    public static void AddTo(in PlacedCrater crater, MapFrame frame, Span<float> heights)
    {
        if (Reached(crater.Direction, Crater.Reach * crater.Radius, frame) is not { } reached)
        {
            return;
        }

        int first = reached.FirstSample / Lanes * Lanes;
        int firstOfAll = (reached.FirstLine * frame.Stride) + first;
        AddTo(
            crater, frame.X.AsSpan(firstOfAll), frame.Y.AsSpan(firstOfAll), frame.Z.AsSpan(firstOfAll), heights[firstOfAll..],
            reached.LastLine + 1 - reached.FirstLine, frame.Stride, reached.LastSample + 1 - first);
    }

    /// <summary>Adds one crater at any places.</summary>
    /// <param name="crater">The crater.</param>
    /// <param name="x">x of their directions, body-fixed.</param>
    /// <param name="y">y of the directions.</param>
    /// <param name="z">z of the directions.</param>
    /// <param name="heights">m.</param>
    /// <param name="lines">Lines of places.</param>
    /// <param name="stride">From one line to the next; a multiple of four.</param>
    /// <param name="count">Places of a line.</param>
    public static void AddTo(
        in PlacedCrater crater, ReadOnlySpan<double> x, ReadOnlySpan<double> y, ReadOnlySpan<double> z, Span<float> heights, int lines,
        int stride, int count)
    {
        CraterProfile profile = crater.Profile;
        Vector256<double> centreX = Vector256.Create(crater.Direction.X);
        Vector256<double> centreY = Vector256.Create(crater.Direction.Y);
        Vector256<double> centreZ = Vector256.Create(crater.Direction.Z);
        Vector256<double> scale = Vector256.Create(1.0 / (crater.Radius * crater.Radius));
        for (int line = 0; line < lines; line++)
        {
            for (int at = line * stride; at < (line * stride) + count; at += Lanes)
            {
                Vector256<double> dx = Vector256.Create(x[at..]) - centreX;
                Vector256<double> dy = Vector256.Create(y[at..]) - centreY;
                Vector256<double> dz = Vector256.Create(z[at..]) - centreZ;
                Vector256<double> height = profile.HeightAt(((dx * dx) + (dy * dy) + (dz * dz)) * scale);
                Span<float> four = heights.Slice(at, Lanes);
                (Vector128.Create((ReadOnlySpan<float>)four) + Vector128.Narrow(height.GetLower(), height.GetUpper())).CopyTo(four);
            }
        }
    }

    /// <summary>The lines and samples of the block that the crater may reach; beyond its reach a profile is exactly 0.</summary>
    /// <param name="centre">Direction of the middle of what reaches them, length 1.</param>
    /// <param name="reach">How far it reaches, radii of the Moon.</param>
    /// <param name="frame">The block.</param>
    public static (int FirstLine, int LastLine, int FirstSample, int LastSample)? Reached(Vector3D centre, double reach, MapFrame frame)
    {
        if ((centre - frame.Middle).LengthSquared > (reach + frame.Farthest) * (reach + frame.Farthest))
        {
            return null;
        }

        // A chord c of the unit sphere is sqrt((1 + s) (1 + t)) / 2 c long on the map, in 2 R, with s and t of its two ends, of which
        // those of the map are at most 1/2.
        PolarStereographic map = frame.Projection;
        Vector3D onMap = map.ToMap(centre);
        double scale = 2.0 / (1.0 + (map.PoleSign * onMap.Z));
        if (!(scale < 2.0))
        {
            return null; // on the other hemisphere, from where only what is wider than a map reaches one
        }

        double perRadius = MoonConstants.ReferenceRadius / map.MetresPerPixel;
        double line = map.LineOffset + (map.PoleSign * scale * perRadius * onMap.X);
        double sample = map.SampleOffset + (scale * perRadius * onMap.Y);
        double pixels = 1.0 + (reach * Math.Sqrt(1.5 * scale) * perRadius);
        int firstLine = (int)Math.Clamp(Math.Ceiling(line - pixels) - frame.FirstLine, 0.0, frame.Lines);
        int lastLine = (int)Math.Clamp(Math.Floor(line + pixels) - frame.FirstLine, -1.0, frame.Lines - 1);
        int firstSample = (int)Math.Clamp(Math.Ceiling(sample - pixels) - frame.FirstSample, 0.0, frame.Stride);
        int lastSample = (int)Math.Clamp(Math.Floor(sample + pixels) - frame.FirstSample, -1.0, frame.Stride - 1);
        return firstLine <= lastLine && firstSample <= lastSample ? (firstLine, lastLine, firstSample, lastSample) : null;
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
