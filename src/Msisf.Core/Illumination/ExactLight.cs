using System.Numerics;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Illumination;

/// <summary>
/// Decides by rays of the exact tracer whether any part of the Sun is in view. Rays are sent only where the stored horizon leaves it open.
/// Safe for several threads.
/// </summary>
/// <param name="sunBodyFixed">The Sun at each step, m, body-fixed.</param>
/// <param name="sunRadius">m; 0 for a point.</param>
internal sealed class ExactLight(IReadOnlyList<Vector3D> sunBodyFixed, double sunRadius)
{
    /// <summary>rad, 0.01 degrees: where the horizon is nearer to the Sun's edge, rays decide. It is twice the horizon's error.</summary>
    public const float Doubt = 1.75e-4f;

    /// <summary>Spaces between points of the upper half of the Sun's edge: what is seen first and last lies on the edge.</summary>
    private const int EdgeSpaces = 2048;

    private const int Lanes = 16;

    /// <summary>
    /// The points as cosine and sine from the right over the top to the left, the highest first: if any is free, one of the first mostly
    /// is. One is repeated, so that they are a multiple of sixteen.
    /// </summary>
    private static readonly (double Cosine, double Sine)[] Edge = [.. PointsOfEdge()];

    private static readonly float[] Cosines = [.. Edge.Select(point => (float)point.Cosine)];

    private static readonly float[] Sines = [.. Edge.Select(point => (float)point.Sine)];

    /// <summary>Whether any part of the Sun is in view of a place above the ground.</summary>
    /// <param name="rays">From the place.</param>
    /// <param name="tangents">Its horizon: the tangent at each column, after the last one that of the first again.</param>
    /// <param name="step">The step.</param>
    public bool IsVisible(PlaceRays rays, float[] tangents, int step) => IsVisible(rays, tangents, sunBodyFixed[step]);

    /// <summary>The same for a place of the Sun, m, body-fixed.</summary>
    public bool IsVisible(PlaceRays rays, float[] tangents, Vector3D sun)
    {
        LocalFrame frame = rays.Frame;
        Vector3D toSun = sun - frame.PositionBodyFixed;
        if (sunRadius == 0.0)
        {
            return rays.IsFree(toSun);
        }

        Vector3D across = Vector3D.Cross(toSun, frame.Up).Normalized();
        Vector3D up = Vector3D.Cross(across, toSun).Normalized();
        double distance = toSun.Length;
        double radius = distance * sunRadius / Math.Sqrt((distance - sunRadius) * (distance + sunRadius));
        Span<uint> open = stackalloc uint[Edge.Length / Lanes];
        double slope = radius / distance;
        if (IsOver(tangents, frame.ToLocal(toSun / distance), frame.ToLocal(slope * across), frame.ToLocal(slope * up), open))
        {
            return true;
        }

        for (int block = 0; block < open.Length; block++)
        {
            for (uint left = open[block]; left != 0; left &= left - 1)
            {
                (double cosine, double sine) = Edge[(block * Lanes) + BitOperations.TrailingZeroCount(left)];
                if (rays.IsFree(toSun + (radius * ((cosine * across) + (sine * up)))))
                {
                    return true;
                }
            }
        }

        return false;
    }

    /// <summary>Whether a point of the edge is over the stored horizon by more than its error.</summary>
    /// <param name="tangents">The horizon.</param>
    /// <param name="middle">Direction of the Sun along east, north and up, length 1.</param>
    /// <param name="right">From the middle to the right of the edge.</param>
    /// <param name="top">From the middle to the top of the edge.</param>
    /// <param name="open">If there is none, receives for each sixteen points those that are not below it by more than its error.</param>
    private static bool IsOver(float[] tangents, Vector3D middle, Vector3D right, Vector3D top, Span<uint> open)
    {
        for (int block = 0; block < open.Length; block++)
        {
            Vector512<float> cosine = ArrayLanes.Load(Cosines, block * Lanes);
            Vector512<float> sine = ArrayLanes.Load(Sines, block * Lanes);
            Vector512<float> east = Along(middle.X, right.X, top.X);
            Vector512<float> north = Along(middle.Y, right.Y, top.Y);
            Vector512<float> tangent = Along(middle.Z, right.Z, top.Z) / Vector512.Sqrt((east * east) + (north * north));
            Vector512<float> column = AzimuthLanes.Turns(east, north) * Vector512.Create((float)HorizonSurvey.Columns);
            Vector512<int> index = Vector512.ConvertToInt32(column) & Vector512.Create(HorizonSurvey.Columns - 1);
            Vector512<float> before = HorizonTable.Gather(tangents, index);
            Vector512<float> after = HorizonTable.Gather(tangents, index + Vector512<int>.One);
            Vector512<float> error = Vector512.Create(Doubt) * (Vector512<float>.One + (tangent * tangent));
            if (Vector512.GreaterThanAny(tangent - error, Vector512.MaxNative(before, after)))
            {
                return true;
            }

            open[block] = (uint)Vector512.GreaterThan(tangent + error, Vector512.MinNative(before, after)).ExtractMostSignificantBits();

            Vector512<float> Along(double middle, double right, double top) =>
                Vector512.Create((float)middle) + (Vector512.Create((float)right) * cosine) + (Vector512.Create((float)top) * sine);
        }

        return false;
    }

    private static IEnumerable<(double Cosine, double Sine)> PointsOfEdge()
    {
        List<int> points = [];
        for (int space = EdgeSpaces; space > 1; space /= 2)
        {
            points.AddRange(Enumerable.Range(0, EdgeSpaces / space).Select(number => (number * space) + (space / 2)));
        }

        points.AddRange(Enumerable.Repeat(0, Lanes));
        points.Add(EdgeSpaces);
        return points.Select(point =>
        {
            (double sine, double cosine) = Math.SinCos(Math.PI * point / EdgeSpaces);
            return (cosine, sine);
        });
    }
}
