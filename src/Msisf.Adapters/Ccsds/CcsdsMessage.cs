using Msisf.Adapters.Input;
using Msisf.Core.Ephemeris;
using Msisf.Core.Time;

namespace Msisf.Adapters.Ccsds;

/// <summary>What is the same in both kinds of files: header, blocks of keywords, times, interpolation.</summary>
/// <param name="place">Where the reader is.</param>
/// <param name="scale">Makes moments of times.</param>
internal abstract class CcsdsMessage(CcsdsPlace place, TimeScale scale)
{
    /// <summary>Degree of an interpolation for which the file gives none.</summary>
    protected const int DefaultDegree = 7;

    /// <summary>s: writers round START_TIME and STOP_TIME to the second.</summary>
    private const double RoundingOfTimes = 1.0;

    /// <summary>What writers give in place of an ID or a name that they do not know.</summary>
    private static readonly string[] Unknown = ["NONE", "UNKNOWN", "N/A"];

    private static readonly string[] HeaderKeywords = ["CREATION_DATE", "ORIGINATOR", "MESSAGE_ID", "CLASSIFICATION"];

    private static readonly (string Word, InterpolationMethod Method)[] Methods =
    [
        ("LINEAR", InterpolationMethod.Linear), ("LAGRANGE", InterpolationMethod.Lagrange), ("HERMITE", InterpolationMethod.Hermite),
        ("SLERP", InterpolationMethod.Linear),
    ];

    private TimeSystem _timeSystem;
    private CcsdsMetadata? _metadata;
    private readonly Dictionary<string, string> _object = [];
    private double[] _lastNumbers = [];
    private TdbTime? _lastTime;

    /// <summary>"OEM" or "AEM".</summary>
    public abstract string Kind { get; }

    /// <summary>The keyword of the format's version.</summary>
    public string VersionKeyword => $"CCSDS_{Kind}_VERS";

    /// <summary>All keywords of a block, in the order of the standard.</summary>
    public abstract string[] Keywords { get; }

    /// <summary>The version of the format; null until it was read.</summary>
    public string? Version { get; private set; }

    /// <summary>Where the reader is.</summary>
    public CcsdsPlace Place => place;

    /// <summary>The versions that are read.</summary>
    protected abstract string[] Versions { get; }

    /// <summary>The keywords of the block.</summary>
    protected CcsdsMetadata Metadata => _metadata ?? throw new InvalidOperationException("no block has begun");

    /// <summary>Takes a keyword above the first block.</summary>
    public void TakeHeader(string key, string value)
    {
        if (key.Equals(VersionKeyword, StringComparison.OrdinalIgnoreCase))
        {
            if (!Versions.Contains(value))
            {
                throw place.Error($"{VersionKeyword} = {NumberText.Shown(value)}: versions {string.Join(", ", Versions)} are read.");
            }

            Version = value;
        }
        else if (key.StartsWith("CCSDS_", StringComparison.OrdinalIgnoreCase))
        {
            throw place.Error($"this is not an {Kind}: it begins with {NumberText.Shown(key)}, {VersionKeyword} is needed.");
        }
        else if (Version is null)
        {
            throw place.Error($"{NumberText.Shown(key)} is above the version. The first line is {VersionKeyword} = {Versions[^1]}.");
        }
        else if (!HeaderKeywords.Contains(key, StringComparer.OrdinalIgnoreCase))
        {
            place.Note($"The keyword {NumberText.Shown(key)} is not known in the header; it is left out.");
        }
    }

    /// <summary>Whether a word is a keyword of blocks.</summary>
    public bool IsKeyword(string word) => Keywords.Contains(word, StringComparer.OrdinalIgnoreCase);

    public void BeginBlock()
    {
        if (Version is null)
        {
            throw place.Error($"no version is above it. The first line of an {Kind} is {VersionKeyword} = {Versions[^1]}.");
        }

        _metadata = new CcsdsMetadata(Keywords, place);
    }

    /// <summary>Takes a keyword of the block.</summary>
    public void TakeMetadata(string key, string value) => Metadata.Add(key, value);

    /// <summary>All keywords of the block were taken; its data follow.</summary>
    public void BeginData()
    {
        string names = string.Join(", ", CcsdsEpoch.Systems.Select(known => known.Name));
        string system = Metadata.Require("TIME_SYSTEM", $"in which system its times are ({names})");
        (string Name, TimeSystem System) found = CcsdsEpoch.Systems.FirstOrDefault(
            known => known.Name.Equals(system, StringComparison.OrdinalIgnoreCase));
        _timeSystem = found.Name is not null
            ? found.System
            : throw Metadata.Error("TIME_SYSTEM", $"{names} are read.");
        if (string.IsNullOrEmpty(Metadata.Find("OBJECT_NAME")))
        {
            place.Note("The block has no OBJECT_NAME, which the standard demands.");
        }

        _lastTime = null;
        OpenBlock();
    }

    /// <summary>Takes a line of data; one that occurs twice is left out.</summary>
    /// <param name="epoch">Its time.</param>
    /// <param name="areNamed">Whether each number had a name of its own (XML), so that they are in the standard's order.</param>
    public void TakeData(ReadOnlySpan<char> epoch, ReadOnlySpan<double> numbers, bool areNamed)
    {
        TdbTime time = TimeOf(epoch);
        if (time == _lastTime && numbers.SequenceEqual(_lastNumbers))
        {
            place.Note("A line occurs twice; the second one is left out.");
            return;
        }

        Add(time, numbers, areNamed);
        _lastTime = time;
        _lastNumbers = _lastNumbers.Length == numbers.Length ? _lastNumbers : new double[numbers.Length];
        numbers.CopyTo(_lastNumbers);
    }

