namespace Msisf.Adapters.Manifest;

/// <summary>The content of a manifest: of several lines about one thing, the last counts. Not for several threads.</summary>
public sealed class ManifestContent
{
    /// <summary>Names are those of files, of which Windows takes two that differ in case for one.</summary>
    private static readonly StringComparer Names = OperatingSystem.IsWindows() ? StringComparer.OrdinalIgnoreCase : StringComparer.Ordinal;

    private readonly Dictionary<string, SettingsRecord> _settings = [];
    private readonly Dictionary<string, RunRecord> _runs = [];
    private readonly Dictionary<string, ExpectedRecord> _expected = [];
    private readonly Dictionary<string, FrameRecord> _frames = new(Names);
    private readonly Dictionary<string, FailedRecord> _failed = new(Names);
    private readonly SortedDictionary<string, OutputFile> _shared = new(StringComparer.Ordinal);

    /// <summary>Settings by key.</summary>
    public IReadOnlyDictionary<string, SettingsRecord> Settings => _settings;

    /// <summary>Runs by name, also those whose frames belong to later runs by now.</summary>
    public IReadOnlyDictionary<string, RunRecord> Runs => _runs;

    /// <summary>The run that was registered last; null if there is none.</summary>
    public string? LastRun { get; private set; }

    /// <summary>The frames that the folder is to have, by name: of several runs that have a frame of this name, the last counts.</summary>
    public IReadOnlyDictionary<string, ExpectedRecord> Expected => _expected;

    /// <summary>What was made last under each frame's name.</summary>
    public IReadOnlyDictionary<string, FrameRecord> Frames => _frames;

    /// <summary>Frames that failed after they were last made, by name.</summary>
    public IReadOnlyDictionary<string, FailedRecord> Failed => _failed;

    /// <summary>Files that belong to all frames, by name.</summary>
    public IReadOnlyDictionary<string, OutputFile> Shared => _shared;

    /// <summary>Number of lines that could not be read and were left out.</summary>
    public int DamagedLines { get; private set; }

    /// <summary>The settings of a run; null if the manifest does not have them.</summary>
    /// <param name="run">Name of the run.</param>
    public SettingsRecord? SettingsOf(string run) =>
        _runs.TryGetValue(run, out RunRecord? record) ? _settings.GetValueOrDefault(record.Settings) : null;

    /// <summary>Adds a line.</summary>
    /// <param name="record">Null for one that could not be read.</param>
    public void Add(ManifestRecord? record)
    {
        switch (record)
        {
            case SettingsRecord settings:
                _settings[settings.Key] = settings;
                break;
            case RunRecord run:
                _runs[run.Run] = run;
                LastRun = run.Run;
                break;
            case ExpectedRecord expected:
                _expected[expected.Name] = expected;
                break;
            case FrameRecord frame:
                _frames[frame.Name] = frame;
                _failed.Remove(frame.Name);
                break;
            case FailedRecord failed:
                _failed[failed.Name] = failed;
                break;
            case SharedFileRecord shared:
                _shared[shared.File.Name] = shared.File;
                break;
            default:
                DamagedLines++;
                break;
        }
    }

    /// <summary>
    /// All records in an order that depends on the records only, so that what several processes wrote in any order becomes the same file.
    /// </summary>
    public IEnumerable<ManifestRecord> InOrder()
    {
        RunRecord[] runs = [.. _runs.Values
            .Where(run => _expected.Values.Any(expected => expected.Run == run.Run))
            .OrderBy(run => run.Run == LastRun)
            .ThenBy(run => run.Run, StringComparer.Ordinal)];
        HashSet<string> used = [.. runs.Select(run => run.Settings), .. _frames.Values.Select(frame => frame.Settings)];
        return
        [
            .. _settings.Values.Where(settings => used.Contains(settings.Key)).OrderBy(settings => settings.Key, StringComparer.Ordinal),
            .. runs.SelectMany(run => (ManifestRecord[])[
                run,
                .. _expected.Values.Where(expected => expected.Run == run.Run)
                    .OrderBy(expected => expected.Step).ThenBy(expected => expected.Name, StringComparer.Ordinal)]),
            .. _frames.Values.OrderBy(frame => frame.Step).ThenBy(frame => frame.Name, StringComparer.Ordinal),
            .. _failed.Values.OrderBy(failed => failed.Step).ThenBy(failed => failed.Name, StringComparer.Ordinal),
            .. _shared.Values.Select(file => new SharedFileRecord(file)),
        ];
    }
}
