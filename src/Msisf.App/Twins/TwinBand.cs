using Msisf.Adapters.RealImages;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;

namespace Msisf.App.Twins;

/// <summary>The band of a product that is compared.</summary>
/// <param name="Index">From 0.</param>
/// <param name="Nanometres">Its middle; null if the label does not say it.</param>
internal sealed record TwinBand(int Index, double? Nanometres)
{
    /// <summary>Finds the band.</summary>
    /// <exception cref="MsisfException">The product does not have the band.</exception>
    public static TwinBand Of(ImageLabel label, OptionValues values)
    {
        int count = label.Pixels.Size.Bands;
        LabelValue? center = label.Find("CENTER") ?? label.Find("CENTERFILTERWAVELENGTH") ?? label.Find("CENTERWAVELENGTH");
        double?[] wavelengths = [.. (center?.Items ?? []).Select(item => Parse(item, center!.Unit))];
        bool isKnown = wavelengths.Length == count && wavelengths.All(wavelength => wavelength is not null);
        int index = TwinOptions.Band.ReadIfGiven(values) is { } given ? given - 1
            : isKnown ? Array.IndexOf(wavelengths, wavelengths.MinBy(found => Math.Abs(found!.Value - AlbedoOptions.Band.Read(values))))
            : 0;
        return index < count
            ? new TwinBand(index, isKnown ? wavelengths[index] : null)
            : throw new UsageException(Invariant($"{TwinOptions.Band.Name} {index + 1}: {label.Path} has {count} bands."))
                .About(TwinOptions.Band);
    }

    /// <summary>ISIS's labels have 643, 0.415 in micrometres, and 640nm.</summary>
    private static double? Parse(string text, string? unit)
    {
        string digits = text.EndsWith("nm", StringComparison.OrdinalIgnoreCase) ? text[..^2] : text;
        return !double.TryParse(digits, NumberStyles.Float, CultureInfo.InvariantCulture, out double number) || number <= 0.0 ? null
            : unit?.StartsWith("micro", StringComparison.OrdinalIgnoreCase) == true || number < 10.0 ? 1000.0 * number
            : number;
    }
}
