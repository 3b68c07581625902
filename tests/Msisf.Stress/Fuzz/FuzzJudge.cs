using Msisf.Adapters.Manifest;
using Msisf.TestSupport;

namespace Msisf.Stress.Fuzz;

/// <summary>Says what is wrong with what came of a case.</summary>
internal static class FuzzJudge
{
    private const int PartsFailed = 3;
    private const int SetNotComplete = 5;
    private const int EndedByUser = 130;

    private static readonly int[] Documented = [0, 1, 2, PartsFailed, 4, SetNotComplete];
    private static readonly FileStructure Structure = new(Path.Combine(TestParts.RepositoryRoot, "lib", "MSISRendering.dtd"));

    /// <summary>Judges a case.</summary>
    /// <param name="fuzzCase">The case; its folder is looked through.</param>
    /// <param name="run">What came of it; null if it hangs.</param>
    public static FuzzFault Judge(FuzzCase fuzzCase, FuzzRun? run)
    {
        if (run is null)
        {
            return FuzzFault.Hang;
        }

        FuzzFault fault = run.ExitCode switch
        {
            null or 70 => FuzzFault.Bug,
            EndedByUser when run.WasToldToEnd => FuzzFault.None,
            int code when Documented.Contains(code) => FuzzFault.None,
            _ => FuzzFault.UnknownExitCode,
        };
        return fault
            | (HasItsErrorLine(run) ? FuzzFault.None : FuzzFault.ErrorLine)
            | (IsWhole(fuzzCase.Folder) ? FuzzFault.None : FuzzFault.PartialOutput);
    }

    /// <summary>One line; where frames failed, one for each of them too.</summary>
    private static bool HasItsErrorLine(FuzzRun run)
    {
        int lines = run.Error.Split('\n').Count(line => line.StartsWith("msis: error: ", StringComparison.Ordinal));
        return run.ExitCode switch
        {
            0 or SetNotComplete => lines == 0,
            PartsFailed => lines >= 1,
            _ => lines == 1,
        };
    }

    private static bool IsWhole(string folder) =>
        Directory.EnumerateFileSystemEntries(folder, "*", SearchOption.AllDirectories).All(path =>
            !Path.GetFileName(path).Contains(".partial", StringComparison.Ordinal)
            && !Path.GetFileName(path).StartsWith(".msis-", StringComparison.Ordinal)
            && (Directory.Exists(path) || Structure.ProblemWith(path) is null));
}
