namespace Msisf.Stress.Fuzz;

/// <summary>Whether the inputs are right before they are damaged; else damage would show nothing.</summary>
internal static class RightInputs
{
    /// <summary>Enough that each kind of call gets its turn.</summary>
    private const int CasesOfTarget = 8;

    /// <summary>Runs undamaged cases, and counts those that don't succeed.</summary>
    /// <param name="targets">All.</param>
    /// <param name="parent">Existing folder.</param>
    /// <param name="seed">Of the choice among calls.</param>
    public static CaseCount Check(IEnumerable<IFuzzTarget> targets, string parent, int seed)
    {
        CaseCount refused = new();
        foreach (IFuzzTarget target in targets)
        {
            CaseRandom random = new(seed, 0);
            for (int number = 0; number < CasesOfTarget; number++)
            {
                string folder = Directory.CreateDirectory(
                    Path.Combine(parent, FormattableString.Invariant($"right {target.Name} {number}"))).FullName;
                FuzzCase right = target.Make(folder, random, isDamaged: false);
                FuzzRun? run = FuzzRunner.Run(right);
                refused.Note(
                    !IsWell(run),
                    () => $"{target.Name}, {right.Describe(number)} -> {run?.ExitCode}: {run?.Error.ReplaceLineEndings(" ")}");
                Directory.Delete(folder, recursive: true);
            }
        }

        return refused;
    }

    /// <summary>POV-Ray is not looked for in these calls, and GDAL may be missing.</summary>
    private static bool IsWell(FuzzRun? run) =>
        run is { ExitCode: 0 } or { WasToldToEnd: true }
            || (run?.ExitCode == 3 && (run.Error.Contains("POV-Ray is missing", StringComparison.Ordinal)
                || run.Error.Contains("needs GDAL", StringComparison.Ordinal)));
}
