using Msisf.Adapters.Input;
using Msisf.Core.Ephemeris;
using Msisf.Core.Orbit;
using Msisf.Core.Time;
using System.Text.RegularExpressions;

namespace Msisf.Adapters.Trajectories;

/// <summary>A table of vectors as JPL Horizons prints it: text or CSV, positions and velocities about the Moon.</summary>
/// <remarks>JPL Horizons' manual, "Vector tables". Times are TDB, states geometric.</remarks>
/// <param name="reading">The file.</param>
internal sealed partial class HorizonsVectors(TrajectoryReading reading)
{
    /// <summary>rad: the ecliptic of J2000 to the equator, 84381.448 arcsec (IAU 1976), as Horizons and SPICE have it.</summary>
    private const double Obliquity = 84381.448 / 3600.0 * Math.PI / 180.0;

    private const double AstronomicalUnit = 149_597_870_700.0; // m, IAU 2012

    private const double SecondsPerDay = 86400.0;

    private const double JulianDateOfJ2000 = 2451545.0;

    /// <summary>s: the Julian date has steps of 86 microseconds, the calendar date may have less digits.</summary>
    private const double SameTime = 1e-3;

    private static readonly Dictionary<string, (double Length, double Time)> Units = new(StringComparer.OrdinalIgnoreCase)
    {
        ["KM-S"] = (1000.0, 1.0),
        ["AU-D"] = (AstronomicalUnit, SecondsPerDay),
        ["KM-D"] = (1000.0, SecondsPerDay),
    };

    private readonly Dictionary<string, (string Value, int Line)> _header = new(StringComparer.OrdinalIgnoreCase);
    private readonly StateSamples _samples = new();

    /// <summary>What the head of a file has.</summary>
    [GeneratedRegex(@"(?m)^\s*(?:Target body name:|Ephemeris / .*Horizons|API SOURCE: NASA/JPL Horizons|\$\$SOE)")]
    public static partial Regex Head { get; }

    /// <summary>Reads the file.</summary>
    /// <exception cref="BadInputException">The first thing that is wrong, by file and line.</exception>
    public IReadOnlyList<TrajectoryBlock> Read()
    {
        string columns = string.Empty;
        string line;
        while (true)
        {
            if (!reading.TryRead(out line))
            {
                throw reading.Place.Error("the file has no line $$SOE, where the vectors begin. Get the whole answer of Horizons.");
            }

            if (line == "$$SOE")
            {
                break;
            }

            columns = line.Contains("JDTDB", StringComparison.Ordinal) || line.Contains("JDUT", StringComparison.Ordinal) ? line : columns;
            string[] parts = line.Split(':', 2, StringSplitOptions.TrimEntries);
            if (parts.Length == 2)
            {
                _header[parts[0]] = (parts[1].Split('{')[0].Trim(), reading.Place.Line);
            }
        }

        int numbers = Check();
        ReadVectors(isCsv: columns.Contains(','), numbers);
        return _samples.Count > 0 ? [new TrajectoryBlock(_samples, CelestialBody.Moon.NaifNumber, MoonMeFromFrame: null)] : [];
    }

    /// <summary>Checks what the header says.</summary>
    /// <returns>Numbers of a state: 3 or 6.</returns>
    private int Check()
    {
        Require("Center body name", text => text.Contains("(301)", StringComparison.Ordinal), "the Moon is needed: CENTER='500@301'");
        Require(
            "Center-site name", text => text.Equals("BODY CENTER", StringComparison.OrdinalIgnoreCase), "BODY CENTER is needed: "
                + "CENTER='500@301'", isOptional: true);
        Require(
            "Output type", text => text.StartsWith("GEOMETRIC", StringComparison.OrdinalIgnoreCase),
            "geometric states are needed: VEC_CORR='NONE'; msis itself has the light time (--ground-aberration)");
        Require("Output units", Units.ContainsKey, $"{string.Join(", ", Units.Keys)} are read");
        Require("Reference frame", text => AxesOf(text) is not null,
            "ICRF, the ecliptic of J2000 and the Earth's mean equator of J2000 are "
            + "read: REF_SYSTEM='ICRF', REF_PLANE='FRAME'");
        if (_header.TryGetValue("Start time", out (string Value, int Line) start) && !start.Value.EndsWith("TDB", StringComparison.Ordinal))
        {
            reading.Place.Line = start.Line;
            throw reading.Place.Error($"Start time: {NumberText.Shown(start.Value)}; TDB is read: TIME_TYPE='TDB'.");
        }

        (string format, int line) = Find("Output format");
        reading.Place.Line = line;
        return format.Split(' ', '(')[0] switch
        {
            "1" => 3,
            "2" or "3" => 6,
            _ => throw reading.Place.Error(
                $"Output format: {NumberText.Shown(format)}; 1 (position), 2 and 3 (position and velocity) are read: VEC_TABLE='2'."),
        };
    }

