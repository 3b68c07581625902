namespace Msisf.Core.Tests.Orbit;

/// <summary>28-digit arithmetic for residuals; independent of the double functions under test.</summary>
internal static class ExactDecimal
{
    private const int LargestShift = 62;

    /// <summary>The double's value to 28 decimals; the cast of the language keeps 15 digits only.</summary>
    public static decimal From(double value)
    {
        int exponent = value == 0.0 ? 0 : Math.ILogB(value) - 52;
        decimal result = (long)Math.ScaleB(value, -exponent);
        for (int left = -exponent; left > 0; left -= LargestShift)
        {
            result /= 1L << Math.Min(left, LargestShift);
        }

        return result;
    }

    public static decimal Sin(double angle) => Series(From(angle), From(angle), firstFactor: 2);

    public static decimal Cos(double angle) => Series(1m, From(angle), firstFactor: 1);

    private static decimal Series(decimal firstTerm, decimal x, int firstFactor)
    {
        decimal sum = 0m;
        decimal term = firstTerm;
        for (int n = firstFactor; term != 0m; n += 2)
        {
            sum += term;
            term = -term * x / n * x / (n + 1);
        }

        return sum;
    }
}
