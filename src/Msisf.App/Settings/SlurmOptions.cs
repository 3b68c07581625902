using System.Text.RegularExpressions;
using Msisf.App.Settings.Specs;

namespace Msisf.App.Settings;

/// <summary>The options of a run on Slurm.</summary>
internal static partial class SlurmOptions
{
    /// <summary>Maximum number of retries: more would only hide a permanent error.</summary>
    private const int MaxRetries = 100;

    private const int MaxCpus = 1024;

    /// <summary>Options of sbatch that the script sets itself, or that have an own option here.</summary>
    private static readonly string[] OwnOptions =
    [
        "account", "array", "chdir", "cpus-per-task", "dependency", "error", "help", "input", "job-name", "mem", "no-requeue", "open-mode",
        "output",
        "parsable", "partition", "quiet", "requeue", "test-only", "time", "usage", "version", "wait", "wrap",
    ];

    public static WholeNumberSpec Concurrency { get; } = new("--concurrency", OptionRole.HowItRuns, "N", 1, int.MaxValue, "Pieces at once")
    {
        DefaultNote = "as many as there is room for",
    };

    public static WholeNumberSpec CpusPerTask { get; } = new(
        "--cpus-per-task", OptionRole.HowItRuns,
        "N", 1, MaxCpus, "CPUs of a piece, and its images at once if --jobs does not say otherwise")
    {
        Default = 1,
    };

    public static TextSpec Memory { get; } = new("--memory", OptionRole.HowItRuns, "SIZE", "Memory of a piece, e.g. 4G")
    {
        Form = (SizeText(), "a size is needed, e.g. 4G or 500M"),
        DefaultNote = "the cluster's",
    };

    public static TextSpec TimeLimit { get; } = new(
        "--time-limit", OptionRole.HowItRuns, "TIME", "Longest time of a piece as sbatch takes it, e.g. 2:00:00")
    {
        Form = (TimeText(), "a time is needed: minutes, or as in 2:00:00 and 1-12:00:00"),
        DefaultNote = "the partition's",
    };

    public static TextSpec Partition { get; } = new("--partition", OptionRole.HowItRuns, "NAME", "Partition")
    {
        Form = (NameText(), "a name without blanks is needed"),
        DefaultNote = "the cluster's",
    };

    public static TextSpec Account { get; } = new("--account", OptionRole.HowItRuns, "NAME", "Account")
    {
        Form = (NameText(), "a name without blanks is needed"),
        DefaultNote = "the user's",
    };

    public static TextSpec MoreOptions { get; } = new(
        "--sbatch-options", OptionRole.HowItRuns,
        "TEXT", "More options of sbatch without their dashes, separated by spaces, e.g. \"qos=long constraint=avx2\"")
    {
        Separator = " ",
    };

    public static WholeNumberSpec Retries { get; } = new(
        "--retries", OptionRole.HowItRuns, "N", 0, MaxRetries, "How often missing images are submitted again")
    {
        Default = 3,
    };

    public static OptionGroup Group { get; } = new(
        "Slurm",
        [
            CpusPerTask, Memory, TimeLimit, Partition, Account, Concurrency, Retries, MoreOptions, FolderOptions.ContactSheet,
            FolderOptions.Video,
        ]);

    /// <summary>Reads and checks the options.</summary>
    /// <exception cref="MsisfException">A value is wrong, or users can't set one of the options of sbatch.</exception>
    public static SlurmSettings Read(OptionValues values) => new()
    {
        Concurrency = Concurrency.ReadIfGiven(values),
        CpusPerTask = CpusPerTask.Read(values),
        Memory = Memory.ReadIfGiven(values),
        TimeLimit = TimeLimit.ReadIfGiven(values),
        Partition = Partition.ReadIfGiven(values),
        Account = Account.ReadIfGiven(values),
        MoreOptions = [.. (
            MoreOptions.ReadIfGiven(values) ?? string.Empty).Split(' ', StringSplitOptions.RemoveEmptyEntries).Select(Checked)],
        Retries = Retries.Read(values),
        MergeOptions = [.. MergeOptionsOf(values)],
    };

    private static IEnumerable<string> MergeOptionsOf(OptionValues values)
    {
        if (FolderOptions.ContactSheet.Read(values))
        {
            yield return FolderOptions.ContactSheet.Name;
        }

        if (FolderOptions.Video.ReadIfGiven(values) is not null)
        {
            yield return FolderOptions.Video.Name;
            yield return values.Text(FolderOptions.Video)!;
        }
    }

    private static string Checked(string word)
    {
        Match match = SbatchText().Match(word);
        if (!match.Success)
        {
            throw new UsageException($"{MoreOptions.Name}: '{word}' is none; "
                + $"long options of sbatch are needed, without their dashes, e.g. qos=long.").About(MoreOptions);
        }

        return OwnOptions.Contains(match.Groups["name"].Value)
            ? throw new UsageException(
                $"{MoreOptions.Name}: {match.Groups["name"].Value} is set by msis itself. "
                    + $"Leave it out, or see msis batchconvert --help for its own option.").About(MoreOptions)
            : word;
    }

    [GeneratedRegex(@"^[0-9]{1,6}[KMGT]?\z")]
    private static partial Regex SizeText();

    [GeneratedRegex(@"^([0-9]+-)?[0-9]+(:[0-9]+){0,2}\z")]
    private static partial Regex TimeText();

    [GeneratedRegex(@"^[\w.,@+-]+\z")]
    private static partial Regex NameText();

    [GeneratedRegex(@"^(?<name>[a-z][a-z0-9-]*)(=[^\s\p{C}]+)?\z")]
    private static partial Regex SbatchText();
}

/// <summary>Settings of the Slurm jobs, and of the last job, which merges the run.</summary>
internal sealed record SlurmSettings
{
    /// <summary>Maximum number of pieces at once; null for no limit.</summary>
    public required int? Concurrency { get; init; }

    /// <summary>Number of CPUs per piece, which is also the number of frames at once unless the run has --jobs.</summary>
    public required int CpusPerTask { get; init; }

    /// <summary>Memory per piece in the syntax of sbatch, e.g. "4G"; null for the cluster's default.</summary>
    public required string? Memory { get; init; }

    /// <summary><see cref="Memory"/> in bytes; null for the cluster's default.</summary>
    public long? MemoryBytes => Memory is null ? null : Memory[^1] switch
    {
        'K' => Count(Memory[..^1], 10),
        'M' => Count(Memory[..^1], 20),
        'G' => Count(Memory[..^1], 30),
        'T' => Count(Memory[..^1], 40),
        _ => Count(Memory, 20),
    };

    /// <summary>Time limit of a piece in the syntax of sbatch, e.g. "2:00:00"; null for the partition's default.</summary>
    public required string? TimeLimit { get; init; }

    public required string? Partition { get; init; }

    public required string? Account { get; init; }

    /// <summary>Further options of sbatch, without their dashes.</summary>
    public required IReadOnlyList<string> MoreOptions { get; init; }

    /// <summary>How many times missing frames are submitted again.</summary>
    public required int Retries { get; init; }

    /// <summary>Options of <c>msis merge</c>, which the last job runs.</summary>
    public required IReadOnlyList<string> MergeOptions { get; init; }

    private static long Count(string digits, int powerOfTwo) => long.Parse(digits, CultureInfo.InvariantCulture) << powerOfTwo;
}
