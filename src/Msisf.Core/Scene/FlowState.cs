using Msisf.Core.Time;

namespace Msisf.Core.Scene;

/// <summary>The state of the other frame of a flow.</summary>
/// <param name="Time">When.</param>
/// <param name="PositionBodyFixed">m, body-fixed.</param>
/// <param name="MoonFromCamera">Turns camera axes into Moon axes.</param>
/// <param name="SunPositionBodyFixed">m, body-fixed; null for that of the ephemeris.</param>
public sealed record FlowState(
    Instant Time, Vector3D PositionBodyFixed, UnitQuaternion MoonFromCamera, Vector3D? SunPositionBodyFixed = null)
{
    /// <summary>The numbers of a Sun, in their order.</summary>
    public static IReadOnlyList<string> NumberNamesOfSun { get; } = ["sx", "sy", "sz"];

    /// <summary>The numbers of a state with its Sun, in their order.</summary>
    public static IReadOnlyList<string> NumberNamesWithSun { get; } = [.. SpacecraftState.NumberNames, .. NumberNamesOfSun];

    /// <summary>That of a frame.</summary>
    public static FlowState Of(SpacecraftState state) =>
        new(state.Time, state.PositionBodyFixed, state.MoonFromCamera, state.SunPositionBodyFixed);

    /// <summary>
    /// Takes the numbers behind the time of <see cref="SpacecraftState.NumberNames"/>, or of <see cref="NumberNamesWithSun"/>.
    /// </summary>
    /// <exception cref="BadInputException">A number is out of its range.</exception>
    public static FlowState FromNumbers(Instant time, ReadOnlySpan<double> numbers)
    {
        int count = SpacecraftState.NumberNames.Count - 1;
        FlowState state = Of(SpacecraftState.FromNumbers(time, numbers[..count]));
        return numbers.Length == count
            ? state
            : state with
            {
                SunPositionBodyFixed = SpacecraftState.CheckedSun(
                    new Vector3D(numbers[count], numbers[count + 1], numbers[count + 2])),
            };
    }

    /// <summary>The numbers; <see cref="FromNumbers"/> makes the same state of the time and those behind it.</summary>
    public double[] ToNumbers() =>
    [
        .. new SpacecraftState(Time, PositionBodyFixed, MoonFromCamera).ToNumbers(),
        .. SunPositionBodyFixed is { } sun ? (double[])[sun.X, sun.Y, sun.Z] : [],
    ];
}
