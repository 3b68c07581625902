using System.Text.RegularExpressions;
using Msisf.Adapters.Manifest;
using Msisf.App.Settings;

namespace Msisf.App.Cluster;

/// <summary>Makes the text of a script that runs the pieces.</summary>
internal static class ScriptText
{
    /// <summary>Maximum number of pieces in a job array: Slurm's default MaxArraySize is 1001, which allows indices up to 1000.</summary>
    private const int MaxSlurmPieces = 1000;

    /// <summary>The whole script.</summary>
    /// <param name="format">Format of the script; for <see cref="ScriptFormat.Slurm"/> call <see cref="Slurm"/>.</param>
    /// <param name="script">Content of the script.</param>
    /// <exception cref="UsageException">A batch file can't hold one of the names.</exception>
    public static string Of(ScriptFormat format, PieceScript script) => format switch
    {
        ScriptFormat.Bat => Bat(script),
        ScriptFormat.Parallel =>
            ScriptTemplate.Fill("parallel.sh", new Dictionary<string, string>(CommonValues(script), StringComparer.Ordinal)
            {
                ["JOBS"] = script.HasJobs ? string.Empty : "--jobs \"$MSISF_JOBS\"",
            }),
        _ => ScriptTemplate.Fill("sh.sh", CommonValues(script)),
    };

    /// <summary>The script for Slurm.</summary>
    /// <param name="script">Content of the script.</param>
    /// <exception cref="UsageException">There are more pieces than a job array can have, or sbatch does not accept a path.</exception>
    public static string Slurm(PieceScript script, SlurmSettings slurm)
    {
        if (script.Pieces.Count > MaxSlurmPieces)
        {
            throw new UsageException(Invariant(
                $"{script.Pieces.Count} pieces; a Slurm array has {MaxSlurmPieces} at most on a cluster with the usual MaxArraySize. "
                    + $"Use --pieces {MaxSlurmPieces}: a piece may have any number of frames."));
        }

        if (script.Path.Contains('\\') || script.Path.Any(char.IsControl))
        {
            throw new UsageException(
                $"--script {script.Path.ReplaceLineEndings(" ")}: sbatch can't keep its logs in a folder with a backslash or a control "
                    + $"character in its path. Choose another one.");
        }

        string logs = $"{script.Path}.logs".Replace("%", "%%", StringComparison.Ordinal);
        return ScriptTemplate.Fill("slurm.sh", new Dictionary<string, string>(CommonValues(script), StringComparer.Ordinal)
        {
            ["SBATCH_LINES"] = string.Join('\n', SbatchOptions(script, slurm, logs).Select(option => $"#SBATCH --{option}")),
            ["SCRIPT"] = PosixWord.Of(script.Path),
            ["LOGS"] = PosixWord.Of(logs),
            ["RETRIES"] = Number(slurm.Retries),
            ["CONCURRENCY"] = slurm.Concurrency is int most ? $"%{Number(most)}" : string.Empty,
            ["JOBS"] = script.HasJobs ? string.Empty : "--jobs \"$SLURM_CPUS_PER_TASK\"",
            ["NEEDS_PATTERNS"] = script.NeedsPatterns ? "yes" : "no",
            ["PATTERN_ARGUMENTS"] = Words(script.PatternArguments),
            ["MANIFEST"] = ManifestFile.Name,
            ["MERGE_OPTIONS"] = Words(slurm.MergeOptions),
        });
    }

    private static IEnumerable<string> SbatchOptions(PieceScript script, SlurmSettings slurm, string logs)
    {
        yield return $"job-name={SlurmJobName.Of(script.Path)}";
        yield return $"output={PosixWord.Of($"{logs}/submit.log")}";
        yield return "open-mode=append";
        yield return "requeue";
        yield return $"cpus-per-task={Number(slurm.CpusPerTask)}";
        (string Name, string? Value)[] given =
            [("mem", slurm.Memory), ("time", slurm.TimeLimit), ("partition", slurm.Partition), ("account", slurm.Account)];
        foreach ((string name, string? value) in given)
        {
            if (value is not null)
            {
                yield return $"{name}={value}";
            }
        }

        foreach (string option in slurm.MoreOptions)
        {
            yield return PosixWord.Of(option);
        }
    }

    private static string Bat(PieceScript script) => ScriptTemplate.Fill("bat.bat", new Dictionary<string, string>(StringComparer.Ordinal)
    {
        ["HEAD"] = Head(script).Replace("%", "%%", StringComparison.Ordinal),
        ["LAUNCHER"] = CmdWord.Inner(script.Launcher),
        ["WORKING_FOLDER"] = CmdWord.Of(script.WorkingFolder),
        ["ARGUMENTS"] = string.Join(' ', script.Arguments.Select(CmdWord.Of)),
        ["PIECES"] = string.Join('\n', script.Pieces.Select(piece => $"call :piece \"{piece}\"")),
    }).ReplaceLineEndings("\r\n");

    private static Dictionary<string, string> CommonValues(PieceScript script) => new(StringComparer.Ordinal)
    {
        ["HEAD"] = Head(script),
        ["LAUNCHER"] = PosixWord.Of(script.Launcher),
        ["WORKING_FOLDER"] = PosixWord.Of(script.WorkingFolder),
        ["ARGUMENTS"] = Words(script.Arguments),
        ["OUTPUT_FOLDER"] = PosixWord.Of(script.OutputFolder),
        ["PIECES"] = string.Join('\n', script.Pieces),
    };

    private static string Head(PieceScript script) => $"Made by msis {script.Version}: msis {script.Call}";

    private static string Words(IEnumerable<string> words) => string.Join(' ', words.Select(PosixWord.Of));

    private static string Number(int number) => number.ToString(CultureInfo.InvariantCulture);
}

/// <summary>
/// The script templates in the folder Templates; @NAME@ in them is replaced by a value that is already quoted for its place.
/// </summary>
internal static partial class ScriptTemplate
{
    /// <summary>Fills a template in.</summary>
    /// <param name="name">File name of the template.</param>
    /// <param name="values">A value for each name in the template.</param>
    public static string Fill(string name, IReadOnlyDictionary<string, string> values)
    {
        using Stream stream = typeof(ScriptTemplate).Assembly.GetManifestResourceStream($"Templates/{name}")
            ?? throw new ArgumentException($"there is no template {name}.", nameof(name));
        using StreamReader reader = new(stream);
        return Placeholder().Replace(reader.ReadToEnd(), match => values[match.Groups["name"].Value]);
    }

    [GeneratedRegex("@(?<name>[A-Z_]+)@")]
    private static partial Regex Placeholder();
}
