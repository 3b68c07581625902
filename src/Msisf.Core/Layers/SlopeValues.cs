using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Layers;

/// <summary>Layer values of the surface's inclination against the sphere.</summary>
internal static class SlopeValues
{
    /// <summary>Pixels that are computed at once; a multiple of eight.</summary>
    private const int Block = 256;

    /// <summary>Degrees between the normal and the radius.</summary>
    public static void Slope(LayerRow row, int plane, double[] values) =>
        RowGeometry.FindExactAngles(row.Normals, row.NormalLengths, row.Points, row.Radii, row.Count, values);

    /// <summary>Degrees from north over east to the direction in which the ground falls.</summary>
    public static void Aspect(LayerRow row, int plane, double[] values)
    {
        Span<double> toNorth = stackalloc double[Block];
        Span<double> eastLengths = stackalloc double[Block];
        Span<double> falls = stackalloc double[Block];
        for (int first = 0; first < row.Count; first += Block)
        {
            int count = Math.Min(Block, row.Count - first);
            FindFall(row, first, count, values, toNorth, eastLengths, falls);
            for (int i = 0; i < count; i++)
            {
                // The polar axis has no north, and level ground does not fall.
                bool isDefined = eastLengths[i] >= Tolerances.ParallelSine && falls[i] >= Tolerances.LevelSlope * eastLengths[i];
                values[first + i] = isDefined ? Azimuth(values[first + i], toNorth[i]) : double.NaN;
            }
        }
    }

    /// <summary>Degrees between the radius and the direction to the Sun.</summary>
    public static void SphereIncidence(LayerRow row, int plane, double[] values) =>
        RowGeometry.FindExactAngles(row.Points, row.Radii, row.ToLight, row.LightDistances, row.Count, values);

    /// <summary>Finds the horizontal parts of the outward normals, which lead downhill.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first rows would else be computed with unoptimised vectors
    private static void FindFall(
        LayerRow row, int first, int count, double[] toEast, Span<double> toNorth, Span<double> eastLengths, Span<double> falls)
    {
        double[] radii = row.Radii;
        for (int i = 0; i < count; i += Vector512<double>.Count)
        {
            LaneVector up = LaneVector.Load(row.Points, first + i) / LaneVector.Load(radii, first + i);
            LaneVector east = LaneVector.Cross(LaneVector.All(Vector3D.UnitZ), up);
            LaneVector north = LaneVector.Cross(up, east);
            LaneVector normal = LaneVector.Load(row.Normals, first + i);
            Vector512<double> alongEast = LaneVector.Dot(normal, east);
            Vector512<double> alongNorth = LaneVector.Dot(normal, north);
            LaneVector.Store(alongEast, toEast, first + i);
            alongNorth.CopyTo(toNorth[i..]);
            LaneHypot.Of(LaneHypot.Of(east.X, east.Y), east.Z).CopyTo(eastLengths[i..]);
            LaneHypot.Of(alongEast, alongNorth).CopyTo(falls[i..]);
        }
    }

    private static double Azimuth(double toEast, double toNorth)
    {
        double azimuth = double.RadiansToDegrees(Math.Atan2(toEast, toNorth));
        return azimuth < 0.0 ? Math.Min(azimuth + 360.0, Math.BitDecrement(360.0)) : azimuth;
    }
}
