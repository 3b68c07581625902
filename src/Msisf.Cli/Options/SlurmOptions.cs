using System.CommandLine;
using System.Globalization;
using System.Text.RegularExpressions;
using Msisf.App.Settings;
using Msisf.Core.Errors;

namespace Msisf.Cli.Options;

/// <summary>What Slurm is asked for.</summary>
internal sealed partial class SlurmOptions
{
    private const int DefaultRetries = 3;

    /// <summary>More would only hide what is wrong.</summary>
    private const int MaxRetries = 100;

    private const int MaxCpus = 1024;

    /// <summary>Frames a second: more than any video has.</summary>
    private const double FastestVideo = 1000.0;

    /// <summary>Options of sbatch that the script sets by itself, or that have an option here.</summary>
    private static readonly string[] OwnOptions =
    [
        "account", "array", "chdir", "cpus-per-task", "dependency", "error", "help", "input", "job-name", "mem", "no-requeue", "open-mode",
        "output",
        "parsable", "partition", "quiet", "requeue", "test-only", "time", "usage", "version", "wait", "wrap",
    ];

    public Option<string?> Concurrency { get; } = OptionFactory.Value(
        "--concurrency", [], "N", "Slurm: pieces at once (default: as many as there is room for)");

    public Option<string?> CpusPerTask { get; } = OptionFactory.Value(
        "--cpus-per-task", [], "N", "Slurm: CPUs of a piece, and its frames at once if --jobs does not say otherwise (default 1)");

    public Option<string?> Memory { get; } = OptionFactory.Value(
        "--memory", [], "SIZE", "Slurm: memory of a piece, e.g. 4G (default: the cluster's)");

    public Option<string?> TimeLimit { get; } = OptionFactory.Value(
        "--time-limit", [], "TIME", "Slurm: longest time of a piece as sbatch takes it, e.g. 2:00:00 (default: the partition's)");

    public Option<string?> Partition { get; } = OptionFactory.Value("--partition", [], "NAME", "Slurm: partition (default: the cluster's)");

    public Option<string?> Account { get; } = OptionFactory.Value("--account", [], "NAME", "Slurm: account (default: the user's)");

    public Option<string?> MoreOptions { get; } = OptionFactory.Value(
        "--sbatch-options", [], "TEXT",
        "Slurm: more options of sbatch without their dashes, separated by spaces, e.g. \"qos=long constraint=avx2\"");

    public Option<string?> Retries { get; } = OptionFactory.Value(
        "--retries", [], "N", "Slurm: so often are missing frames submitted again (default 3)");

    public Option<bool> ContactSheet { get; } = OptionFactory.Flag(
        "--contact-sheet", [], "Slurm: make a contact sheet when all frames are there");

    public Option<string?> Video { get; } = OptionFactory.Value(
        "--video", [], "FPS", "Slurm: make a video when all frames are there, with so many frames a second");

    public IEnumerable<Option> All =>
        [Concurrency, CpusPerTask, Memory, TimeLimit, Partition, Account, MoreOptions, Retries, ContactSheet, Video];

    /// <summary>Refuses them for another format.</summary>
    /// <exception cref="UsageException">One is given.</exception>
    public void RefuseWithout(ParseResult line)
    {
        if (All.FirstOrDefault(option => line.GetResult(option) is { Implicit: false }) is Option wrong)
        {
            throw new UsageException($"{wrong.Name} is for --format slurm only. Choose that, or leave it out.");
        }
    }

    /// <summary>Reads and checks them.</summary>
    /// <exception cref="BadInputException">One is none.</exception>
    public SlurmSettings Read(ParseResult line) => new()
    {
        Concurrency = line.GetValue(Concurrency) is string most ? OptionText.WholeNumber(Concurrency, most, 1, int.MaxValue) : null,
        CpusPerTask = line.GetValue(CpusPerTask) is string cpus ? OptionText.WholeNumber(CpusPerTask, cpus, 1, MaxCpus) : 1,
        Memory = Matched(line, Memory, SizeText(), "a size is needed, e.g. 4G or 500M"),
        TimeLimit = Matched(line, TimeLimit, TimeText(), "a time is needed: minutes, or as in 2:00:00 and 1-12:00:00"),
        Partition = Matched(line, Partition, NameText(), "a name without blanks is needed"),
        Account = Matched(line, Account, NameText(), "a name without blanks is needed"),
        MoreOptions = [.. (line.GetValue(MoreOptions) ?? string.Empty).Split(' ', StringSplitOptions.RemoveEmptyEntries).Select(Checked)],
        Retries = line.GetValue(Retries) is string retries ? OptionText.WholeNumber(Retries, retries, 0, MaxRetries) : DefaultRetries,
        MergeOptions = [.. MergeOptionsOf(line)],
    };

    private IEnumerable<string> MergeOptionsOf(ParseResult line)
    {
        if (line.GetValue(ContactSheet))
        {
            yield return ContactSheet.Name;
        }

        if (line.GetValue(Video) is string rate)
        {
            yield return Video.Name;
            yield return OptionText.Number(Video, rate) is > 0.0 and <= FastestVideo
                ? rate
                : throw new BadInputException(string.Create(
                    CultureInfo.InvariantCulture,
                    $"{Video.Name} is {rate}; frames a second are needed, above 0 and up to {FastestVideo}."));
        }
    }

    private static string? Matched(ParseResult line, Option<string?> option, Regex pattern, string need) =>
        line.GetValue(option) is not string text || pattern.IsMatch(text)
            ? line.GetValue(option)
            : throw new BadInputException($"{option.Name} is '{text}'; {need}.");

    private string Checked(string word)
    {
        Match match = SbatchText().Match(word);
        if (!match.Success)
        {
            throw new BadInputException(
                $"{MoreOptions.Name}: '{word}' is none; long options of sbatch are needed, without their dashes, e.g. qos=long.");
        }

        return OwnOptions.Contains(match.Groups["name"].Value)
            ? throw new UsageException(
                $"{MoreOptions.Name}: {match.Groups["name"].Value} is set by msis itself. "
                    + $"Leave it out, or see msis batchconvert --help for its own option.")
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
