using Msisf.Core.Numerics;
using Msisf.Core.Parallel;
using Msisf.Core.Render.Shadows;
using Msisf.Core.Render.Visibility;

namespace Msisf.Core.Render.Indirect;

/// <summary>
/// Places points on the ground that stand for all of it around a view: in the view on rings of equal cells, around it on rings of cells
/// that grow with the distance, as far as ground can be seen from the view over the horizon.
/// </summary>
internal static class GroundPlacing
{
    /// <summary>Side of a cell around the view over its distance from the view.</summary>
    private const double Growth = 0.04;

    /// <summary>Rows and columns of the image that are looked at to find the ground that it shows.</summary>
    private const int Looks = 64;

    /// <summary>Cells within which ground is looked at by rays instead.</summary>
    private const double CellsOfReach = 8.0;

    /// <summary>Least angle of a view, rad: a single pixel.</summary>
    private const double LeastAngle = 1e-7;

    /// <summary>The view as a cap on the body.</summary>
    public static (Vector3D Middle, double Angle)? FindView(ISurfaceRows image)
    {
        SurfaceRow row = new();
        List<Vector3D> seen = [];
        for (int y = 0; y < image.Height; y += Math.Max(1, image.Height / Looks))
        {
            image.Read(y + 1, row);
            for (int i = 0; i < row.Count; i += Math.Max(1, image.Width / Looks))
            {
                seen.Add(new Vector3D(row.X[i], row.Y[i], row.Z[i]).Normalized());
            }
        }

        if (seen.Count == 0)
        {
            return null;
        }

        Vector3D sum = default;
        seen.ForEach(direction => sum += direction);
        Vector3D middle = sum.Normalized();
        return (middle, Math.Max(LeastAngle, 1.05 * seen.Max(direction => Vector3D.AngleBetween(middle, direction))));
    }

    /// <summary>Places the points and finds the Sun's light on them.</summary>
    /// <param name="tree">The ground.</param>
    /// <param name="view">The view.</param>
    /// <param name="sunBodyFixed">The Sun, or points of its disc, m, body-fixed.</param>
    /// <param name="cells">Cells across the view.</param>
    /// <param name="threads">Maximum number of threads.</param>
    /// <param name="cancellation">Cancels the work.</param>
    public static GroundLights Place(
        GroundTree tree, (Vector3D Middle, double Angle) view, Vector3D[] sunBodyFixed, int cells, int threads,
        CancellationToken cancellation)
    {
        (double low, double high) = tree.Surface.RadiusLimits;
        double farthest = Math.Min(Math.PI, view.Angle + (2.0 * Math.Atan2(Math.Sqrt(Math.Max(0.0, (high - low) * (high + low))), low)));
        List<Cell> all = CellsOf(view.Angle, 2.0 * view.Angle / cells, farthest);
        all.Sort((one, other) => one.Order.CompareTo(other.Order));
        (Vector3D Point, Vector3D Normal)[] found = new (Vector3D, Vector3D)[all.Count];
        LightFrame axes = new(view.Middle, Vector3D.UnitZ);
        WorkerTeam.Run(threads, (all.Count + Receivers.Size - 1) / Receivers.Size, (_, group) =>
        {
            for (int i = group * Receivers.Size; i < Math.Min(all.Count, (group + 1) * Receivers.Size); i++)
            {
                Vector3D up = (all[i].Along * view.Middle) + (all[i].AcrossU * axes.AxisU) + (all[i].AcrossV * axes.AxisV);
                Vector3D from = (high + 1.0) * up;
                if (tree.FirstGround(from, -up, high - (0.9 * low)) is { } ground)
                {
                    found[i] = (from - (ground.Distance * up), ground.Normal);
                }
            }
        }, cancellation);

        int[] there = [.. Enumerable.Range(0, all.Count).Where(i => found[i].Point != default)];
        GroundLights lights = new(there.Length) { ReachOfView = CellsOfReach * 2.0 * view.Angle / cells * high };
        WorkerTeam.Run(threads, (there.Length + Receivers.Size - 1) / Receivers.Size, (_, group) =>
        {
            for (int i = group * Receivers.Size; i < Math.Min(there.Length, (group + 1) * Receivers.Size); i++)
            {
                (Vector3D point, Vector3D normal) = found[there[i]];
                Cell cell = all[there[i]];
                (lights.Points[i], lights.Normals[i]) = (point, normal);
                lights.Areas[i] = cell.SolidAngle * point.LengthSquared * point.Length / Vector3D.Dot(normal, point);
                lights.Reaches[i] = CellsOfReach * cell.Side * point.Length;
                Vector3D toSun = (sunBodyFixed[cell.Number % sunBodyFixed.Length] - point).Normalized();
                lights.ToSun[i] = toSun;
                lights.IsLit[i] = Vector3D.Dot(normal, toSun) > 0.0 && !tree.IsBlocked(point, toSun, high);
            }
        }, cancellation);
        return lights;
    }

    private static List<Cell> CellsOf(double view, double side, double farthest)
    {
        List<Cell> cells = [];
        double inner = 0.0;
        while (inner < farthest)
        {
            double width = side + (Growth * Math.Max(0.0, inner - view));
            double outer = Math.Min(farthest, inner + width);
            double middle = 0.5 * (inner + outer);
            (double first, double last) = (SquaredSine(0.5 * inner), SquaredSine(0.5 * outer));
            int count = Math.Max(3, (int)Math.Round(2.0 * Math.PI * Math.Sin(middle) / width));
            for (int i = 0; i < count; i++)
            {
                SplitMix64 random = SplitMix64.For(0, purpose: 31, cells.Count, 0);
                double height = first + (random.NextUniform() * (last - first)); // areas on the sphere are in proportion to it
                (double sine, double cosine) = Math.SinCos(2.0 * Math.PI * (i + random.NextUniform()) / count);
                double across = 2.0 * Math.Sqrt(height * (1.0 - height));
                cells.Add(new Cell(
                    cells.Count, 1.0 - (2.0 * height), across * cosine, across * sine, 4.0 * Math.PI * (last - first) / count, width,
                    Interleaved(across * cosine, across * sine, Math.Sin(Math.Min(farthest, 0.5 * Math.PI)))));
            }

            inner = outer;
        }

        return cells;
    }

    private static double SquaredSine(double angle) => Math.Sin(angle) * Math.Sin(angle);

    /// <summary>The bits of two coordinates by turns: near numbers are mostly near places.</summary>
    private static uint Interleaved(double u, double v, double largest)
    {
        uint Bits(double part) => (uint)Math.Clamp((part / largest * 32768.0) + 32768.0, 0.0, 65535.0);
        (uint x, uint y, uint mixed) = (Bits(u), Bits(v), 0);
        for (int bit = 0; bit < 16; bit++)
        {
            mixed |= (((x >> bit) & 1) << (2 * bit)) | (((y >> bit) & 1) << ((2 * bit) + 1));
        }

        return mixed;
    }

    /// <summary>A cell of a ring.</summary>
    /// <param name="Number">Its number.</param>
    /// <param name="Along">Direction of its point along the view's middle.</param>
    /// <param name="AcrossU">Across it.</param>
    /// <param name="AcrossV">Across it.</param>
    /// <param name="SolidAngle">sr, seen from the body's centre.</param>
    /// <param name="Side">rad.</param>
    /// <param name="Order">By which cells are sorted.</param>
    private readonly record struct Cell(
        int Number, double Along, double AcrossU, double AcrossV, double SolidAngle, double Side, uint Order);
}
