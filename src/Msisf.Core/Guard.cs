namespace Msisf.Core;

/// <summary>
/// The checks at the border: what is not finite or out of range gets a <see cref="BadInputException"/> here and never travels on.
/// </summary>
public static class Guard
{
    /// <summary>Lets a finite number pass.</summary>
    /// <param name="value">The number to check.</param>
    /// <param name="what">Name and unit for the message, e.g. "semi-major axis (m)".</param>
    /// <returns><paramref name="value"/>.</returns>
    /// <exception cref="BadInputException">NaN or infinite.</exception>
    public static double Finite(double value, string what) =>
        double.IsFinite(value)
            ? value
            : throw new BadInputException($"{what} is {Text(value)}; a finite number is needed.");

    /// <summary>Lets a finite number above zero pass.</summary>
    /// <param name="value">The number to check.</param>
    /// <param name="what">Name and unit for the message.</param>
    /// <returns><paramref name="value"/>.</returns>
    /// <exception cref="BadInputException">NaN, infinite, zero or negative.</exception>
    public static double Positive(double value, string what) =>
        double.IsFinite(value) && value > 0.0
            ? value
            : throw new BadInputException($"{what} is {Text(value)}; a finite number above 0 is needed.");

    /// <summary>Lets a number in [<paramref name="minimum"/>, <paramref name="maximum"/>] pass.</summary>
    /// <param name="value">The number to check.</param>
    /// <param name="minimum">Minimum allowed value.</param>
    /// <param name="maximum">Maximum allowed value.</param>
    /// <param name="what">Name and unit for the message.</param>
    /// <returns><paramref name="value"/>.</returns>
    /// <exception cref="BadInputException">NaN or out of range.</exception>
    public static double InRange(double value, double minimum, double maximum, string what) =>
        value >= minimum && value <= maximum
            ? value
            : throw new BadInputException($"{what} is {Text(value)}; a number from {Text(minimum)} to {Text(maximum)} is needed.");

    private static string Text(double value) => value.ToString("R", CultureInfo.InvariantCulture);
}
