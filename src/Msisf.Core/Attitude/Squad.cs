namespace Msisf.Core.Attitude;

/// <summary>
/// Attitudes between samples whose rate does not jump at them: Shoemake's spherical and quadrangle interpolation (1987), for samples at
/// equal intervals. A turn at a constant rate stays one.
/// </summary>
public static class Squad
{
    /// <summary>The attitude between two samples.</summary>
    /// <param name="before">The sample before the first; null at the start, as if the turn between the two had gone on.</param>
    /// <param name="after">The sample behind the second; null at the end.</param>
    /// <param name="part">0 at the first, 1 at the second.</param>
    public static UnitQuaternion At(
        UnitQuaternion? before, UnitQuaternion first, UnitQuaternion second, UnitQuaternion? after, double part)
    {
        UnitQuaternion controlOfFirst = Control(before ?? (first * second.Conjugate * first), first, second);
        UnitQuaternion controlOfSecond = Control(first, second, after ?? (second * first.Conjugate * second));
        return Between(
            Between(first, second, part), Between(controlOfFirst, controlOfSecond, part), 2.0 * part * (1.0 - part));
    }

    /// <summary>Turns at a constant rate from one attitude to another, the shorter way.</summary>
    public static UnitQuaternion Between(UnitQuaternion first, UnitQuaternion second, double part)
    {
        Vector3D turn = Rotation(first, second);
        return turn == default ? first : first * UnitQuaternion.FromAxisAngle(turn, part * turn.Length);
    }

    private static UnitQuaternion Control(UnitQuaternion before, UnitQuaternion sample, UnitQuaternion after)
    {
        Vector3D turn = -0.25 * (Rotation(sample, before) + Rotation(sample, after));
        return turn == default ? sample : sample * UnitQuaternion.FromAxisAngle(turn, turn.Length);
    }

    /// <summary>rad: the turn from one attitude to another, along its axis in the first one's body.</summary>
    private static Vector3D Rotation(UnitQuaternion from, UnitQuaternion to)
    {
        UnitQuaternion turn = from.Conjugate * to;
        Vector3D sine = new(turn.X, turn.Y, turn.Z); // of half the angle
        double length = sine.Length;
        return length == 0.0 ? default : 2.0 * Trigonometry.Atan2(length, Math.Abs(turn.W)) * (turn.W < 0.0 ? -1.0 : 1.0) / length * sine;
    }
}
