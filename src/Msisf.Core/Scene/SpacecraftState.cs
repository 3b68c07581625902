using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Time;

namespace Msisf.Core.Scene;

/// <summary>
/// All that one frame needs to know of the spacecraft: the thesis's fixed state. <c>default</c> has no attitude and is not a state.
/// </summary>
/// <param name="Time">UTC.</param>
/// <param name="PositionMoonMe">m, MOON_ME.</param>
/// <param name="MoonFromCamera">Turns camera axes (looks along -x, y right, z up) into Moon axes.</param>
public readonly record struct SpacecraftState(ModifiedJulianDate Time, Vector3D PositionMoonMe, UnitQuaternion MoonFromCamera)
{
    /// <summary>
    /// The eight numbers of a fixed state in the thesis's order (section 6.3.2): MJD (days, UTC), position (m), quaternion.
    /// </summary>
    public static IReadOnlyList<string> NumberNames { get; } = ["MJD", "rx", "ry", "rz", "qx", "qy", "qz", "q0"];

    /// <summary>
    /// The eight numbers in the order of <see cref="NumberNames"/>; <see cref="FromNumbers"/> makes the same state of them, to the last
    /// bit.
    /// </summary>
    public double[] ToNumbers() =>
    [
        Time.Days, PositionMoonMe.X, PositionMoonMe.Y, PositionMoonMe.Z, MoonFromCamera.X, MoonFromCamera.Y, MoonFromCamera.Z,
        MoonFromCamera.W,
    ];

    /// <summary>Checks and takes the eight numbers.</summary>
    /// <param name="numbers">In the order of <see cref="NumberNames"/>.</param>
    /// <exception cref="BadInputException">The MJD is no date, the position is not finite, or the quaternion is no rotation.</exception>
    /// <exception cref="ArgumentException">Not eight numbers.</exception>
    public static SpacecraftState FromNumbers(ReadOnlySpan<double> numbers) =>
        numbers.Length == NumberNames.Count
            ? new SpacecraftState(
                new ModifiedJulianDate(numbers[0]),
                new Vector3D(Guard.Finite(numbers[1], "rx (m)"), Guard.Finite(numbers[2], "ry (m)"), Guard.Finite(numbers[3], "rz (m)")),
                UnitQuaternion.FromComponents(numbers[4], numbers[5], numbers[6], numbers[7]))
            : throw new ArgumentException($"{numbers.Length} numbers for a state of {NumberNames.Count}.", nameof(numbers));
}
