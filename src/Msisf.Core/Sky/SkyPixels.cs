using Msisf.Core.Camera;
using Msisf.Core.Parallel;
using Msisf.Core.Render;

namespace Msisf.Core.Sky;

/// <summary>What each pixel of a frame shows: ground, a star, a body of the sky, or nothing of these.</summary>
public static class SkyPixels
{
    /// <summary>Number of pixels that show ground.</summary>
    public const int Ground = 1;

    /// <summary>Number of pixels that show a star.</summary>
    public const int Star = 2;

    /// <summary>Bodies of a planet's system: the planet itself has 99 after the system's number.</summary>
    private const int SystemFactor = 100;

    private const int PlanetOfSystem = 99;

    /// <summary>px: discs of a smaller radius may hold no pixel's centre, and count as the pixel of their own centre.</summary>
    private const double SmallDisc = 0.75;

    /// <summary>The number of a body of the sky: NAIF's, of planets themselves also where kernels have their barycentres.</summary>
    public static int NumberOf(SkyBody body) => body.NaifNumber < 10 ? (SystemFactor * body.NaifNumber) + PlanetOfSystem : body.NaifNumber;

    /// <summary>
    /// The numbers, by rows: ground and discs where the pixel's centre shows them, the lit part or not; stars, and discs smaller than a
    /// pixel, in the pixel that holds their centre if no ground hides it. 0 for nothing of these.
    /// </summary>
    /// <param name="axes">How the sky lies, of each band of the frame's camera.</param>
    /// <param name="stars">The frame's; null for none.</param>
    /// <param name="bodies">The frame's; null for none.</param>
    public static int[] ObjectsOf(
        IGroundTruth frame, IReadOnlyList<SkyAxes> axes, StarsOfFrame? stars, BodiesOfFrame? bodies, int threads,
        CancellationToken cancellation = default)
    {
        ICamera camera = frame.Camera;
        int[] objects = new int[camera.Width * camera.Height];
        TruthRow[] rows = [.. Enumerable.Range(0, threads).Select(_ => new TruthRow())];
        HashSet<SkyBody> shown = [.. bodies?.Views.Select(view => view.Place.Body) ?? []];
        WorkerTeam.Run(
            threads,
            camera.Height,
            (worker, row) => MarkRow(
                frame, axes, shown, row + 1, rows[worker], objects.AsSpan(row * camera.Width, camera.Width)),
            cancellation);
        foreach (StarView view in stars?.Views.Where(view => view.IsVisible) ?? [])
        {
            ref int pixel = ref PixelAt(view.X, view.Y);
            pixel = pixel is 0 or Ground ? Star : pixel;
        }

        foreach (BodyView view in bodies?.Views.Where(view => view.RadiusPixels < SmallDisc && view.Visible > 0.0) ?? [])
        {
            if (view.X >= 0.5 && view.X < camera.Width + 0.5 && view.Y >= 0.5 && view.Y < camera.Height + 0.5)
            {
                PixelAt(view.X, view.Y) = NumberOf(view.Place.Body);
            }
        }

        return objects;

        ref int PixelAt(double x, double y) =>
            ref objects[(((int)Math.Floor(y + 0.5) - 1) * camera.Width) + (int)Math.Floor(x + 0.5) - 1];
    }

    private static void MarkRow(
        IGroundTruth frame, IReadOnlyList<SkyAxes> axes, HashSet<SkyBody> shown, int y, TruthRow truth, Span<int> objects)
    {
        frame.ReadRow(y, truth);
        foreach (int column in truth.Points.Columns.AsSpan(0, truth.Points.Count))
        {
            objects[column] = Ground;
        }

        if (shown.Count == 0)
        {
            return;
        }

        (PixelRows rows, FrameCamera camera) = frame.Camera.BandAt(y);
        SkyAxes sky = axes.MinBy(one => Math.Abs(one.Seconds - camera.State.Seconds))!;
        for (int column = 0; column < objects.Length; column++)
        {
            if (objects[column] != 0)
            {
                continue;
            }

            Vector3D direction = camera.RayThrough(column + 1, y - rows.First).Direction.Normalized();
            if (sky.BodyIn(direction, camera, camera.State.Seconds) is { } body && shown.Contains(body))
            {
                objects[column] = NumberOf(body);
            }
        }
    }
}
