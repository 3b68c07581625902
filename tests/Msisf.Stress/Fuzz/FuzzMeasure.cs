namespace Msisf.Stress.Fuzz;

/// <summary>Runs the cases and counts their faults.</summary>
/// <param name="turns">Take turns by the number of the case.</param>
/// <param name="parent">Existing folder, for the folders of the cases.</param>
/// <param name="atOnce">How many cases run at once, whatever the number of threads that wait for them.</param>
/// <param name="seed">Of all cases; each has random numbers of its own, so that it can be made again alone.</param>
internal sealed class FuzzMeasure(IReadOnlyList<IFuzzTarget> turns, string parent, SemaphoreSlim atOnce, int seed) : IMeasure<FuzzMeasure>
{
    /// <summary>
    /// Bytes, of the whole process while cases run, garbage and all: it has about 1 GB of that, up and down, on a machine with 24 GB.
    /// </summary>
    public const long MaxMemory = 3_000_000_000;

    private static readonly FuzzFault[] Faults = [.. Enum.GetValues<FuzzFault>().Where(fault => fault != FuzzFault.None)];

    private readonly Dictionary<FuzzFault, CaseCount> _counts = Faults.ToDictionary(fault => fault, _ => new CaseCount());

    /// <summary>Of a fault.</summary>
    public CaseCount CountOf(FuzzFault fault) => _counts[fault];

    /// <summary>Calls that ended well, so that damage is not all that is seen.</summary>
    public long Successes { get; private set; }

    public void Try(int number, CaseRandom random)
    {
        string folder = Directory.CreateDirectory(Path.Combine(parent, FormattableString.Invariant($"case {number}"))).FullName;
        FuzzCase fuzzCase = turns[number % turns.Count].Make(folder, new CaseRandom(seed, number), isDamaged: true);
        atOnce.Wait(); // for other cases, which FuzzRunner does not let run for ever
        FuzzRun? run = FuzzRunner.Run(fuzzCase);
        atOnce.Release();
        FuzzFault found = FuzzJudge.Judge(fuzzCase, run);
        if (MemoryPeak.Read() > MaxMemory)
        {
            found |= FuzzFault.Memory;
            MemoryPeak.Reset();
        }

        Successes += run?.ExitCode == 0 ? 1 : 0;
        foreach (FuzzFault fault in Faults)
        {
            _counts[fault].Note(
                found.HasFlag(fault), () =>
                    FormattableString.Invariant($"{fuzzCase.Describe(number)} -> {run?.ExitCode}: {run?.Error.ReplaceLineEndings(" ")}"));
        }

        if (run is not null)
        {
            Directory.Delete(folder, recursive: true);
        }
    }

    public void Add(FuzzMeasure other)
    {
        Successes += other.Successes;
        foreach (FuzzFault fault in Faults)
        {
            _counts[fault].Add(other._counts[fault]);
        }
    }
}
