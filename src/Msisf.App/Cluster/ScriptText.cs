using System.Buffers;
using System.Text.RegularExpressions;
using Msisf.Adapters.Manifest;
using Msisf.App.Settings;
using Msisf.Core.Scene;

namespace Msisf.App.Cluster;

/// <summary>The content of a script that makes a run in pieces, independent of the script's format.</summary>
internal sealed record PieceScript
{
    /// <summary>Full path of the script itself.</summary>
    public required string Path { get; init; }

    /// <summary>The call that made the script, as one line for the script's head.</summary>
    public required string Call { get; init; }

    public required string Version { get; init; }

    /// <summary>Full path of the file that starts the program.</summary>
    public required string Launcher { get; init; }

    /// <summary>Full path of the folder in which the call was made; relative paths in its options start there.</summary>
    public required string WorkingFolder { get; init; }

    /// <summary>Arguments of the call that makes a piece, except <c>--frames</c>.</summary>
    public required IReadOnlyList<string> Arguments { get; init; }

    /// <summary>Whether <see cref="Arguments"/> say how many frames are made at once.</summary>
    public required bool HasJobs { get; init; }

    /// <summary>Whether the run needs patterns.</summary>
    public required bool NeedsPatterns { get; init; }

    /// <summary>Arguments of the call of <c>msis patterns</c> that makes the patterns before the pieces.</summary>
    public required IReadOnlyList<string> PatternArguments { get; init; }

    public required string OutputFolder { get; init; }

    public required IReadOnlyList<StepRanges> Pieces { get; init; }
}

/// <summary>Makes the text of a script that runs the pieces.</summary>
internal static class ScriptText
{
    /// <summary>Maximum number of pieces in a job array: Slurm's default MaxArraySize is 1001, which allows indices up to 1000.</summary>
    private const int MaxSlurmPieces = 1000;

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

/// <summary>Quotes words for a POSIX shell and for the #SBATCH lines of a script, which follow the same rules.</summary>
internal static class PosixWord
{
    private static readonly SearchValues<char> Plain =
        SearchValues.Create("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_./:=,+@%-");

    /// <summary>Quotes a text so that the shell reads it unchanged, whatever characters it contains.</summary>
    public static string Of(string text) =>
        text.Length > 0 && !text.AsSpan().ContainsAnyExcept(Plain)
            ? text
            : $"'{text.Replace("'", "'\\''", StringComparison.Ordinal)}'";
}

/// <summary>Quotes words for a Windows batch file, which both cmd and the called program's own argument parser take apart.</summary>
internal static class CmdWord
{
    private static readonly SearchValues<char> Plain =
        SearchValues.Create("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_./:\\+@-");

    /// <summary>Quotes a word if needed, doubling percent signs and a backslash before the closing quote.</summary>
    /// <exception cref="UsageException">cmd can't pass this text to a program.</exception>
    public static string Of(string text)
    {
        string inner = Inner(text);
        int backslashes = inner.Length - inner.TrimEnd('\\').Length;
        return text.Length > 0 && !text.AsSpan().ContainsAnyExcept(Plain) ? text : $"\"{inner}{new string('\\', backslashes)}\"";
    }

    /// <summary>The text for a place between quotes that only cmd reads.</summary>
    /// <exception cref="UsageException">cmd can't hold this text.</exception>
    public static string Inner(string text) => text.Contains('"') || text.Any(char.IsControl)
        ? throw new UsageException(
            $"--format bat: {text.ReplaceLineEndings(" ")} has a quotation mark or a control character in it, "
                + $"which a batch file can't pass on. Choose another name, or another --format.")
        : text.Replace("%", "%%", StringComparison.Ordinal);
}
