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
    private const double Growth = 0.03;

    /// <summary>Rows and columns of the image that are looked at to find the ground that it shows.</summary>
    private const int Looks = 64;

    /// <summary>Rows and columns of points at which each cell is looked at.</summary>
    private const int LooksOfCell = 2;

    /// <summary>Cells within which ground is looked at by rays instead.</summary>
    private const double CellsOfReach = 16.0;

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
    /// <param name="advance">Is told, from any thread, which further part of the work is done; null for nobody.</param>
    public static GroundLights Place(
        GroundTree tree, (Vector3D Middle, double Angle) view, Vector3D[] sunBodyFixed, int cells, int threads,
        CancellationToken cancellation, Action<double>? advance = null)
    {
        (double low, double high) = tree.Surface.RadiusLimits;
        double farthest = Math.Min(Math.PI, view.Angle + (2.0 * Math.Atan2(Math.Sqrt(Math.Max(0.0, (high - low) * (high + low))), low)));
        List<Cell> all = CellsOf(view.Angle, 2.0 * view.Angle / cells, farthest);
        all.Sort((one, other) => one.Order.CompareTo(other.Order));
        Ground?[] found = new Ground?[all.Count];
        LightFrame axes = new(view.Middle, Vector3D.UnitZ);
        int groups = (all.Count + Receivers.Size - 1) / Receivers.Size;
        WorkerTeam.Run(threads, groups, (_, group) =>
        {
            for (int i = group * Receivers.Size; i < Math.Min(all.Count, (group + 1) * Receivers.Size); i++)
            {
                found[i] = Look(tree, all[i], view.Middle, axes, sunBodyFixed);
            }

            advance?.Invoke(1.0 / groups);
        }, cancellation);

        Ground[] there = [.. found.OfType<Ground>()];
        GroundLights lights = new(there.Length) { ReachOfView = CellsOfReach * 2.0 * view.Angle / cells * high };
        for (int i = 0; i < there.Length; i++)
        {
            (lights.Points[i], lights.Normals[i], lights.Areas[i]) = (there[i].Point, there[i].Normal, there[i].Area);
            (lights.ToSun[i], lights.FromSun[i]) = (there[i].ToSun, there[i].FromSun);
            lights.Reaches[i] = CellsOfReach * there[i].Side * there[i].Point.Length;
        }

        return lights;
    }

    /// <summary>
    /// Looks at some points of a cell and takes one of them, the more likely the more sunlight falls on it; it stands for the area and for
    /// the sunlight of all. Null if there is no ground.
    /// </summary>
    private static Ground? Look(GroundTree tree, Cell cell, Vector3D middle, LightFrame axes, Vector3D[] sunBodyFixed)
    {
        (double low, double high) = tree.Surface.RadiusLimits;
        SplitMix64 random = SplitMix64.For(0, purpose: 31, cell.Number, 0);
        (Ground? taken, double area, double sunlight, int count) = (null, 0.0, 0.0, 0);
        for (int look = 0; look < LooksOfCell * LooksOfCell; look++)
        {
            double height = cell.First + ((look / LooksOfCell) + random.NextUniform()) / LooksOfCell * (cell.Last - cell.First); // as areas
            double turn = cell.Turn + (((look % LooksOfCell) + random.NextUniform()) / LooksOfCell * cell.TurnWidth);
            (double sine, double cosine) = Math.SinCos(2.0 * Math.PI * turn);
            double across = 2.0 * Math.Sqrt(height * (1.0 - height));
            Vector3D up = ((1.0 - (2.0 * height)) * middle) + (across * cosine * axes.AxisU) + (across * sine * axes.AxisV);
            Vector3D from = (high + 1.0) * up;
            double choice = random.NextUniform();
            if (tree.FirstGround(from, -up, high - (0.9 * low)) is not { } ground)
            {
                continue;
            }

            Vector3D point = from - (ground.Distance * up);
            Vector3D toSun = (sunBodyFixed[(cell.Number + look) % sunBodyFixed.Length] - point).Normalized();
            double incidence = Vector3D.Dot(ground.Normal, toSun);
            double ofPoint = cell.SolidAngle * point.LengthSquared * point.Length / Vector3D.Dot(ground.Normal, point);
            double light = incidence > 0.0 && !tree.IsBlocked(point, toSun, high) ? ofPoint * incidence : 0.0;
            (area, sunlight, count) = (area + ofPoint, sunlight + light, count + 1);
            if (taken is null || choice * sunlight < light)
            {
                taken = new Ground(point, ground.Normal, toSun, incidence, cell.Side, 0.0, 0.0);
            }
        }

        return taken is null ? null : taken with
        {
            Area = area / (LooksOfCell * LooksOfCell),
            FromSun = sunlight > 0.0 ? sunlight / (area * taken.Incidence) : 0.0,
        };
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
                (double sine, double cosine) = Math.SinCos(2.0 * Math.PI * (i + 0.5) / count);
                double across = Math.Sin(middle);
                cells.Add(new Cell(
                    cells.Count, first, last, (double)i / count, 1.0 / count, 4.0 * Math.PI * (last - first) / count, width,
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
    /// <param name="First">Square of the sine of half the angle from the view's middle to the ring's inner edge.</param>
    /// <param name="Last">The same to its outer edge.</param>
    /// <param name="Turn">Where on the ring the cell begins, 0 to 1.</param>
    /// <param name="TurnWidth">Its part of the ring.</param>
    /// <param name="SolidAngle">sr, seen from the body's centre.</param>
    /// <param name="Side">rad.</param>
    /// <param name="Order">By which cells are sorted.</param>
    private readonly record struct Cell(
        int Number, double First, double Last, double Turn, double TurnWidth, double SolidAngle, double Side, uint Order);

    /// <summary>The point that stands for the ground of a cell; its parts are those of <see cref="GroundLights"/>.</summary>
    private sealed record Ground(
        Vector3D Point, Vector3D Normal, Vector3D ToSun, double Incidence, double Side, double Area, double FromSun);
}
