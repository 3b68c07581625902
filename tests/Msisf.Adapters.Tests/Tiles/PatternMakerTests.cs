using System.Diagnostics;
using Msisf.Adapters.IO;
using Msisf.Adapters.Tiles;
using Msisf.Core.Tiles;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Tiles;

/// <summary>
/// Several that want the same patterns at once. The other process is a script that claims all of them, as the system has it.
/// </summary>
public sealed class PatternMakerTests : IDisposable
{
    private static readonly TileId[] Tiles = [.. TileId.All.Take(80)];

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public async Task Ensure_SeveralThreadsAtOnce_MakeEachOnce()
    {
        using PatternRepository repository = new(_folder["patterns"]);
        FunctionGrid grid = FunctionGrid.Rough(8); // a pattern takes long enough for the threads to meet
        PatternSet[] sets = await Within.Seconds(120, "four threads at once", Task.WhenAll(Enumerable.Range(0, 4).Select(_ => Task.Run(
            () => repository.EnsurePatterns(Tiles, grid, default, maxParallelism: 2)))));

        Assert.Equal(Tiles.Length, sets.Sum(set => set.Written));
        Assert.All(sets, set => Assert.All(set.Paths, path => Assert.True(File.Exists(path))));
    }

    [Fact]
    public void Ensure_AllThere_ClaimsNothing()
    {
        using (PatternRepository first = new(_folder["patterns"]))
        {
            Ensure(first);
        }

        File.Delete(ClaimsFile);
        using PatternRepository repository = new(_folder["patterns"]);

        Assert.Equal(0, Ensure(repository).Written);
        Assert.False(File.Exists(ClaimsFile));
    }

    [RequiresFact(Part.Python)]
    public async Task Ensure_AnotherProcessMakesThem_WaitsAndTakesThem()
    {
        using PatternRepository elsewhere = new(_folder["elsewhere"]);
        IReadOnlyList<string> made = Ensure(elsewhere).Paths;
        using Process other = await OtherProcess();
        using PatternRepository repository = new(_folder["patterns"], TimeSpan.MaxValue);
        TaskCompletionSource reads = new();
        Task<PatternSet> waiting = Task.Run(() => repository.EnsurePatterns(Tiles, Telling(reads), default, maxParallelism: 2));
        await Within.Seconds(60, "the first read of the model", reads.Task);
        foreach (string path in made)
        {
            // A copy that goes on is locked, and can't be read; a pattern gets its name when it is whole.
            File.Move(path, Path.Combine(Path.GetDirectoryName(ClaimsFile)!, Path.GetFileName(path)));
        }

        other.StandardInput.Close();
        Assert.Equal(0, (await Within.Seconds(120, "the patterns", waiting)).Written);
    }

    [RequiresFact(Part.Python)]
    public async Task Ensure_AnotherProcessIsKilled_MakesThem()
    {
        using Process other = await OtherProcess();
        using PatternRepository repository = new(_folder["patterns"], TimeSpan.MaxValue);
        TaskCompletionSource reads = new();
        Task<PatternSet> waiting = Task.Run(() => repository.EnsurePatterns(Tiles, Telling(reads), default, maxParallelism: 2));
        await Within.Seconds(60, "the first read of the model", reads.Task);
        other.Kill();

        Assert.Equal(Tiles.Length, (await Within.Seconds(120, "the patterns", waiting)).Written);
    }

    [RequiresFact(Part.Python)]
    public async Task Ensure_AnotherProcessHangs_MakesThemAfterTheLongestWait()
    {
        using Process other = await OtherProcess();
        using PatternRepository repository = new(_folder["patterns"], TimeSpan.FromMilliseconds(100));

        Assert.Equal(Tiles.Length, Ensure(repository).Written);
        Assert.False(other.HasExited);
        other.Kill();
    }

    [Fact]
    public void Ensure_AKilledProcessLeftItsUnfinishedFile_WritesOverIt()
    {
        using PatternRepository repository = new(_folder["patterns"]);
        string path = repository.PathOf(Tiles[0], 1);
        Directory.CreateDirectory(Path.GetDirectoryName(path)!);
        File.WriteAllText(AtomicFile.PartialNameFor(path), new string('x', 1_000_000));

        Ensure(repository);

        Assert.Empty(Directory.EnumerateFiles(Path.GetDirectoryName(path)!, "*.partial.*"));
        using PatternRepository elsewhere = new(_folder["elsewhere"]);
        Assert.Equal(File.ReadAllBytes(Ensure(elsewhere).Paths[0]), File.ReadAllBytes(path));
    }

    private string ClaimsFile => Path.Combine(_folder["patterns"], "1", ".msisf-claims");

    private static PatternSet Ensure(PatternRepository repository) =>
        repository.EnsurePatterns(Tiles, FunctionGrid.Rough(1), default, maxParallelism: 2);

    /// <summary>The model of <see cref="Ensure"/>, which tells when it is first read.</summary>
    private static FunctionGrid Telling(TaskCompletionSource reads)
    {
        FunctionGrid rough = FunctionGrid.Rough(1);
        return new FunctionGrid(1, (line, sample) =>
        {
            reads.TrySetResult();
            double[] radius = new double[1];
            rough.ReadRadii(line, sample, radius);
            return radius[0];
        });
    }

    /// <summary>Holds a lock on every byte of the file of claims, until its standard input ends.</summary>
    private async Task<Process> OtherProcess()
    {
        Directory.CreateDirectory(Path.GetDirectoryName(ClaimsFile)!);
        const string script =
            "import fcntl,sys; f=open(sys.argv[1],'w'); fcntl.lockf(f,fcntl.LOCK_EX); print('holds',flush=True); sys.stdin.read()";
        Process process = Process.Start(new ProcessStartInfo(TestParts.Python!, ["-c", script, ClaimsFile])
        {
            RedirectStandardInput = true,
            RedirectStandardOutput = true,
        })!;
        Assert.Equal("holds", await Within.Seconds(60, "the lock of the other process", process.StandardOutput.ReadLineAsync()));
        return process;
    }
}
