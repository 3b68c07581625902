using Msisf.Core.Camera;
using Msisf.Core.Parallel;
using Msisf.Core.Render;
using Msisf.Core.Tracing;

namespace Msisf.Core.Navigation;

/// <summary>Reads from a drawn frame which parts of craters are hidden and lit, and which crater each pixel shows.</summary>
public static class CraterPixels
{
    /// <summary>
    /// Pixels of an ellipse of which the parts are counted: of larger ellipses those of a wider grid, which tells a part to about 0.02.
    /// </summary>
    private const double PixelsOfParts = 200.0;

    /// <summary>The craters with their hidden and lit parts.</summary>
    public static CratersOfFrame WithParts(CratersOfFrame craters, IGroundTruth frame) =>
        craters with { Views = [.. craters.Views.Select(view => WithParts(view, frame))] };

    /// <summary>
    /// The <see cref="Crater.Number"/> of the crater that each pixel shows, by rows; 0 for none. The smallest in the image counts: a
    /// pixel shows a crater if its centre lies in the crater's ellipse and the terrain there does not hide the crater's disc.
    /// </summary>
    public static int[] NumbersOf(CratersOfFrame craters, IGroundTruth frame, int threads, CancellationToken cancellation = default)
    {
        ICamera camera = frame.Camera;
        CraterView[] largestFirst = [.. craters.Views.OrderByDescending(view => view.Ellipse.Area).ThenBy(view => view.Crater.Number)];
        int[] numbers = new int[camera.Width * camera.Height];
        TruthRow[] rows = [.. Enumerable.Range(0, threads).Select(_ => new TruthRow())];
        WorkerTeam.Run(
            threads,
            camera.Height,
            (worker, row) => MarkRow(largestFirst, frame, row + 1, rows[worker], numbers.AsSpan(row * camera.Width, camera.Width)),
            cancellation);
        return numbers;
    }

    private static void MarkRow(CraterView[] largestFirst, IGroundTruth frame, int y, TruthRow row, Span<int> numbers)
    {
        frame.ReadRow(y, row);
        ReadOnlySpan<int> columns = row.Points.Columns.AsSpan(0, row.Points.Count);
        foreach (CraterView view in largestFirst)
        {
            if (Math.Abs(y - view.Ellipse.Y) > view.Ellipse.Reach.Down)
            {
                continue;
            }

            (int first, int last) = view.Ellipse.ColumnsOf(y, numbers.Length);
            int start = columns.BinarySearch(first - 1);
            for (int i = start < 0 ? ~start : start; i < columns.Length && columns[i] < last; i++)
            {
                if (!view.Disc.IsHiddenBy(row.PointAt(i)))
                {
                    numbers[columns[i]] = view.Crater.Number;
                }
            }
        }
    }

    private static CraterView WithParts(CraterView view, IGroundTruth frame)
    {
        ImageEllipse ellipse = view.Ellipse;
        (int width, int height) = (frame.Camera.Width, frame.Camera.Height);
        int spacing = (int)Math.Max(1.0, Math.Floor(Math.Sqrt(ellipse.Area * view.Inside / PixelsOfParts)));
        double down = ellipse.Reach.Down;
        int top = (int)Math.Max(1.0, Math.Ceiling(ellipse.Y - down));
        int bottom = (int)Math.Min(height, Math.Floor(ellipse.Y + down));
        Counts counts = default;
        for (int y = NextOf(top, spacing); y <= bottom; y += spacing)
        {
            (int first, int last) = ellipse.ColumnsOf(y, width);
            for (int x = NextOf(first, spacing); x <= last; x += spacing)
            {
                counts.Add(view.Disc, frame, x, y);
            }
        }

        if (counts.All == 0)
        {
            int x = (int)Math.Round(ellipse.X);
            int y = (int)Math.Round(ellipse.Y);
            if (x >= 1 && x <= width && y >= 1 && y <= height)
            {
                counts.Add(view.Disc, frame, x, y); // the pixel that the whole crater is in
            }
        }

        return view with
        {
            Hidden = counts.All == 0 ? null : (double)counts.Hidden / counts.All,
            Lit = counts.Shown == 0 ? null : counts.Lit / counts.Shown,
        };
    }

    /// <summary>The first of the numbers 1, 1 + spacing, ... that is not below another.</summary>
    private static int NextOf(int number, int spacing) => number + ((spacing - ((number - 1) % spacing)) % spacing);

    /// <summary>What the pixels of an ellipse show.</summary>
    private struct Counts
    {
        public int All { get; private set; }

        public int Hidden { get; private set; }

        public int Shown { get; private set; }

        public double Lit { get; private set; }

        public void Add(in CraterDisc disc, IGroundTruth frame, int x, int y)
        {
            All++;
            if (!frame.TryGet(x, y, out SurfaceHit hit, out PixelIllumination light))
            {
                return; // the sky beside a crater at the limb
            }

            if (disc.IsHiddenBy(hit.PointBodyFixed))
            {
                Hidden++;
                return;
            }

            Shown++;
            Lit += light.VisibleFraction;
        }
    }
}