    public abstract void EndBlock();

    /// <summary>Where a value of the XML form is in the line of the other form.</summary>
    /// <param name="parent">The element around its own.</param>
    /// <param name="name">The element.</param>
    /// <param name="axis">The attribute that names an axis; null for none.</param>
    /// <returns>Its place, from 0, and its unit; a negative place for an element that is not known.</returns>
    public abstract (int Index, string Unit) PlaceOf(string parent, string name, string? axis);

    /// <summary>Reads the keywords of the block.</summary>
    protected abstract void OpenBlock();

    /// <summary>Adds a line of data to the block.</summary>
    protected abstract void Add(TdbTime time, ReadOnlySpan<double> numbers, bool areNamed);

    /// <summary>The error for a time that does not rise.</summary>
    protected void RequireLater(SampleTimes times, TdbTime time)
    {
        if (times.Count > 0 && !(time > times.Last))
        {
            throw place.Error(time == times.Last
                ? "the time of the line before occurs again, with other numbers. Remove one of the lines, or begin a new block between "
                    + "them."
                : "the time is before that of the line above. Put the lines into the order of time.");
        }
    }

    /// <summary>Refuses a block of another spacecraft than those above; one without name or ID is taken.</summary>
    protected void RequireOneObject()
    {
        foreach (string key in (string[])["OBJECT_NAME", "OBJECT_ID"])
        {
            if (Metadata.Find(key) is { Length: > 0 } said && !Unknown.Contains(said, StringComparer.OrdinalIgnoreCase)
                && !_object.TryAdd(key, said) && !said.Equals(_object[key], StringComparison.OrdinalIgnoreCase))
            {
                throw Metadata.Error(key, $"the blocks above are of {_object[key]}. Give a file of one spacecraft.");
            }
        }
    }

    /// <summary>Notes where START_TIME and STOP_TIME of a block are not those of its lines, which count.</summary>
    protected void CompareWith(SampleTimes times)
    {
        foreach ((string key, TdbTime time) in ((string, TdbTime)[])[("START_TIME", times.First), ("STOP_TIME", times.Last)])
        {
            if (Metadata.Find(key) is { Length: > 0 } said
                && !(TryTime(said) is { } stated && Math.Abs(stated - time) <= RoundingOfTimes))
            {
                string which = key == "START_TIME" ? "first" : "last";
                place.Note(
                    $"{key} = {NumberText.Shown(said)} is not the time of the block's {which} line, "
                        + $"{scale.InstantOf(time).ToIsoUtc()} (UTC); the lines count. Is the file complete?");
            }
        }
    }

    /// <summary>USEABLE_START_TIME and USEABLE_STOP_TIME; null if the block has none.</summary>
    protected TdbInterval? ReadUseable()
    {
        TdbInterval useable = new(
            TimeOfKey("USEABLE_START_TIME") ?? double.NegativeInfinity, TimeOfKey("USEABLE_STOP_TIME") ?? double.PositiveInfinity);
        return useable.Start <= useable.End ? useable : throw Metadata.Error("USEABLE_STOP_TIME", "it is before USEABLE_START_TIME.");
    }

    /// <summary>How states between samples are found; null where the file does not say it.</summary>
    protected Interpolation? ReadInterpolation()
    {
        string key = Metadata.Find("INTERPOLATION") is null ? "INTERPOLATION_METHOD" : "INTERPOLATION";
        if (Metadata.Find(key) is not { } word)
        {
            if (Metadata.Find("INTERPOLATION_DEGREE") is not null)
            {
                place.Note("INTERPOLATION_DEGREE without a method means nothing; it is left out.");
            }

            return null;
        }

        (string Word, InterpolationMethod Method) found = Methods.FirstOrDefault(
            known => known.Word.Equals(word, StringComparison.OrdinalIgnoreCase));
        if (found.Word is null)
        {
            throw Metadata.Error(key, "LINEAR, LAGRANGE and HERMITE are known.");
        }

        return new Interpolation(found.Method, found.Method == InterpolationMethod.Linear ? 1 : ReadDegree());
    }

    private int ReadDegree()
    {
        const int Highest = SampleWeights.MaxSamples - 1;
        if (Metadata.Find("INTERPOLATION_DEGREE") is not { } text)
        {
            place.Note(Invariant($"INTERPOLATION_DEGREE is missing; {DefaultDegree} is used."));
            return DefaultDegree;
        }

        return int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int degree) && degree is >= 1 and <= Highest
            ? degree
            : throw Metadata.Error(
                "INTERPOLATION_DEGREE", Invariant($"a whole number from 1 to {Highest} is needed."));
    }

    private double? TryTime(string text) => CcsdsEpoch.TryParse(text, out CalendarTime time) && scale.HasMoment(time, _timeSystem)
        ? scale.InstantOf(time, _timeSystem).Tdb.Seconds
        : null;

    private double? TimeOfKey(string key) => Metadata.Find(key) is not { } text ? null
        : TryTime(text) is { } seconds ? seconds
        : throw Metadata.Error(key, $"not a time, which looks like {CcsdsEpoch.ValidValues}.");

    private TdbTime TimeOf(ReadOnlySpan<char> text)
    {
        if (!CcsdsEpoch.TryParse(text, out CalendarTime time))
        {
            throw place.Error($"{NumberText.Shown(text)} is not a time, which looks like {CcsdsEpoch.ValidValues}.");
        }

        return scale.HasMoment(time, _timeSystem)
            ? scale.InstantOf(time, _timeSystem).Tdb
            : throw place.Error($"{NumberText.Shown(text)}: there was no leap second then.");
    }
}
