using Msisf.Adapters.Raster.Heights;
using Msisf.Benchmarks.Definitions;
using Msisf.Benchmarks.Programs;

namespace Msisf.Benchmarks.Fronts;

/// <summary>
/// The first image from nothing but a model's image and label: no patterns, no bounds of the terrain and no levels beside it.
/// </summary>
internal static class FromNothing
{
    /// <summary>The image.</summary>
    public static Scene Image => Scenes.Named("far-64");

    /// <summary>Makes the image.</summary>
    public static FromNothingResult Measure(Workbench bench)
    {
        string folder = Path.Combine(bench.Folder, Scenes.FromNothing);
        Workbench.Delete(folder);
        string model = Directory.CreateDirectory(Path.Combine(folder, "model")).FullName;
        foreach (LdemLabel part in bench.Model(Image.Model).Parts)
        {
            foreach (string file in new HashSet<string> { part.LabelPath, part.ImagePath })
            {
                File.CreateSymbolicLink(Path.Combine(model, Path.GetFileName(file)), Path.GetFullPath(file));
            }
        }

        try
        {
            ProgramRun run = bench.Msis.Run(
                [
                    "--fixed-state", Image.FixedState,
                    .. Workbench.ImageOptions(Image.Model, model, Path.Combine(folder, "output")),
                    "--renderer", "povray", "--pattern-repos", Path.Combine(folder, "patterns"),
                ],
                new Dictionary<string, string> { ["XDG_CACHE_HOME"] = Path.Combine(folder, "cache") });
            return new FromNothingResult(Image.About, run.Seconds, RunTiming.Of(run).PeakMemoryBytes);
        }
        finally
        {
            Workbench.Delete(folder);
        }
    }
}
