using System.Text.Json;
using Msisf.Benchmarks.Definitions;
using Msisf.Benchmarks.Programs;

namespace Msisf.Benchmarks.Measures;

/// <summary>
/// Further frames, drawn in one process: a child of this one for each setting, because the width of vectors is chosen when a process
/// starts.
/// </summary>
internal sealed class FurtherFrames
{
    /// <summary>The runtime's switch for AVX-512.</summary>
    private static readonly Dictionary<string, string> WithoutAvx512 = new() { ["DOTNET_EnableAVX512"] = "0" };

    private readonly Workbench _bench;
    private readonly Repeats _repeats;

    public FurtherFrames(Workbench bench, Repeats repeats)
    {
        _bench = bench;
        _repeats = repeats;
    }

    /// <summary>Measures a scene: all threads and one, with AVX-512 where the machine has it and without.</summary>
    public IReadOnlyList<FurtherFramesResult> Measure(Scene scene)
    {
        int all = Environment.ProcessorCount;
        List<FurtherFramesResult> results = [Run(scene, all, null)];
        if (all > 1)
        {
            results.Add(Run(scene, 1, null));
        }

        if (results[0].HasVector512)
        {
            results.AddRange(results.Select(result => result.Threads).ToArray().Select(threads => Run(scene, threads, WithoutAvx512)));
        }

        return results;
    }

    private FurtherFramesResult Run(Scene scene, int threads, Dictionary<string, string>? environment)
    {
        FurtherFramesJob job = new(
            scene.Name, _bench.LabelOf(scene.Model), threads, _repeats.WarmUpFrames, _repeats.FurtherFrames,
            _repeats.CheckedPixels);
        ProgramRun run = ChildProgram.Self(_bench.Root).Run([FurtherFramesJob.Command, JsonSerializer.Serialize(job)], environment);
        return JsonSerializer.Deserialize<FurtherFramesResult>(run.Output[^1].Line)!;
    }
}