    private void Require(string key, Func<string, bool> isRight, string need, bool isOptional = false)
    {
        if (isOptional && !_header.ContainsKey(key))
        {
            return;
        }

        (string text, int line) = Find(key);
        if (!isRight(text))
        {
            reading.Place.Line = line;
            throw reading.Place.Error($"{key}: {NumberText.Shown(text)}; {need}.");
        }
    }

    private (string Value, int Line) Find(string key) => _header.TryGetValue(key, out (string Value, int Line) found)
        ? found
        : throw reading.Place.Error($"the head above $$SOE has no '{key}'. Get the whole answer of Horizons.");

    /// <summary>rad: the angle of the axes' x-y plane to the ICRF's; null for axes that are not read.</summary>
    private double? AxesOf(string frame)
    {
        // Until 2020 the frame was ICRF/J2000.0 always, and the plane had a line of its own.
        string plane = _header.TryGetValue("Coordinate systm", out (string Value, int) system) ? system.Value : frame;
        return !frame.StartsWith("ICRF", StringComparison.OrdinalIgnoreCase)
            && !frame.Equals("Ecliptic of J2000.0", StringComparison.OrdinalIgnoreCase) ? null
            : plane.StartsWith("Ecliptic", StringComparison.OrdinalIgnoreCase) ? Obliquity
            : plane.StartsWith("ICRF", StringComparison.OrdinalIgnoreCase)
                || plane.StartsWith("Earth Mean Equator", StringComparison.OrdinalIgnoreCase) ? 0.0
            : null;
    }

    private void ReadVectors(bool isCsv, int needed)
    {
        (double length, double time) = Units[Find("Output units").Value];
        RotationMatrix icrfFromAxes = RotationMatrix.FrameAboutX(-AxesOf(Find("Reference frame").Value)!.Value);
        _samples.Interpolation = needed == 6
            ? new Interpolation(InterpolationMethod.Hermite, 7)
            : new Interpolation(InterpolationMethod.Lagrange, 7);
        List<double> numbers = [];
        (TdbTime Time, int Line)? begun = null;
        while (reading.TryRead(out string line))
        {
            if (line == "$$EOE")
            {
                End();
                return;
            }

            Match date = isCsv ? CsvLine().Match(line) : DateLine().Match(line);
            if (date.Success)
            {
                End();
                begun = (TimeOf(date), reading.Place.Line);
                line = date.Groups["rest"].Value;
            }
            else if (begun is null || isCsv)
            {
                throw reading.Place.Error("a line with a Julian date and A.D. is needed here. Get the whole answer of Horizons.");
            }

            numbers.AddRange(Number().Matches(line).Select(match => reading.Place.Number(match.Value)));
        }

        throw reading.Place.Error("the file ends before the line $$EOE. Get the whole answer of Horizons.");

        void End()
        {
            if (begun is not { } state)
            {
                return;
            }

            if (numbers.Count < needed)
            {
                reading.Place.Line = state.Line;
                throw reading.Place.Error(Invariant($"{numbers.Count} numbers of a state; {needed} are needed. Get the answer again."));
            }

            if (_samples.Count > 0 && !(state.Time > _samples.Times.Last))
            {
                reading.Place.Line = state.Line;
                throw reading.Place.Error("the time is not after that of the state above. Remove one of them.");
            }

            _samples.Add(state.Time, new StateVector(
                length * (icrfFromAxes * new Vector3D(numbers[0], numbers[1], numbers[2])),
                needed == 6 ? (length / time) * (icrfFromAxes * new Vector3D(numbers[3], numbers[4], numbers[5])) : default));
            numbers.Clear();
            begun = null;
        }
    }

    /// <summary>The calendar date, which has no rounding on a grid of seconds; the Julian date where they differ.</summary>
    private TdbTime TimeOf(Match date)
    {
        double julian = SecondsPerDay * (reading.Place.Number(date.Groups["jd"].Value) - JulianDateOfJ2000);
        TdbTime calendar = reading.Time("TDB", date.Groups["date"].Value)
            ?? throw reading.Place.Error($"{NumberText.Shown(date.Groups["date"].Value)} is not a time. Get the answer of Horizons again.");
        return Math.Abs(calendar - julian) <= SameTime ? calendar : julian;
    }

    [GeneratedRegex(@"^(?<jd>\d+\.\d+)\s*=\s*A\.D\.\s*(?<date>[-\w]+ [\d:.]+)\s*TDB(?:\s*\[[^\]]*\])?(?<rest>)$")]
    private static partial Regex DateLine();

    [GeneratedRegex(@"^(?<jd>\d+\.\d+)\s*,\s*A\.D\.\s*(?<date>[-\w]+ [\d:.]+)\s*,(?<rest>.*)$")]
    private static partial Regex CsvLine();

    [GeneratedRegex(@"[-+]?\d+\.\d+(?:[EeDd][-+]?\d+)?")]
    private static partial Regex Number();
}
