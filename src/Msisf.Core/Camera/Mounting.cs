namespace Msisf.Core.Camera;

/// <summary>How a camera sits on the body that carries it. <c>default</c> has no orientation and is not a mounting.</summary>
/// <param name="BodyFromCamera">Turns camera axes into the body's.</param>
/// <param name="OffsetBody">m: the focal point as seen from the body's origin, along the body's axes.</param>
public readonly record struct Mounting(UnitQuaternion BodyFromCamera, Vector3D OffsetBody)
{
    /// <summary>Takes the numbers of a mounting.</summary>
    /// <param name="quaternion">Body from camera, the scalar last.</param>
    /// <param name="offset">m, body axes.</param>
    /// <param name="isRounded">Whether the quaternion may be rounded to a few decimals.</param>
    /// <exception cref="BadInputException">The quaternion is not a rotation.</exception>
    public static Mounting Of(ReadOnlySpan<double> quaternion, ReadOnlySpan<double> offset, bool isRounded = false)
    {
        double length = double.Hypot(double.Hypot(quaternion[0], quaternion[1]), double.Hypot(quaternion[2], quaternion[3]));
        double error = Math.Abs(length - 1.0);
        string cure = error <= Tolerances.RoundedRotation ? ". Add decimals, or give --normalize." : ".";
        return error <= (isRounded ? Tolerances.RoundedRotation : Tolerances.UnitQuaternionLength)
            ? new Mounting(
                UnitQuaternion.FromComponents(quaternion[0], quaternion[1], quaternion[2], quaternion[3], isRounded),
                new Vector3D(offset[0], offset[1], offset[2]))
            : throw new BadInputException(Invariant(
                $"'quaternion' has length {length:R}, and a rotation needs length 1: qx, qy, qz and the scalar q0, each with at least 7 "
                    + $"decimals{cure}"));
    }

    /// <summary>Where the camera is.</summary>
    /// <param name="body">Position and orientation of the body; its orientation turns body axes into Moon axes.</param>
    public CameraState Of(CameraState body) => body with
    {
        PositionBodyFixed = body.PositionBodyFixed + (body.MoonFromCamera * OffsetBody),
        MoonFromCamera = BodyFromCamera == UnitQuaternion.Identity // so that no last digit changes
            ? body.MoonFromCamera
            : body.MoonFromCamera * BodyFromCamera,
    };

    /// <summary>How the camera moves: the offset turns with the body.</summary>
    /// <param name="body">How the body moves; its turn is about the body's axes.</param>
    public CameraMotion Of(CameraMotion body, UnitQuaternion moonFromBody) => new(
        body.VelocityBodyFixed + (moonFromBody * Vector3D.Cross(body.AngularVelocityCamera, OffsetBody)),
        BodyFromCamera == UnitQuaternion.Identity
            ? body.AngularVelocityCamera
            : BodyFromCamera.Conjugate * body.AngularVelocityCamera);

    /// <summary>The camera as another one on the same body has it: its orientation and its focal point in the other's axes.</summary>
    public Mounting SeenFrom(Mounting other) => new(
        other.BodyFromCamera.Conjugate * BodyFromCamera, other.BodyFromCamera.Conjugate * (OffsetBody - other.OffsetBody));
}

/// <summary>A camera of a rig.</summary>
public sealed record MountedCamera(string Name, Mounting Mounting)
{
    /// <summary>What a name may be, for messages.</summary>
    public const string Names = "1 to 40 letters, digits, '-' and '_' are possible, because it is part of file names";

    private const int LongestName = 40;

    /// <summary>Whether a text can be a camera's name.</summary>
    public static bool IsName(string text) =>
        text.Length is > 0 and <= LongestName && text.All(letter => char.IsAsciiLetterOrDigit(letter) || letter is '-' or '_');
}

/// <summary>One of several cameras on a body (docs/cameras.md). Immutable.</summary>
/// <param name="Index">Which one it is, from 0.</param>
public sealed record RigCamera(IReadOnlyList<MountedCamera> Cameras, int Index)
{
    /// <summary>Its name.</summary>
    public string Name => Cameras[Index].Name;

    /// <summary>How it sits on the body.</summary>
    public Mounting Mounting => Cameras[Index].Mounting;
}
