namespace Msisf.Core.Time;

/// <summary>
/// A moment as kernels count it: TDB seconds past J2000 (2000-01-01T12:00:00 TDB), as the sum of two doubles, so that the time since a
/// record's own epoch keeps all digits. <c>default</c> is J2000.
/// </summary>
/// <param name="Seconds">
/// The nearest double, which is CSPICE's ephemeris time; from 1900 to 2100 one step of it is at most 4.8e-7 s.
/// </param>
/// <param name="Rest">s: what the rounding lost.</param>
public readonly record struct TdbTime(double Seconds, double Rest)
{
    /// <summary>A time that a double holds exactly.</summary>
    public static implicit operator TdbTime(double seconds) => new(seconds, 0.0);

    /// <summary>s from another time.</summary>
    public static double operator -(TdbTime a, TdbTime b) => (a.Seconds - b.Seconds) + (a.Rest - b.Rest);

    /// <summary>A time some seconds of TDB later.</summary>
    public static TdbTime operator +(TdbTime a, double seconds)
    {
        double sum = a.Seconds + seconds;
        double added = sum - a.Seconds;
        double rest = (a.Seconds - (sum - added)) + (seconds - added) + a.Rest;
        double rounded = sum + rest;
        return new TdbTime(rounded, rest - (rounded - sum));
    }

    /// <summary>Compares.</summary>
    public static bool operator <(TdbTime a, TdbTime b) => a - b < 0.0;

    /// <summary>Compares.</summary>
    public static bool operator >(TdbTime a, TdbTime b) => a - b > 0.0;

    /// <summary>Compares.</summary>
    public static bool operator <=(TdbTime a, TdbTime b) => !(a > b);

    /// <summary>Compares.</summary>
    public static bool operator >=(TdbTime a, TdbTime b) => !(a < b);
}
