using System.Diagnostics;
using System.Runtime.Intrinsics;
using Msisf.Benchmarks.Definitions;
using Msisf.Core.Camera;
using Msisf.Core.Ephemeris;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;

namespace Msisf.Benchmarks.Measures;

/// <summary>Draws the frames of a job in this process.</summary>
internal static class FurtherFramesChild
{
    /// <summary>Measures.</summary>
    /// <param name="job">What.</param>
    /// <param name="ephemeris">For the Sun.</param>
    public static FurtherFramesResult Run(FurtherFramesJob job, IEphemeris ephemeris)
    {
        Scene scene = Scenes.Named(job.Scene);
        SceneLight light = new(ephemeris.SunPositionBodyFixed(scene.State.Time), IsSun: true);
        NativeRenderOptions options = new() { Reflectance = new LambertReflectance(PovRayScene.Albedo) };
        using DrawnModel model = DrawnModel.Open(job.Label);
        ITerrainGrid grid = model.LevelFor(scene);
        NativeRenderer renderer = new(grid);
        List<double> seconds = [];
        for (int frame = 0; frame < job.WarmUpFrames + job.Frames; frame++)
        {
            PinholeCamera camera = Orbit.CameraOf(scene, frame);
            long start = Stopwatch.GetTimestamp();
            using NativeFrame drawn = renderer.Render(camera, light, options, job.Threads, CancellationToken.None);
            double took = Stopwatch.GetElapsedTime(start).TotalSeconds;
            if (frame >= job.WarmUpFrames)
            {
                seconds.Add(took);
            }
        }

        using Process self = Process.GetCurrentProcess();
        long peakMemory = self.PeakWorkingSet64;
        using NativeFrame last = renderer.Render(
            scene.Camera, light, options with { KeepGroundTruth = true }, job.Threads, CancellationToken.None);
        TracerCheck check = TracerCheck.Of(last, light, grid, job.CheckedPixels);
        return new FurtherFramesResult(
            job.Threads,
            Vector512.IsHardwareAccelerated,
            grid.Projection.Resolution.ToString(),
            seconds,
            peakMemory,
            check.Pixels,
            check.OtherFacets,
            check.OtherLight,
            check.LargestDistance);
    }
}
