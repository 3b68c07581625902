using BenchmarkDotNet.Attributes;
using Msisf.Adapters.Manifest;

namespace Msisf.Benchmarks.Micro;

/// <summary>
/// The line of a frame in the manifest, appended by several writers at once. Each has a handle of its own on the lock, as processes have.
/// The time is that of one line.
/// </summary>
public class ManifestAppendBenchmark
{
    private const int Lines = 2048;

    private static readonly string Key = new('a', 64);
    private string _folder = string.Empty;

    [Params(1, 4, 16)]
    public int Writers { get; set; }

    [GlobalSetup]
    public void Setup() => _folder = Directory.CreateTempSubdirectory("msisf-manifest-").FullName;

    [GlobalCleanup]
    public void Cleanup() => Directory.Delete(_folder, recursive: true);

    [Benchmark(OperationsPerInvoke = Lines)]
    public void Append()
    {
        Thread[] writers = [.. Enumerable.Range(0, Writers).Select(_ => new Thread(AppendShare))];
        Array.ForEach(writers, writer => writer.Start());
        Array.ForEach(writers, writer => writer.Join()); // Append waits for the lock for two minutes at most
    }

    private void AppendShare()
    {
        ManifestFile manifest = new(_folder);
        for (int line = 1; line <= Lines / Writers; line++)
        {
            manifest.Append(
                new FrameRecord(
                    line, "MoonSurfIllumSim_step_00001", Key, Key, [new OutputFile("MoonSurfIllumSim_step_00001.png", 100_000, Key)]));
        }
    }
}
