using BenchmarkDotNet.Configs;
using BenchmarkDotNet.Jobs;
using BenchmarkDotNet.Running;
using BenchmarkDotNet.Toolchains.InProcess.Emit;

namespace Msisf.Benchmarks.Micro;

/// <summary>The benchmarks of single parts; they need LDEM_4 in input/ldem of the working directory.</summary>
internal static class MicroBenchmarks
{
    /// <summary>Runs all, or those that a filter names.</summary>
    /// <param name="arguments">BenchmarkDotNet's options; its results go to --artifacts.</param>
    public static void Run(string[] arguments)
    {
        // In this process: a project of BenchmarkDotNet's own would be built by the rules of this repository, and fail.
        ManualConfig config = ManualConfig.Create(DefaultConfig.Instance).AddJob(
            Job.Default.WithToolchain(InProcessEmitToolchain.Instance));
        string[] all = arguments.Contains("--filter") ? [] : ["--filter", "*"];
        BenchmarkSwitcher.FromAssembly(typeof(MicroBenchmarks).Assembly).Run([.. arguments, .. all], config);
    }
}
