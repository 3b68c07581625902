using Msisf.Core.Attitude;
using Msisf.Core.Ephemeris;
using Msisf.Core.Time;

namespace Msisf.Adapters.Ccsds;

/// <summary>An attitude ephemeris message (AEM): attitudes of a spacecraft.</summary>
/// <remarks>CCSDS 504.0-B-1 and B-2.</remarks>
/// <param name="place">Where the reader is.</param>
/// <param name="scale">Turns times into TDB.</param>
/// <param name="moonMeFromMoonPa">Reads the constant rotation from the Moon's principal axes.</param>
/// <param name="isRounded">Whether quaternions may be rounded to a few decimals.</param>
internal sealed class AemMessage(CcsdsPlace place, TimeScale scale, Func<RotationMatrix> moonMeFromMoonPa, bool isRounded)
    : CcsdsMessage(place, scale)
{
    private static readonly string[] OfBlock =
    [
        "COMMENT", "OBJECT_NAME", "OBJECT_ID", "CENTER_NAME", "REF_FRAME_A", "REF_FRAME_B", "ATTITUDE_DIR", "TIME_SYSTEM", "START_TIME",
        "USEABLE_START_TIME", "USEABLE_STOP_TIME", "STOP_TIME", "ATTITUDE_TYPE", "QUATERNION_TYPE", "EULER_ROT_SEQ", "RATE_FRAME",
        "ANGVEL_FRAME", "INTERPOLATION", "INTERPOLATION_METHOD", "INTERPOLATION_DEGREE",
    ];

    private readonly List<AttitudeBlock> _blocks = [];
    private IAttitudeSamples _samples = new AttitudeSamples();
    private AemColumns? _columns;
    private RotationMatrix? _moonMeFromFrame;

    /// <summary>The blocks so far.</summary>
    public IReadOnlyList<AttitudeBlock> Blocks => _blocks;

    public override string Kind => "AEM";

    public override string[] Keywords => OfBlock;

    protected override string[] Versions { get; } = ["1.0", "2.0"];

    private bool IsFirstVersion => Version == "1.0";

    public override (int Index, string Unit) PlaceOf(string parent, string name, string? axis) => _columns!.PlaceOf(parent, name, axis);

    public override void EndBlock()
    {
        if (_samples.Times.Count == 0)
        {
            Place.Note("A block has no attitudes; it is left out.");
            return;
        }

        if (!(_samples.Cover.Start <= _samples.Cover.End))
        {
            throw Metadata.Error("USEABLE_STOP_TIME", "no attitude lies between USEABLE_START_TIME and this. Check the times.");
        }

        CompareWith(_samples.Times);
        _blocks.Add(new AttitudeBlock(_samples, _moonMeFromFrame));
    }

    protected override void OpenBlock()
    {
        string a = Metadata.Require("REF_FRAME_A", "from which axes its attitudes turn");
        string b = Metadata.Require("REF_FRAME_B", "to which axes its attitudes turn");
        bool isKnownA = CcsdsFrames.TryFind(a, moonMeFromMoonPa, out RotationMatrix? fromA);
        bool isKnownB = CcsdsFrames.TryFind(b, moonMeFromMoonPa, out RotationMatrix? fromB);
        if (isKnownA == isKnownB)
        {
            throw Metadata.Error(isKnownA ? "REF_FRAME_B" : "REF_FRAME_A", isKnownA
                ? $"both frames are of space ({a}, {b}); one of them must be the spacecraft's."
                : $"one of REF_FRAME_A and REF_FRAME_B must be a frame of space: {CcsdsFrames.Frames}.");
        }

        RequireOneObject();

        _moonMeFromFrame = isKnownA ? fromA : fromB;
        _columns = AemColumns.Of(Metadata, IsFirstVersion) with
        {
            TurnsToFrame = isKnownA == IsFromBToA(),
            IsBodyB = isKnownA,
        };
        Interpolation said = ReadInterpolation() ?? (_columns.HasRates ? new Interpolation(InterpolationMethod.Hermite, 3) : default);
        if (said.Method == InterpolationMethod.Hermite && !_columns.HasRates)
        {
            Place.Note($"{said} needs rates, which {_columns.Type} has not; LAGRANGE of that degree is used.");
            said = said with { Method = InterpolationMethod.Lagrange };
        }

        _samples = _columns.AngleRatesOf is { } sequence
            ? new EulerAngleSamples(sequence, _columns.TurnsToFrame) { Useable = ReadUseable(), Interpolation = said }
            : new AttitudeSamples { Useable = ReadUseable(), Interpolation = said };
    }

    protected override void Add(TdbTime time, ReadOnlySpan<double> numbers, bool areNamed)
    {
        RequireLater(_samples.Times, time);
        try
        {
            UnitQuaternion frameFromBody = _columns!.FrameFromBody(numbers, areNamed, isRounded);
            if (_samples is EulerAngleSamples angles)
            {
                angles.Add(time, Radians(numbers), Radians(numbers[3..]));
            }
            else
            {
                Vector3D? rate = _columns.HasRates ? _columns.RateBody(numbers, areNamed, frameFromBody) : null;
                ((AttitudeSamples)_samples).Add(time, frameFromBody, rate);
            }
        }
        catch (BadInputException exception)
        {
            throw Place.Error(exception.Message, exception);
        }
    }

    private static Vector3D Radians(ReadOnlySpan<double> degrees) => new(
        double.DegreesToRadians(degrees[0]), double.DegreesToRadians(degrees[1]), double.DegreesToRadians(degrees[2]));

    /// <summary>Whether the attitudes turn from frame B to A.</summary>
    private bool IsFromBToA()
    {
        string? direction = Metadata.Find("ATTITUDE_DIR")?.ToUpperInvariant();
        return direction switch
        {
            "A2B" => false,
            "B2A" when IsFirstVersion => true,
            "B2A" => throw Metadata.Error("ATTITUDE_DIR", "version 2.0 turns from A to B always. Swap the frames, or write version 1.0."),
            null when !IsFirstVersion => false,
            null => throw Place.Error("the block above has no ATTITUDE_DIR (A2B or B2A), so both are possible. Add it."),
            _ => throw Metadata.Error("ATTITUDE_DIR", "A2B and B2A are known."),
        };
    }
}
