using Msisf.Core.Attitude;

namespace Msisf.Adapters.Ccsds;

/// <summary>What the numbers of an AEM's lines mean.</summary>
/// <param name="Type">ATTITUDE_TYPE in capitals.</param>
internal sealed record AemColumns(string Type)
{
    private const string Quaternion = "QUATERNION";

    private static readonly (string Type, int Count)[] Known =
    [
        ("QUATERNION", 4), ("QUATERNION/DERIVATIVE", 8), ("QUATERNION/RATE", 7), ("QUATERNION/ANGVEL", 7), ("EULER_ANGLE", 3),
        ("EULER_ANGLE/RATE", 6), ("EULER_ANGLE/DERIVATIVE", 6), ("EULER_ANGLE/ANGVEL", 6),
    ];

    private static readonly string[] QuaternionNames = ["Q1", "Q2", "Q3", "QC"];
    private static readonly string[] DerivativeNames = ["Q1_DOT", "Q2_DOT", "Q3_DOT", "QC_DOT"];

    /// <summary>Whether the attitudes turn the axes of space into the spacecraft's by the quaternion's own product q v q*.</summary>
    public bool TurnsToFrame { get; init; }

    /// <summary>Whether REF_FRAME_B is the spacecraft's.</summary>
    public bool IsBodyB { get; init; }

    /// <summary>Whether lines have rates from which polynomials can be made.</summary>
    public bool HasRates => Type.Contains('/', StringComparison.Ordinal);

    /// <summary>
    /// The sequence of angles whose derivatives the lines have; null for other lines. Version 1.0 calls the type EULER_ANGLE/RATE.
    /// </summary>
    public EulerSequence? AngleRatesOf => Type is "EULER_ANGLE/DERIVATIVE" or "EULER_ANGLE/RATE" ? Sequence : null;

    private bool IsScalarFirst { get; init; }

    private EulerSequence? Sequence { get; init; }

    /// <summary>Whether the angular velocity is about the axes of REF_FRAME_B.</summary>
    private bool IsRateOfB { get; init; }

    private int Count => Known.First(known => known.Type == Type).Count;

    /// <summary>Reads the keywords of a block.</summary>
    /// <param name="isFirstVersion">Whether the file is of version 1.0.</param>
    public static AemColumns Of(CcsdsMetadata metadata, bool isFirstVersion)
    {
        string type = metadata.Require("ATTITUDE_TYPE", "what its numbers are").ToUpperInvariant().Replace(' ', '_');
        if (!Known.Any(known => known.Type == type))
        {
            throw metadata.Error("ATTITUDE_TYPE", $"{string.Join(", ", Known.Select(known => known.Type))} are read.");
        }

        bool isQuaternion = type.StartsWith(Quaternion, StringComparison.Ordinal);
        return new AemColumns(type)
        {
            IsScalarFirst = isQuaternion && IsFirst(metadata, isFirstVersion),
            Sequence = isQuaternion ? null : SequenceOf(metadata),
            IsRateOfB = type is "QUATERNION/RATE" or "QUATERNION/ANGVEL" or "EULER_ANGLE/ANGVEL" && IsRateFrameB(metadata),
            IsOrderOpen = isFirstVersion,
        };
    }

    /// <summary>Whether the angles may be in the order of the axes or of the sequence.</summary>
    private bool IsOrderOpen { get; init; }

    /// <summary>The place of an element of the XML form in a line.</summary>
    public (int Index, string Unit) PlaceOf(string parent, string name, string? axis)
    {
        if (Array.IndexOf(QuaternionNames, name) is >= 0 and int part)
        {
            return (part, string.Empty);
        }

        if (Array.IndexOf(DerivativeNames, name) is >= 0 and int derivative)
        {
            return (4 + derivative, "1/s");
        }

        int ofAxis = name.Length > 0 ? "XYZ".IndexOf(name[^1], StringComparison.Ordinal) : -1;
        int ofNumber = name.Length > 0 ? "123".IndexOf(name[^1], StringComparison.Ordinal) : -1;
        int after = Sequence is null ? 4 : 3;
        if (name.StartsWith("ANGVEL_", StringComparison.Ordinal))
        {
            return (ofAxis < 0 ? -1 : after + ofAxis, "deg/s");
        }

        if (name.StartsWith("ANGLE_", StringComparison.Ordinal) && name.EndsWith("_DOT", StringComparison.Ordinal))
        {
            return ("123".IndexOf(name["ANGLE_".Length], StringComparison.Ordinal) is >= 0 and int rate ? 3 + rate : -1, "deg/s");
        }

        if (name.StartsWith("ANGLE_", StringComparison.Ordinal))
        {
            return (ofNumber, "deg");
        }

        if (!name.StartsWith("rotation", StringComparison.Ordinal) || ofNumber < 0)
        {
            return (-1, string.Empty);
        }

        if (parent == "rotationAngles" && axis is not null && Sequence is { } sequence && axis[0] != sequence.Axes[ofNumber])
        {
            throw new BadInputException(
                $"{name} is about {axis}, but EULER_ROT_SEQ {sequence.Axes} has {sequence.Axes[ofNumber]} there. Check the two.");
        }

        return parent == "rotationAngles" ? (ofNumber, "deg") : (after + ofNumber, "deg/s");
    }

