using Msisf.Adapters.Ccsds;
using Msisf.Adapters.Ephemeris;
using Msisf.Adapters.Input;
using Msisf.Core.Ephemeris;
using Msisf.Core.Orbit;
using Msisf.Core.Time;
using System.Text;

namespace Msisf.Adapters.Trajectories;

/// <summary>
/// Reads the states of a spacecraft from a file, whose format is known by its content: a CCSDS OEM, an ephemeris of STK, or a table of
/// vectors of JPL Horizons; also compressed by gzip.
/// </summary>
public static class TrajectoryFile
{
    /// <summary>Formats beside the OEM, which is what a file is that is none of them.</summary>
    private static readonly (Func<string, bool> Is, Func<TrajectoryReading, IReadOnlyList<TrajectoryBlock>> Read)[] Formats =
    [
        (head => StkEphemeris.Head.IsMatch(head), reading => new StkEphemeris(reading).Read()),
        (head => HorizonsVectors.Head.IsMatch(head), reading => new HorizonsVectors(reading).Read()),
    ];

    /// <summary>Whether a file begins as one of these formats does.</summary>
    /// <param name="path">The file.</param>
    /// <exception cref="BadInputException">It can't be read.</exception>
    public static bool IsOne(string path) => FileErrors.ToBadInput($"{path}: can't be read", () =>
    {
        if (new FileInfo(path) is not { Exists: true, Length: > 0 })
        {
            return false; // a pipe, which can be read once only
        }

        using FileStream stream = File.OpenRead(path);
        string head = HeadOf(stream);
        return CcsdsFile.IsOem(head) || Formats.Any(format => format.Is(head));
    });

    /// <summary>Reads a file.</summary>
    /// <param name="path">The file.</param>
    /// <param name="name">Its name in messages.</param>
    /// <param name="kernels">Turn its times into TDB, and the Moon's principal axes into MOON_ME.</param>
    /// <param name="note">Receives a sentence for what was put right.</param>
    /// <exception cref="BadInputException">The first thing that is wrong, by file and line.</exception>
    public static IReadOnlyList<TrajectoryBlock> Read(string path, string name, OpenedEphemeris kernels, Action<string> note)
    {
        KnownFormats.Refuse(path, FormatUse.Trajectory);
        using FileStream file = Open(path);
        string head = HeadOf(file);
        file.Position = 0;
        if (Formats.FirstOrDefault(format => format.Is(head)).Read is not { } read)
        {
            return new CcsdsFile(kernels, note).ReadOem(file, name);
        }

        using StreamReader text = new(CcsdsFile.Decompressed(file), Encoding.UTF8);
        CcsdsPlace place = new(name);
        IReadOnlyList<TrajectoryBlock> blocks = read(new TrajectoryReading(
            new BoundedLineReader(text, name), place, kernels.Engine.TimeScale,
            () => FrameKernel.ReadBodyFixedFrame(kernels.Catalogue.Pool, CelestialBody.Moon.Frame).FrameFromOrientation));
        foreach (string sentence in place.Notes)
        {
            note(sentence);
        }

        return blocks.Count > 0 ? blocks : throw new NothingToRenderException($"{name}: the file has no states.");
    }

    private static FileStream Open(string path) =>
        new(path, FileMode.Open, FileAccess.Read, FileShare.Read, 1 << 16, FileOptions.SequentialScan);

    private static string HeadOf(Stream stream)
    {
        try
        {
            using StreamReader reader = new(CcsdsFile.Decompressed(stream), Encoding.UTF8, leaveOpen: true);
            char[] start = new char[KnownFormats.HeadBytes];
            return new string(start, 0, reader.ReadBlock(start));
        }
        catch (InvalidDataException)
        {
            return string.Empty; // gzip in name only: whoever reads it as something else says what is wrong
        }
    }
}

/// <summary>A file of states while it is read.</summary>
/// <param name="Lines">Its lines.</param>
/// <param name="Place">Where the reader is.</param>
/// <param name="Scale">Turns times into TDB.</param>
/// <param name="MoonMeFromMoonPa">Reads the constant rotation from the Moon's principal axes.</param>
internal sealed record TrajectoryReading(
    BoundedLineReader Lines, CcsdsPlace Place, TimeScale Scale, Func<RotationMatrix> MoonMeFromMoonPa)
{
    /// <summary>Reads the next line that has something in it.</summary>
    /// <param name="line">Without blanks around it.</param>
    /// <returns>False at the end of the file.</returns>
    public bool TryRead(out string line)
    {
        while (Lines.TryRead(out ReadOnlySpan<char> text))
        {
            Place.Line = Lines.LineNumber;
            line = text.Trim().ToString();
            if (line.Length > 0)
            {
                return true;
            }
        }

        line = string.Empty;
        return false;
    }

    /// <summary>The time of a calendar date.</summary>
    /// <param name="system">UTC or TDB.</param>
    /// <param name="text">Day, month by its first three letters, year, or year first; then hour, minute and seconds.</param>
    /// <returns>Null if it is not a date, or a leap second that there was not.</returns>
    public TdbTime? Time(string system, string text)
    {
        string[] parts = text.Split((char[])[' ', '\t', '-', ':', ','], StringSplitOptions.RemoveEmptyEntries);
        string[] months = ["jan", "feb", "mar", "apr", "may", "jun", "jul", "aug", "sep", "oct", "nov", "dec"];
        if (parts.Length is < 3 or > 6)
        {
            return null;
        }

        (string year, string day) = parts[0].Length == 4 ? (parts[0], parts[2]) : (parts[2], parts[0]);
        int month = Array.IndexOf(months, parts[1].ToLowerInvariant()) + 1;
        string iso = $"{year}-{month:D2}-{day.PadLeft(2, '0')}T{Part(3)}:{Part(4)}:{Part(5)}";
        return month > 0 && CcsdsEpoch.TryParse(iso, out CalendarTime time)
            && (system == "UTC" ? TimeSystem.Utc : TimeSystem.Tdb) is var named && Scale.HasMoment(time, named)
            ? Scale.InstantOf(time, named).Tdb
            : null;

        string Part(int index) => index < parts.Length ? parts[index].Split('.')[0].Length == 1 ? "0" + parts[index] : parts[index] : "00";
    }
}
