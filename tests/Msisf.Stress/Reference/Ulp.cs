namespace Msisf.Stress.Reference;

/// <summary>Units in the last place: the distance from a double to the next one away from zero.</summary>
internal static class Ulp
{
    public static double Of(double value) => Math.BitIncrement(Math.Abs(value)) - Math.Abs(value);
}
