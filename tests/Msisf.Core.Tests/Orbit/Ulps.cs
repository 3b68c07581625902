namespace Msisf.Core.Tests.Orbit;

/// <summary>Distances in units in the last place of the expected value.</summary>
internal static class Ulps
{
    public static double Of(double value) => Math.BitIncrement(Math.Abs(value)) - Math.Abs(value);

    public static double Between(double expected, double actual) => Math.Abs(actual - expected) / Of(expected);
}
