using System.Globalization;

namespace Msisf.App.Settings.Specs;

/// <summary>The range of numbers that an option accepts; the default value of this type accepts only 0.</summary>
/// <param name="Min">Minimum; it lies outside the range if <see cref="ExcludesMin"/>.</param>
/// <param name="Max">Maximum; it lies outside the range if <see cref="ExcludesMax"/>.</param>
internal readonly record struct NumberRange(double Min, double Max)
{
    /// <summary>Whether <see cref="Min"/> itself lies outside the range.</summary>
    public bool ExcludesMin { get; init; }

    /// <summary>Whether <see cref="Max"/> itself lies outside the range.</summary>
    public bool ExcludesMax { get; init; }

    /// <summary>Whether a finite number lies in the range.</summary>
    public bool Contains(double number) =>
        (ExcludesMin ? number > Min : number >= Min) && (ExcludesMax ? number < Max : number <= Max);

    /// <summary>The range as text, e.g. "0 to 100" or "above 0, below 180".</summary>
    public override string ToString()
    {
        string min = Min.ToString("R", CultureInfo.InvariantCulture);
        string max = Max.ToString("R", CultureInfo.InvariantCulture);
        return $"{(ExcludesMin ? $"above {min}, " : $"{min} ")}{(ExcludesMax ? "below" : ExcludesMin ? "up to" : "to")} {max}";
    }
}
