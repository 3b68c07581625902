using System.Runtime.Intrinsics;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;

namespace Msisf.Synthesis;

/// <summary>Adds a crater's profile to the samples of a block of a polar map that it reaches.</summary>
internal static class MapCraterStamp
{
    private const int Lanes = 4;

    /// <summary>Adds one crater.</summary>
    /// <param name="crater">The crater, anywhere on the Moon; nothing is added if it does not reach the block.</param>
    /// <param name="frame">The block.</param>
    /// <param name="heights">m, as the frame's directions.</param>
    public static void AddTo(in PlacedCrater crater, MapFrame frame, Span<float> heights)
    {
        double radius = crater.Radius;
        Vector3D centre = crater.Direction;
        if (Reached(centre, Crater.Reach * radius, frame) is not { } reached)
        {
            return;
        }

        CraterProfile profile = crater.Profile;
        Vector256<double> x = Vector256.Create(centre.X);
        Vector256<double> y = Vector256.Create(centre.Y);
        Vector256<double> z = Vector256.Create(centre.Z);
        Vector256<double> scale = Vector256.Create(1.0 / (radius * radius));
        for (int line = reached.FirstLine; line <= reached.LastLine; line++)
        {
            for (int sample = reached.FirstSample / Lanes * Lanes; sample <= reached.LastSample; sample += Lanes)
            {
                int at = (line * frame.Stride) + sample;
                Vector256<double> dx = Vector256.Create(frame.X.AsSpan(at)) - x;
                Vector256<double> dy = Vector256.Create(frame.Y.AsSpan(at)) - y;
                Vector256<double> dz = Vector256.Create(frame.Z.AsSpan(at)) - z;
                Vector256<double> height = profile.HeightAt(((dx * dx) + (dy * dy) + (dz * dz)) * scale);
                Span<float> four = heights.Slice(at, Lanes);
                (Vector128.Create((ReadOnlySpan<float>)four) + Vector128.Narrow(height.GetLower(), height.GetUpper())).CopyTo(four);
            }
        }
    }

    /// <summary>The lines and samples of the block that the crater may reach; beyond its reach a profile is exactly 0.</summary>
    /// <param name="centre">Direction of the middle of what reaches them.</param>
    /// <param name="reach">How far it reaches, radii of the Moon.</param>
    /// <param name="frame">The block.</param>
    public static (int FirstLine, int LastLine, int FirstSample, int LastSample)? Reached(Vector3D centre, double reach, MapFrame frame)
    {
        // A chord c of the unit sphere is sqrt((1 + s) (1 + t)) / 2 c long on the map, in 2 R, with s and t of its two ends, of which
        // those of the map are at most 1/2.
        double s = (2.0 / (1.0 + (frame.Projection.PoleSign * frame.Projection.ToMap(centre).Z))) - 1.0;
        if (!(s < 1.0))
        {
            return null; // on the other hemisphere, from where only what is wider than a map reaches one
        }

        (double line, double sample) = frame.Projection.PixelOf(centre);
        double pixels = 1.0 + (reach * Math.Sqrt(1.5 * (1.0 + s)) * MoonConstants.ReferenceRadius / frame.Projection.MetresPerPixel);
        int firstLine = (int)Math.Clamp(Math.Ceiling(line - pixels) - frame.FirstLine, 0.0, frame.Lines);
        int lastLine = (int)Math.Clamp(Math.Floor(line + pixels) - frame.FirstLine, -1.0, frame.Lines - 1);
        int firstSample = (int)Math.Clamp(Math.Ceiling(sample - pixels) - frame.FirstSample, 0.0, frame.Stride);
        int lastSample = (int)Math.Clamp(Math.Floor(sample + pixels) - frame.FirstSample, -1.0, frame.Stride - 1);
        return firstLine <= lastLine && firstSample <= lastSample ? (firstLine, lastLine, firstSample, lastSample) : null;
    }
}
