using System.Globalization;

namespace Msisf.Benchmarks.Reports;

/// <summary>How a figure is shown: its scale, its name, its digits.</summary>
/// <param name="Name">Behind the number.</param>
/// <param name="PerSi">The number is the SI value times this.</param>
internal sealed record Unit(string Name, double PerSi)
{
    private const int Digits = 3;

    public static Unit Seconds { get; } = new("s", 1.0);

    public static Unit Milliseconds { get; } = new("ms", 1e3);

    public static Unit Megabytes { get; } = new("MB", 1e-6);

    public static Unit Times { get; } = new("times", 1.0);

    public static Unit Thousands { get; } = new("thousand", 1e-3);

    public static Unit Percent { get; } = new("%", 100.0);

    public static Unit Levels { get; } = new("levels", 1.0);

    public static Unit Pixels { get; } = new("px", 1.0);

    public static Unit FramesPerSecond { get; } = new("frames/s", 1.0);

    /// <summary>Three digits, never in powers of ten; a dash for NaN, which is what was not measured.</summary>
    public string Number(double value)
    {
        if (double.IsNaN(value))
        {
            return "-";
        }

        double shown = value * PerSi;
        int decimals = shown == 0.0 ? 0 : Math.Clamp(Digits - 1 - (int)Math.Floor(Math.Log10(Math.Abs(shown))), 0, Digits);
        return shown.ToString(string.Create(CultureInfo.InvariantCulture, $"F{decimals}"), CultureInfo.InvariantCulture);
    }

    public string Text(double value) => $"{Number(value)} {Name}";
}
