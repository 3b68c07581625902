using System.Text.Json;
using Msisf.Benchmarks.Definitions;
using Msisf.Benchmarks.Programs;

namespace Msisf.Benchmarks.Measures;

/// <summary>Further frames with several samples a pixel, drawn in a child of this process.</summary>
internal sealed class SampledFrames
{
    /// <summary>Values of --samples beside that of the target.</summary>
    private static readonly string[] Fixed = ["1", "4", "16"];

    private readonly Workbench _bench;
    private readonly Repeats _repeats;

    public SampledFrames(Workbench bench, Repeats repeats)
    {
        _bench = bench;
        _repeats = repeats;
    }

    /// <summary>Measures a scene.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="target">What is wanted of it.</param>
    public IReadOnlyList<SampledFramesResult> Measure(Scene scene, SampledTarget target)
    {
        SampledFramesJob job = new(
            scene.Name, _bench.LabelOf(scene.Model), [.. Fixed, .. SampledTarget.OtherSamples, target.Samples],
            _repeats.SampledWarmUpFrames, _repeats.SampledFrames);
        ProgramRun run = ChildProgram.Self(_bench.Root).Run([SampledFramesJob.Command, JsonSerializer.Serialize(job)]);
        return JsonSerializer.Deserialize<SampledFramesResult[]>(run.Output[^1].Line)!;
    }
}
