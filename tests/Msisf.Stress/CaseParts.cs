namespace Msisf.Stress;

/// <summary>Shares the cases of a test among the cores. How they are cut does not depend on the machine, nor does the report.</summary>
public static class CaseParts
{
    /// <summary>Enough for many cores, few enough that merging costs nothing.</summary>
    private const int Parts = 64;

    /// <summary>Runs all parts.</summary>
    /// <param name="cases">In all.</param>
    /// <param name="seed">As given to <see cref="IStressTest.Run"/>.</param>
    /// <param name="runPart">Gets the part's random numbers and how many cases it has; gives what it found.</param>
    /// <returns>What was found, in the order of the parts.</returns>
    public static IReadOnlyList<T> Run<T>(long cases, int seed, Func<CaseRandom, long, T> runPart)
    {
        T[] results = new T[Parts];
        Parallel.For(0, Parts, part =>
            results[part] = runPart(new CaseRandom(seed, part), (cases * (part + 1) / Parts) - (cases * part / Parts)));
        return results;
    }
}
