using Msisf.Adapters.Input;
using Msisf.Core.Ephemeris;
using Msisf.Core.Orbit;
using Msisf.Core.Time;
using System.Text.RegularExpressions;

namespace Msisf.Adapters.Trajectories;

/// <summary>An ephemeris of STK (.e): positions, or positions and velocities, at seconds since an epoch.</summary>
/// <remarks>STK's help, "Ephemeris file format (*.e)". Times are UTC; lengths are m where the file does not say it.</remarks>
/// <param name="reading">The file.</param>
internal sealed partial class StkEphemeris(TrajectoryReading reading)
{
    private const int DefaultOrder = 5;

    private static readonly Dictionary<string, double> Units = new(StringComparer.OrdinalIgnoreCase)
    {
        ["Meters"] = 1.0,
        ["Kilometers"] = 1000.0,
        ["Feet"] = 0.3048,
        ["NauticalMiles"] = 1852.0,
        ["StatuteMiles"] = 1609.344,
    };

    private static readonly Dictionary<string, int> Bodies = new(StringComparer.OrdinalIgnoreCase)
    {
        ["Moon"] = CelestialBody.Moon.NaifNumber,
        ["Luna"] = CelestialBody.Moon.NaifNumber,
        ["Earth"] = 399,
    };

    /// <summary>Sections of data: the numbers of a line behind the time.</summary>
    private static readonly Dictionary<string, int> Data = new(StringComparer.OrdinalIgnoreCase)
    {
        ["EphemerisTimePos"] = 3,
        ["EphemerisTimePosVel"] = 6,
        ["EphemerisTimePosVelAcc"] = 9,
    };

    private readonly Dictionary<string, (string Value, int Line)> _keywords = new(StringComparer.OrdinalIgnoreCase);
    private readonly List<TrajectoryBlock> _blocks = [];
    private StateSamples _samples = new();

    /// <summary>With what a file begins.</summary>
    [GeneratedRegex(@"\A\s*stk\.v\.\d[\s\S]*BEGIN\s+Ephemeris", RegexOptions.IgnoreCase)]
    public static partial Regex Head { get; }

    /// <summary>Reads the file.</summary>
    /// <exception cref="BadInputException">The first thing that is wrong, by file and line.</exception>
    public IReadOnlyList<TrajectoryBlock> Read()
    {
        while (TryReadContent(out string line))
        {
            string[] words = line.Split((char[]?)null, 2, StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries);
            if (Data.TryGetValue(words[0], out int numbers))
            {
                ReadData(numbers);
                return _blocks;
            }

            if (words[0].StartsWith("Ephemeris", StringComparison.OrdinalIgnoreCase))
            {
                throw reading.Place.Error($"{NumberText.Shown(words[0])} is not read; {string.Join(", ", Data.Keys)} are. Export the "
                    + "ephemeris with Cartesian states.");
            }

            if (words[0].Equals("BEGIN", StringComparison.OrdinalIgnoreCase) && words.Length == 2
                && !words[1].Equals("Ephemeris", StringComparison.OrdinalIgnoreCase))
            {
                Skip();
            }
            else if (words.Length == 2)
            {
                _keywords[words[0]] = (words[1].Trim('"', ' '), reading.Place.Line);
            }
        }

        throw reading.Place.Error($"the file has no section of states: {string.Join(", ", Data.Keys)}. Export it again.");
    }

