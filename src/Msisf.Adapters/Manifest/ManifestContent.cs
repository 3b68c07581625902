namespace Msisf.Adapters.Manifest;

/// <summary>What a manifest says, its lines taken together: of several lines on one thing the last counts. Not for several threads.</summary>
public sealed class ManifestContent
{
    private readonly Dictionary<string, SettingsRecord> _settings = [];
    private readonly Dictionary<string, RunRecord> _runs = [];
    private readonly Dictionary<string, ExpectedRecord> _expected = [];
    private readonly Dictionary<string, FrameRecord> _frames = [];
    private readonly Dictionary<string, FailedRecord> _failed = [];

    /// <summary>Settings by key.</summary>
    public IReadOnlyDictionary<string, SettingsRecord> Settings => _settings;

    /// <summary>Runs by name; one whose frames are all expected otherwise by now is still there.</summary>
    public IReadOnlyDictionary<string, RunRecord> Runs => _runs;

    /// <summary>The run that was announced last; null if there is none.</summary>
    public string? LastRun { get; private set; }

    /// <summary>What is to be there, by the frame's name: what the last run that has a frame of this name wants.</summary>
    public IReadOnlyDictionary<string, ExpectedRecord> Expected => _expected;

    /// <summary>What was made last under each frame's name.</summary>
    public IReadOnlyDictionary<string, FrameRecord> Frames => _frames;

    /// <summary>What failed since it was last made, by the frame's name.</summary>
    public IReadOnlyDictionary<string, FailedRecord> Failed => _failed;

    /// <summary>Lines that are none of a manifest, and were left out.</summary>
    public int DamagedLines { get; private set; }

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
            default:
                DamagedLines++;
                break;
        }
    }

    /// <summary>The records that say all of it, in an order that depends on nothing but them: what several processes wrote in any order becomes the same.</summary>
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
                run, .. _expected.Values.Where(expected => expected.Run == run.Run).OrderBy(expected => expected.Step)]),
            .. _frames.Values.OrderBy(frame => frame.Step).ThenBy(frame => frame.Name, StringComparer.Ordinal),
            .. _failed.Values.OrderBy(failed => failed.Step).ThenBy(failed => failed.Name, StringComparer.Ordinal),
        ];
    }
}
