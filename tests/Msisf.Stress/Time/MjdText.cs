namespace Msisf.Stress.Time;

/// <summary>Times for the report, to the last digit.</summary>
internal static class MjdText
{
    public static string Of(double mjd) => FormattableString.Invariant($"MJD {mjd:R}");
}
