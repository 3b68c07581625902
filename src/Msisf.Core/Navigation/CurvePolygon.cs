using Msisf.Core.Camera;

namespace Msisf.Core.Navigation;

/// <summary>Closed curves in an image, as polygons.</summary>
internal static class CurvePolygon
{
    /// <summary>Whether the inside of a polygon and an image have any point in common.</summary>
    /// <param name="polygon">Its corners in order.</param>
    /// <param name="width">Width of the image, px.</param>
    /// <param name="height">px.</param>
    public static bool Meets(ReadOnlySpan<RenderingPoint> polygon, int width, int height)
    {
        bool holdsCorner = false;
        for (int i = 0; i < polygon.Length; i++)
        {
            RenderingPoint from = polygon[i];
            RenderingPoint to = polygon[(i + 1) % polygon.Length];
            if (Crosses(from, to, width, height))
            {
                return true;
            }

            // A ray from the image's first corner to the right crosses the sides of a polygon around it an odd number of times.
            holdsCorner ^= (from.Y > 0.5) != (to.Y > 0.5)
                && from.X + ((0.5 - from.Y) / (to.Y - from.Y) * (to.X - from.X)) > 0.5;
        }

        return holdsCorner;
    }

    /// <summary>Whether a straight line has a point in the image (Liang and Barsky, ACM Trans. Graph. 3 (1984) 1).</summary>
    private static bool Crosses(RenderingPoint from, RenderingPoint to, int width, int height)
    {
        (double enter, double leave) = (0.0, 1.0);
        return Clip(from.X - to.X, from.X - 0.5, ref enter, ref leave)
            && Clip(to.X - from.X, width + 0.5 - from.X, ref enter, ref leave)
            && Clip(from.Y - to.Y, from.Y - 0.5, ref enter, ref leave)
            && Clip(to.Y - from.Y, height + 0.5 - from.Y, ref enter, ref leave);
    }

    private static bool Clip(double towards, double room, ref double enter, ref double leave)
    {
        if (towards == 0.0)
        {
            return room >= 0.0;
        }

        double at = room / towards;
        (enter, leave) = towards < 0.0 ? (Math.Max(enter, at), leave) : (enter, Math.Min(leave, at));
        return enter <= leave;
    }
}
