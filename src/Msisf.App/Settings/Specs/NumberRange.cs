using System.Globalization;

namespace Msisf.App.Settings.Specs;

/// <summary>The numbers that an option takes; the default is 0 alone.</summary>
/// <param name="Min">Smallest, or the limit below all if <see cref="ExcludesMin"/>.</param>
/// <param name="Max">Largest, or the limit above all if <see cref="ExcludesMax"/>.</param>
internal readonly record struct NumberRange(double Min, double Max)
{
    /// <summary>Whether <see cref="Min"/> itself is too small.</summary>
    public bool ExcludesMin { get; init; }

    /// <summary>Whether <see cref="Max"/> itself is too large.</summary>
    public bool ExcludesMax { get; init; }

    /// <summary>Whether a finite number lies in the range.</summary>
    public bool Contains(double number) =>
        (ExcludesMin ? number > Min : number >= Min) && (ExcludesMax ? number < Max : number <= Max);

    /// <summary>E.g. "0 to 100", "above 0, below 180".</summary>
    public override string ToString() => string.Create(
        CultureInfo.InvariantCulture,
        $"{(ExcludesMin ? $"above {Min:R}, " : $"{Min:R} ")}{(ExcludesMax ? "below" : ExcludesMin ? "up to" : "to")} {Max:R}");
}
