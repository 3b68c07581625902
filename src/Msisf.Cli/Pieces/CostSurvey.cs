using Msisf.Cli.Options;
using Msisf.Cli.Run;
using Msisf.Core.Lod;
using Msisf.Core.Render;
using Msisf.Core.Tiles;

namespace Msisf.Cli.Pieces;

/// <summary>Estimates what the frames of a run cost, without drawing any of them: from the tiles that each needs.</summary>
internal static class CostSurvey
{
    /// <summary>
    /// Frames that are looked at; between them costs are interpolated. Of a long run so many show each of its first hundred turns about the Moon at some
    /// ten places, and take some 10 s of processor time at 64 px/deg (docs/tile-selection.md).
    /// </summary>
    public const int MaxFramesLookedAt = 1000;

    /// <summary>The costs of all frames of a run, in their order; seconds (<see cref="FrameCost"/>).</summary>
    /// <param name="run">The run.</param>
    /// <param name="cancellation">Ends the work.</param>
    public static double[] Of(PlannedRun run, CancellationToken cancellation)
    {
        int[] looked = Places(run.Frames.Count);
        double[] costs = new double[looked.Length];
        Parallel.For(0, looked.Length, new ParallelOptions { CancellationToken = cancellation }, index =>
            costs[index] = CostOf(run.Frames[looked[index]], run));
        return Interpolate(looked, costs, run.Frames.Count);
    }

    /// <summary>Which frames are looked at: all, or so many, evenly spread from the first to the last.</summary>
    /// <param name="count">Of all frames.</param>
    internal static int[] Places(int count) => count <= MaxFramesLookedAt
        ? [.. Enumerable.Range(0, count)]
        : [.. Enumerable.Range(0, MaxFramesLookedAt).Select(place => (int)((long)place * (count - 1) / (MaxFramesLookedAt - 1)))];

    /// <summary>Straight lines between the frames that were looked at.</summary>
    internal static double[] Interpolate(int[] places, double[] costs, int count)
    {
        double[] all = new double[count];
        all[0] = costs[0];
        for (int place = 1; place < places.Length; place++)
        {
            (int start, int end) = (places[place - 1], places[place]);
            for (int index = start + 1; index <= end; index++)
            {
                double part = (double)(index - start) / (end - start);
                all[index] = costs[place - 1] + (part * (costs[place] - costs[place - 1]));
            }
        }

        return all;
    }

    private static double CostOf(Frame frame, PlannedRun run)
    {
        RenderSettings settings = run.Settings;
        int across = settings.Renderer == RendererKind.Native ? settings.Native.Render.SubsamplesPerAxis : 1;
        int level = settings.LevelOfDetailError is double error
            ? new DetailRule(run.Model.Levels, error).LevelOfImage(frame.Camera.Footprint, across)
            : 0;
        int resolution = settings.PixelsPerDegree >> level;
        long faces = run.Model.Select(frame).Kept.Sum(choice => (long)TileMeshLayout.For(choice.Tile, resolution).FaceCount);
        return FrameCost.Of(settings.Renderer).Seconds((long)settings.Width * settings.Height * across * across, faces);
    }
}
