namespace Msisf.Core.Attitude;

/// <summary>
/// The axes of three turns that lead from a reference frame to a body's axes, each about an axis that the turns before it have turned
/// along (intrinsic). <c>default</c> is not a sequence.
/// </summary>
public readonly record struct EulerSequence
{
    /// <summary>What a sequence may look like, for messages.</summary>
    public const string ValidValues = "three axes such as ZYX, 321, ZXZ or 313, neighbours not the same";

    private const string Letters = "XYZ";
    private const string Digits = "123";

    private EulerSequence(string axes) => Axes = axes;

    /// <summary>The axes as capital letters in the order of the turns, e.g. "ZYX".</summary>
    public string Axes { get; }

    /// <summary>Reads a sequence.</summary>
    /// <param name="text">Letters in capitals, or digits.</param>
    /// <exception cref="BadInputException">It is not a sequence.</exception>
    public static EulerSequence Parse(string text)
    {
        if (text.Length == 3 && text.All("xyz".Contains))
        {
            throw new BadInputException(
                $"'{text}' in small letters means turns about axes at rest in some libraries. Write '{text.ToUpperInvariant()}' for turns "
                    + $"about the turned axes, or '{new string([.. text.Reverse()]).ToUpperInvariant()}' with the angles in reverse.");
        }

        string axes = string.Concat(text.Select(axis => Digits.Contains(axis) ? Letters[Digits.IndexOf(axis)] : axis));
        return axes.Length == 3 && axes.All(Letters.Contains) && axes[0] != axes[1] && axes[1] != axes[2]
            ? new EulerSequence(axes)
            : throw new BadInputException($"'{text}' is not a sequence of Euler angles; {ValidValues} is needed.");
    }

    /// <summary>The rotation by three angles.</summary>
    /// <param name="angles">rad, in the order of the turns, right-handed.</param>
    /// <returns>Turns the body's components into those of the reference frame.</returns>
    public UnitQuaternion FrameFromBody(ReadOnlySpan<double> angles) =>
        About(0, angles[0]) * About(1, angles[1]) * About(2, angles[2]);

    /// <summary>How fast a body turns whose angles change.</summary>
    /// <param name="angles">rad, in the order of the turns.</param>
    /// <param name="rates">rad/s.</param>
    /// <returns>rad/s of the body in the reference frame, about the body's axes.</returns>
    public Vector3D RateBody(ReadOnlySpan<double> angles, ReadOnlySpan<double> rates)
    {
        UnitQuaternion last = About(2, angles[2]);
        UnitQuaternion lastTwo = About(1, angles[1]) * last;
        return (rates[2] * AxisOf(2)) + (rates[1] * (last.Conjugate * AxisOf(1))) + (rates[0] * (lastTwo.Conjugate * AxisOf(0)));
    }

    private UnitQuaternion About(int turn, double angle) => UnitQuaternion.FromAxisAngle(AxisOf(turn), angle);

    private Vector3D AxisOf(int turn) => Axes[turn] switch
    {
        'X' => Vector3D.UnitX,
        'Y' => Vector3D.UnitY,
        _ => Vector3D.UnitZ,
    };
}
