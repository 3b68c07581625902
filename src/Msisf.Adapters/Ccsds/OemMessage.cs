using Msisf.Core.Ephemeris;
using Msisf.Core.Orbit;
using Msisf.Core.Time;

namespace Msisf.Adapters.Ccsds;

/// <summary>An orbit ephemeris message (OEM): states of a spacecraft.</summary>
/// <remarks>CCSDS 502.0-B-1 to B-3.</remarks>
/// <param name="place">Where the reader is.</param>
/// <param name="scale">Turns times into TDB.</param>
/// <param name="moonMeFromMoonPa">Reads the constant rotation from the Moon's principal axes.</param>
internal sealed class OemMessage(CcsdsPlace place, TimeScale scale, Func<RotationMatrix> moonMeFromMoonPa) : CcsdsMessage(place, scale)
{
    private const double MetresPerKilometre = 1000.0;

    private static readonly string[] Names = ["X", "Y", "Z", "X_DOT", "Y_DOT", "Z_DOT", "X_DDOT", "Y_DDOT", "Z_DDOT"];

    private static readonly string[] OfBlock =
    [
        "COMMENT", "OBJECT_NAME", "OBJECT_ID", "CENTER_NAME", "REF_FRAME", "REF_FRAME_EPOCH", "TIME_SYSTEM", "START_TIME",
        "USEABLE_START_TIME", "USEABLE_STOP_TIME", "STOP_TIME", "INTERPOLATION", "INTERPOLATION_METHOD", "INTERPOLATION_DEGREE",
    ];

    private readonly List<TrajectoryBlock> _blocks = [];
    private readonly OemJoints _joints = new();
    private readonly OemPull _pull = new();
    private StateSamples _samples = new();
    private Interpolation? _said;

    /// <summary>The blocks so far.</summary>
    public IReadOnlyList<TrajectoryBlock> Blocks => _blocks;

    /// <summary>What is to be said of lines that contradict each other; null if none do.</summary>
    public string? Warning => _joints.Warning is { } warning ? $"{Place.FileName}{warning}" : null;

    public override string Kind => "OEM";

    public override string[] Keywords => OfBlock;

    protected override string[] Versions { get; } = ["1.0", "2.0", "3.0"];

    public override (int Index, string Unit) PlaceOf(string parent, string name, string? axis)
    {
        int index = Array.IndexOf(Names, name);
        return (index, index < 3 ? "km" : index < 6 ? "km/s" : "km/s**2");
    }

    public override void EndBlock()
    {
        if (_samples.Count == 0)
        {
            Place.Note("A block has no states; it is left out.");
            return;
        }

        Interpolation wanted = _said ?? new Interpolation(InterpolationMethod.Hermite, DefaultDegree);
        if (wanted.Method == InterpolationMethod.Hermite && !_samples.HasVelocities && _samples.Count > 1)
        {
            Place.Note($"All velocities of a block are 0: {wanted} is not possible; LAGRANGE of that degree is used.");
            wanted = new Interpolation(InterpolationMethod.Lagrange, wanted.Degree);
        }

        if (_samples.Count < wanted.Samples && _said is not null)
        {
            Place.Note(Invariant(
                $"{wanted} needs {wanted.Samples} states, a block has {_samples.Count}: they are used with a lower degree."));
        }

        _samples.Interpolation = wanted;
        if (!(_samples.Cover.Start <= _samples.Cover.End))
        {
            throw Metadata.Error("USEABLE_STOP_TIME", "no state of the block lies between USEABLE_START_TIME and this. Check the times.");
        }

        CompareWith(_samples.Times);
        string frame = Metadata.Require("REF_FRAME", "in which axes its numbers are");
        string center = Metadata.Require("CENTER_NAME", "about which body its numbers are");
        if (_pull.Contradiction(center) is { } contradiction)
        {
            Place.Note(contradiction);
        }

        CcsdsFrames.TryFind(frame, moonMeFromMoonPa, out RotationMatrix? moonMeFromFrame);
        _blocks.Add(new TrajectoryBlock(_samples, CcsdsFrames.Center(center)!.Value, moonMeFromFrame));
    }