    /// <summary>A line without its comment.</summary>
    private bool TryReadContent(out string line)
    {
        while (reading.TryRead(out line))
        {
            line = line.Split('#')[0].Trim();
            if (line.Length > 0)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>Leaves a section out, such as SegmentBoundaryTimes: a time that occurs twice says the same.</summary>
    private void Skip()
    {
        int first = reading.Place.Line;
        while (TryReadContent(out string line))
        {
            if (line.StartsWith("END", StringComparison.OrdinalIgnoreCase))
            {
                return;
            }
        }

        reading.Place.Line = first;
        throw reading.Place.Error("the section that begins here has no END. Get the whole file.");
    }

    private void ReadData(int needed)
    {
        TdbTime epoch = Epoch();
        Instant start = reading.Scale.InstantOf(epoch);
        double unit = Named("DistanceUnit", Units, "Meters", "Convert it to one of them");
        int center = Named("CentralBody", Bodies, "Earth", "Export it about one of them");
        RotationMatrix? moonMeFromFrame = Frame(center);
        Interpolation interpolation = InterpolationOf(needed > 3);
        while (TryReadContent(out string line) && !line.StartsWith("END", StringComparison.OrdinalIgnoreCase)
            && !char.IsAsciiLetter(line[0]))
        {
            string[] words = line.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries);
            if (words.Length != needed + 1)
            {
                throw reading.Place.Error(Invariant($"{words.Length} numbers; {needed + 1} are needed, the time and {needed} more."));
            }

            double[] numbers = [.. words.Select(word => reading.Place.Number(word))];
            TdbTime time = start.After(numbers[0]).Tdb;
            if (_samples.Count > 0 && !(time > _samples.Times.Last))
            {
                if (time < _samples.Times.Last)
                {
                    throw reading.Place.Error("the time is before that of the line above. Put the lines into the order of time.");
                }

                EndBlock(); // a time that occurs twice ends a segment: at a manoeuvre
            }

            _samples.Interpolation = interpolation;
            _samples.Add(time, new StateVector(
                unit * new Vector3D(numbers[1], numbers[2], numbers[3]),
                needed > 3 ? unit * new Vector3D(numbers[4], numbers[5], numbers[6]) : default));
        }

        EndBlock();

        void EndBlock()
        {
            if (_samples.Count > 0)
            {
                _blocks.Add(new TrajectoryBlock(_samples, center, moonMeFromFrame));
                _samples = new StateSamples();
            }
        }
    }

    private TdbTime Epoch()
    {
        (string text, int line) = _keywords.TryGetValue("ScenarioEpoch", out (string, int) found)
            ? found
            : throw reading.Place.Error("the file has no ScenarioEpoch, from which its times count. Add it above the states.");
        reading.Place.Line = line;
        return reading.Time("UTC", text)
            ?? throw reading.Place.Error($"ScenarioEpoch {NumberText.Shown(text)} is not a time such as 6 Apr 2010 20:00:00.000.");
    }

    private T Named<T>(string keyword, Dictionary<string, T> known, string usual, string cure)
    {
        (string text, int line) = _keywords.GetValueOrDefault(keyword, (usual, reading.Place.Line));
        int here = reading.Place.Line;
        reading.Place.Line = line;
        T value = known.TryGetValue(text, out T? found)
            ? found
            : throw reading.Place.Error($"{keyword} {NumberText.Shown(text)} is not read; {string.Join(", ", known.Keys)} are. {cure}.");
        reading.Place.Line = here;
        return value;
    }

    /// <summary>The constant rotation from a frame that turns with the Moon; null for J2000's axes.</summary>
    private RotationMatrix? Frame(int center)
    {
        Dictionary<string, Func<RotationMatrix>?> frames = new(StringComparer.OrdinalIgnoreCase) { ["ICRF"] = null, ["J2000"] = null };
        if (center == CelestialBody.Moon.NaifNumber)
        {
            frames["MeanEarth"] = () => RotationMatrix.Identity;
            frames["PrincipalAxes_421"] = reading.MoonMeFromMoonPa;
        }

        return Named("CoordinateSystem", frames, "Fixed", "Export it in one of them")?.Invoke();
    }

    private Interpolation InterpolationOf(bool hasVelocities)
    {
        string method = _keywords.TryGetValue("InterpolationMethod", out (string Value, int) said) ? said.Value : "Lagrange";
        bool isHermite = method.Equals("Hermite", StringComparison.OrdinalIgnoreCase);
        if (!isHermite && !method.Equals("Lagrange", StringComparison.OrdinalIgnoreCase))
        {
            reading.Place.Note($"InterpolationMethod {NumberText.Shown(method)} is not known: Lagrange is used.");
        }

        int order = Whole("InterpolationOrder") ?? Whole("InterpolationSamplesM1") ?? DefaultOrder;
        int highest = SampleWeights.MaxSamples - 1;
        return isHermite && hasVelocities
            ? new Interpolation(InterpolationMethod.Hermite, Math.Min(highest - 1 + (highest % 2), (2 * order) + 1))
            : new Interpolation(InterpolationMethod.Lagrange, Math.Min(highest, order));
    }

    private int? Whole(string keyword) => _keywords.TryGetValue(keyword, out (string Value, int Line) found)
        && int.TryParse(found.Value, NumberStyles.None, CultureInfo.InvariantCulture, out int number) && number > 0
        ? number
        : null;
}