    /// <summary>The attitude of a line.</summary>
    /// <param name="numbers">Behind the time.</param>
    /// <param name="areNamed">Whether they come from the XML form, in the order Q1, Q2, Q3, QC or that of the Euler angles.</param>
    /// <param name="isRounded">Whether a quaternion may be rounded to a few decimals.</param>
    public UnitQuaternion FrameFromBody(ReadOnlySpan<double> numbers, bool areNamed, bool isRounded)
    {
        if (numbers.Length != Count)
        {
            throw new BadInputException(Invariant($"{numbers.Length} numbers behind the time; {Type} has {Count}."));
        }

        UnitQuaternion given = Sequence is { } sequence
            ? OfAngles(sequence, numbers, areNamed)
            : OfQuaternion(InOrder(numbers, areNamed), isRounded);
        return TurnsToFrame ? given.Conjugate : given;
    }

    /// <summary>The angular velocity of a line that has one.</summary>
    /// <returns>rad/s of the spacecraft in the frame, about the spacecraft's axes.</returns>
    public Vector3D RateBody(ReadOnlySpan<double> numbers, bool areNamed, UnitQuaternion frameFromBody)
    {
        if (Type == "QUATERNION/DERIVATIVE")
        {
            (double x, double y, double z, double w) = InOrder(numbers, areNamed);
            (double dx, double dy, double dz, double dw) = InOrder(numbers[4..], areNamed);
            (Vector3D v, Vector3D dv) = (new Vector3D(x, y, z), new Vector3D(dx, dy, dz));
            if (TurnsToFrame)
            {
                (v, dv) = (-v, -dv);
            }

            // Twice the imaginary part of q* dq, for a q whose printed length may differ from 1.
            double square = v.LengthSquared + (w * w);
            return 2.0 / square * ((w * dv) - (dw * v) - Vector3D.Cross(v, dv));
        }

        ReadOnlySpan<double> degrees = numbers[^3..];
        Vector3D rate = new(
            double.DegreesToRadians(degrees[0]), double.DegreesToRadians(degrees[1]), double.DegreesToRadians(degrees[2]));
        Vector3D ofBody = IsBodyB ? rate : -rate; // it is that of B as seen from A
        return IsRateOfB == IsBodyB ? ofBody : frameFromBody.Conjugate * ofBody;
    }

    private UnitQuaternion OfAngles(EulerSequence sequence, ReadOnlySpan<double> degrees, bool areNamed)
    {
        if (IsOrderOpen && !areNamed && sequence.Axes != "XYZ")
        {
            throw new BadInputException(
                $"version 1.0 leaves open whether the angles are in the order X, Y, Z or in that of EULER_ROT_SEQ ({sequence.Axes}). "
                    + "Write version 2.0, XML or quaternions.");
        }

        return sequence.FrameFromBody([
            double.DegreesToRadians(degrees[0]), double.DegreesToRadians(degrees[1]), double.DegreesToRadians(degrees[2])]);
    }

    private static UnitQuaternion OfQuaternion((double X, double Y, double Z, double W) q, bool isRounded)
    {
        double length = double.Hypot(double.Hypot(q.X, q.Y), double.Hypot(q.Z, q.W));
        double limit = isRounded ? Tolerances.RoundedRotation : Tolerances.PrintedQuaternionLength;
        return Math.Abs(length - 1.0) <= limit
            ? UnitQuaternion.FromComponents(q.X / length, q.Y / length, q.Z / length, q.W / length)
            : throw new BadInputException(Invariant(
                $"the quaternion has length {length:G5}; 1 within {limit:R} is needed. "
                    + $"{(isRounded ? "Check its numbers." : "Check its numbers, or give --normalize if they are rounded.")}"));
    }

    private (double X, double Y, double Z, double W) InOrder(ReadOnlySpan<double> q, bool areNamed) =>
        IsScalarFirst && !areNamed ? (q[1], q[2], q[3], q[0]) : (q[0], q[1], q[2], q[3]);

    private static bool IsFirst(CcsdsMetadata metadata, bool isFirstVersion) =>
        metadata.Find("QUATERNION_TYPE")?.ToUpperInvariant() switch
        {
            "LAST" => false,
            "FIRST" when isFirstVersion => true,
            "FIRST" => throw metadata.Error("QUATERNION_TYPE", "version 2.0 has the scalar last always. Check the file."),
            null when !isFirstVersion => false,
            null => throw metadata.Error(
                "ATTITUDE_TYPE", "the block has no QUATERNION_TYPE (FIRST or LAST), so the scalar may be in either place. Add it."),
            _ => throw metadata.Error("QUATERNION_TYPE", "FIRST and LAST are known."),
        };

    private static EulerSequence SequenceOf(CcsdsMetadata metadata)
    {
        string text = metadata.Require("EULER_ROT_SEQ", "about which axes its angles turn");
        try
        {
            return EulerSequence.Parse(text.ToUpperInvariant());
        }
        catch (BadInputException exception)
        {
            throw metadata.Error("EULER_ROT_SEQ", exception.Message);
        }
    }

    private static bool IsRateFrameB(CcsdsMetadata metadata)
    {
        bool isFirstName = metadata.Find("ANGVEL_FRAME") is null
            && (metadata.Find("RATE_FRAME") is not null
                || metadata.Find("ATTITUDE_TYPE")!.EndsWith("/RATE", StringComparison.OrdinalIgnoreCase));
        string key = isFirstName ? "RATE_FRAME" : "ANGVEL_FRAME";
        string frame = metadata.Require(key, "about which axes its rates are").ToUpperInvariant();
        string a = metadata.Find("REF_FRAME_A")!.ToUpperInvariant();
        string b = metadata.Find("REF_FRAME_B")!.ToUpperInvariant();
        return frame == "REF_FRAME_B" || frame == b
            || (frame == "REF_FRAME_A" || frame == a ? false : throw metadata.Error(key, $"{a} and {b} are the block's frames."));
    }
}