    protected override void OpenBlock()
    {
        string center = Metadata.Require("CENTER_NAME", "about which body its numbers are");
        if (CcsdsFrames.Center(center) is null)
        {
            throw Metadata.Error("CENTER_NAME", $"{CcsdsFrames.Centers}. Convert the file to one of them.");
        }

        string frame = Metadata.Require("REF_FRAME", "in which axes its numbers are");
        if (!CcsdsFrames.TryFind(frame, moonMeFromMoonPa, out RotationMatrix? moonMeFromFrame))
        {
            throw Metadata.Error("REF_FRAME", $"{CcsdsFrames.Frames}. Convert the file to one of them.");
        }

        if (moonMeFromFrame is not null && CcsdsFrames.Center(center) != CelestialBody.Moon.NaifNumber)
        {
            throw Metadata.Error("REF_FRAME", $"it turns with the Moon, but CENTER_NAME is {center}. Check the two.");
        }

        RequireOneObject();

        _said = ReadInterpolation();
        if (_said is { Method: InterpolationMethod.Hermite } said && said.Degree % 2 == 0)
        {
            Place.Note(Invariant($"{said} needs an odd degree; {said.Degree + 1} is used."));
            _said = said with { Degree = said.Degree + 1 };
        }

        _samples = new StateSamples { Useable = ReadUseable() };
        _joints.BeginBlock();
        _pull.BeginBlock();
    }

    protected override void Add(TdbTime time, ReadOnlySpan<double> numbers, bool areNamed)
    {
        if (numbers.Length is not (6 or 9))
        {
            throw Place.Error(Invariant(
                $"{numbers.Length} numbers behind the time; 6 are needed (X Y Z X_DOT Y_DOT Z_DOT), or 9 with accelerations."));
        }

        RequireLater(_samples.Times, time);
        StateVector state = new(
            MetresPerKilometre * new Vector3D(numbers[0], numbers[1], numbers[2]),
            MetresPerKilometre * new Vector3D(numbers[3], numbers[4], numbers[5]));
        _samples.Add(time, state);
        _joints.Add(time, state, Place.Line);
        _pull.Add(time, state.Position);
    }
}

/// <summary>
/// Finds lines of an OEM whose positions and velocities contradict each other: parts that were joined without a new block, or velocities
/// of another unit or frame.
/// </summary>
internal sealed class OemJoints
{
    /// <summary>m: below this, positions are rounded.</summary>
    private const double Rounding = 1.0;

    /// <summary>
    /// 1: the way between two lines is the mean of their velocities times the time, but for h^2 / 12 of the change of the acceleration;
    /// that is at most a sixth of h times the change of velocity while the acceleration at most doubles. In Artemis I's file, 73 of
    /// 9,210 pairs of lines are above this with the rounding; all others are below 0.8 of it.
    /// </summary>
    private const double MaxPart = 0.25;

    private TdbTime _time;
    private StateVector _state;
    private bool _isFirst;
    private int _count;
    private int _firstLine;
    private double _greatest;
    private int _greatestLine;

    /// <summary>What is to be said, behind the file's name; null if no lines contradict each other.</summary>
    public string? Warning => _count == 0 ? null : Invariant(
        $", line {_firstLine}: position and velocity contradict those of the line before, and so {_count} times, most in line "
            + $"{_greatestLine} by {_greatest / 1000.0:0.0##} km. Either parts were joined without a new block, and states within some "
            + $"lines of such a place may be that far off; or the velocities are of another unit or frame.");

    /// <summary>The next line has none before it.</summary>
    public void BeginBlock() => _isFirst = true;

    /// <summary>Takes a line.</summary>
    /// <param name="state">Position (m) and velocity (m/s); a velocity of 0 is none.</param>
    public void Add(TdbTime time, StateVector state, int line)
    {
        if (!_isFirst && state.Velocity != default && _state.Velocity != default)
        {
            double step = time - _time;
            Vector3D mean = 0.5 * (_state.Velocity + state.Velocity);
            double error = (state.Position - _state.Position - (step * mean)).Length;
            if (error > Rounding + (MaxPart * step * (state.Velocity - _state.Velocity).Length))
            {
                _firstLine = _count++ == 0 ? line : _firstLine;
                (_greatest, _greatestLine) = error > _greatest ? (error, line) : (_greatest, _greatestLine);
            }
        }

        (_time, _state, _isFirst) = (time, state, false);
    }
}

