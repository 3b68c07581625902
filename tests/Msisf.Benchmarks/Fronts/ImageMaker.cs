using System.Text.Json;
using Msisf.Benchmarks.Definitions;
using Msisf.Benchmarks.Programs;
using Msisf.Benchmarks.Thesis;

namespace Msisf.Benchmarks.Fronts;

/// <summary>Makes a scene's image in one of the ways, by a process of its own.</summary>
internal sealed class ImageMaker
{
    /// <summary>s: a run of POV-Ray that takes longer has no place in a benchmark of minutes.</summary>
    private const string Timeout = "300";

    private readonly Workbench _bench;

    public ImageMaker(Workbench bench) => _bench = bench;

    /// <summary>Makes it.</summary>
    /// <param name="scene">Of what.</param>
    /// <param name="setting">How.</param>
    /// <param name="output">An empty folder for the image and the scene.</param>
    /// <returns>The run, with the times that --timing gives.</returns>
    /// <exception cref="BenchmarkException">It failed; the message says why.</exception>
    public ProgramRun Make(Scene scene, Setting setting, string output)
    {
        string patterns = _bench.PatternsOf(scene, setting);
        if (setting.Kind == SettingKind.Thesis)
        {
            ThesisFrameJob job = new(scene.Name, _bench.LabelOf(scene.Model), patterns, output, scene.MaxThesisTiles);
            return ChildProgram.Self(_bench.Root).Run([ThesisFrameJob.Command, JsonSerializer.Serialize(job)], watch: MemoryWatch.Children);
        }

        bool isPovRay = setting.Kind == SettingKind.PovRay;
        string[] renderer = isPovRay
            ? ["--renderer", "povray", "--pattern-repos", patterns, "--timeout", Timeout]
            : ["--renderer", "native", "--reflectance", "lambert"];
        return _bench.Msis.Run(
            ["--fixed-state", scene.FixedState, .. _bench.ImageOptions(scene.Model, output, scene.Side), .. renderer, .. setting.Options],
            watch: isPovRay ? MemoryWatch.Children : MemoryWatch.None);
    }
}
