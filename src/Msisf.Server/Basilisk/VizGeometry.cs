using Msisf.Core.Scene;
using Msisf.Core.Time;

namespace Msisf.Server.Basilisk;

/// <summary>
/// The state of a camera of Basilisk over the Moon. Its names of frames: N, the inertial axes; P, the Moon's; B, the spacecraft's; U,
/// Unity's camera axes, of which the message has x = -z, y = x, z = -y of the camera's own (x right, y down, z along the line of sight).
/// So they are the camera axes of the thesis: it looks along -x, y is right, z up.
/// </summary>
internal static class VizGeometry
{
    /// <summary>Tolerance of a rotation that is given with at least six digits, rad.</summary>
    private const double RotationError = 1e-6;

    /// <summary>rad: beyond it the time of the message is wrong; MOON_ME and IAU_MOON differ by half as much.</summary>
    private static readonly double LargestTurn = double.DegreesToRadians(0.01);

    /// <summary>The matrix that turns N into the Moon's axes, as the message has it.</summary>
    /// <exception cref="BadInputException">It is not a rotation.</exception>
    public static UnitQuaternion MoonFromInertial(VizBody moon)
    {
        IReadOnlyList<double> m = moon.BodyFromInertial;
        if (m.Count != 9)
        {
            throw new BadInputException(Invariant($"the rotation of '{moon.Name}' has {m.Count} numbers; 9 are needed."));
        }

        RotationMatrix rows = new(new Vector3D(m[0], m[1], m[2]), new Vector3D(m[3], m[4], m[5]), new Vector3D(m[6], m[7], m[8]));
        double error = Math.Max(
            Math.Max((Vector3D.Cross(rows.Row0, rows.Row1) - rows.Row2).Length, (Vector3D.Cross(rows.Row1, rows.Row2) - rows.Row0).Length),
            (Vector3D.Cross(rows.Row2, rows.Row0) - rows.Row1).Length);
        return error <= RotationError && Math.Abs(rows.Row0.Length - 1.0) <= RotationError
            ? UnitQuaternion.FromMatrix(rows)
            : throw new BadInputException($"the rotation of '{moon.Name}' is none: its rows are {rows}.");
    }

    /// <summary>The rotation in place of the message's, where both are nearly the same.</summary>
    /// <param name="spice">By the kernels, at the time of the message.</param>
    /// <exception cref="BadInputException">They differ by more than 0.01 degrees.</exception>
    public static UnitQuaternion Checked(UnitQuaternion message, UnitQuaternion spice, Instant time)
    {
        UnitQuaternion turn = spice * message.Conjugate;
        double angle = 2.0 * Math.Atan2(new Vector3D(turn.X, turn.Y, turn.Z).Length, Math.Abs(turn.W));
        return angle <= LargestTurn
            ? spice
            : throw new BadInputException(Invariant(
                $"at {time.ToIsoUtc()} the Moon of the message is turned by {double.RadiansToDegrees(angle):F3} degrees against MOON_ME. "
                    + $"Link the epoch of the simulation (viz.epochInMsg), or leave out --moon-attitude spice."));
    }

    /// <param name="moonFromInertial">The Moon's attitude.</param>
    /// <param name="time">UTC.</param>
    /// <exception cref="BadInputException">A number is not finite, or the Sun too near.</exception>
    public static SpacecraftState StateOf(
        VizCamera camera, VizSpacecraft craft, VizBody moon, VizBody sun, UnitQuaternion moonFromInertial, Instant time)
    {
        UnitQuaternion inertialFromCraft = FromRodrigues(craft.Attitude, $"the attitude of '{craft.Name}'");
        UnitQuaternion craftFromCamera = FromRodrigues(camera.Direction, "cameraDir_B");
        Vector3D position = moonFromInertial * (craft.Position - moon.Position + (inertialFromCraft * camera.Position));
        UnitQuaternion attitude = moonFromInertial * inertialFromCraft * craftFromCamera;
        return double.IsFinite(position.Length)
            ? new SpacecraftState(time, position, attitude)
            {
                SunPositionBodyFixed = SpacecraftState.CheckedSun(moonFromInertial * (sun.Position - moon.Position)),
            }
            : throw new BadInputException($"the position of '{craft.Name}' is {position}; three finite numbers are needed.");
    }

    /// <summary>The rotation back from axes whose modified Rodrigues parameters are given (Schaub and Junkins).</summary>
    private static UnitQuaternion FromRodrigues(Vector3D s, string name)
    {
        double square = Vector3D.Dot(s, s);
        return double.IsFinite(square)
            ? UnitQuaternion.FromComponents(
                2.0 * s.X / (1.0 + square), 2.0 * s.Y / (1.0 + square), 2.0 * s.Z / (1.0 + square), (1.0 - square) / (1.0 + square))
            : throw new BadInputException($"{name} is {s}; three finite numbers are needed.");
    }
}