/// <summary>
/// Finds what an orbit's own curvature says of its centre and unit: a spacecraft that is pulled as the Moon pulls flies about the Moon.
/// </summary>
internal sealed class OemPull
{
    /// <summary>1: how far the pull of a block may be from that of a body; the least quotient of two candidates is 81.</summary>
    private const double Factor = 2.0;

    /// <summary>1: cosine of the greatest angle between the pull and the centre, so that other bodies and engines play no part.</summary>
    private const double MinCosine = 0.95;

    /// <summary>1: the greatest part of the distance that lines may be apart, so that the way between them curves little.</summary>
    private const double MaxStep = 0.3;

    /// <summary>Lines that tell nothing of a body's pull, because they are few.</summary>
    private const int MinCount = 5;

    /// <summary>m^3/s^2 of DE421, if the numbers are in km as they must be, and a thousand times as long if they are in m.</summary>
    private static readonly (double Gm, string Center, string Unit)[] Candidates =
    [
        (4.902800076e12, "MOON", "km"), (3.98600436e14, "EARTH", "km"), (4.902800076e21, "MOON", "m"), (3.98600436e23, "EARTH", "m"),
    ];

    /// <summary>How many pulls are up to the least, and below the greatest, of each candidate: so the median needs no list.</summary>
    private readonly (int UpToLeast, int BelowGreatest)[] _counts = new (int, int)[Candidates.Length];
    private int _pulls;
    private (TdbTime Time, Vector3D Position) _first;
    private (TdbTime Time, Vector3D Position) _second;
    private int _count;

    /// <summary>The next line has none before it.</summary>
    public void BeginBlock()
    {
        (_count, _pulls) = (0, 0);
        Array.Clear(_counts);
    }

    /// <summary>Takes a line.</summary>
    /// <param name="position">m, if the file has km.</param>
    public void Add(TdbTime time, Vector3D position)
    {
        if (_count++ >= 2)
        {
            (double before, double after) = (_second.Time - _first.Time, time - _second.Time);
            Vector3D acceleration = 2.0 / (before + after)
                * (((position - _second.Position) / after) - ((_second.Position - _first.Position) / before));
            double distance = _second.Position.Length;
            double towards = -Vector3D.Dot(acceleration, _second.Position) / distance;
            if (towards > MinCosine * acceleration.Length && (position - _first.Position).Length < MaxStep * distance)
            {
                Count(towards * distance * distance);
            }
        }

        (_first, _second) = (_second, (time, position));
    }

    private void Count(double pull)
    {
        _pulls++;
        for (int i = 0; i < _counts.Length; i++)
        {
            _counts[i].UpToLeast += pull <= Candidates[i].Gm / Factor ? 1 : 0;
            _counts[i].BelowGreatest += pull < Candidates[i].Gm * Factor ? 1 : 0;
        }
    }

    /// <summary>What is to be said of a block that is pulled as another body pulls, or as if it were in m; null for nothing.</summary>
    /// <param name="center">Its CENTER_NAME.</param>
    public string? Contradiction(string center)
    {
        if (_pulls < Math.Max(MinCount, _count / 2))
        {
            return null;
        }

        int ofMedian = Array.FindIndex(_counts, count => count.UpToLeast <= _pulls / 2 && count.BelowGreatest > _pulls / 2);
        bool isMoon = CcsdsFrames.Center(center) == CelestialBody.Moon.NaifNumber;
        (double gm, string body, string unit) = ofMedian < 0 ? default : Candidates[ofMedian];
        string? wrong = gm == 0.0 || (unit == "km" && isMoon == (body == "MOON")) ? null
            : unit == "km" ? $"CENTER_NAME is {center}"
            : "an OEM has km and km/s";
        return wrong is null
            ? null
            : $"The lines of a block curve as an orbit about the {body[..1]}{body[1..].ToLowerInvariant()} in {unit} does, but {wrong}. "
                + "Check the file; it is read as written.";
    }
}
