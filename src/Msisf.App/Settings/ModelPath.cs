using System.Globalization;
using Msisf.Adapters.Raster.Heights;
using Msisf.App.Settings.Specs;
using Msisf.Core.Errors;

namespace Msisf.App.Settings;

/// <summary>One elevation model as <c>--ldem</c> names it: a path, and what its values mean, as in "site.tif,scale=0.3048".</summary>
/// <param name="Path">The file or folder.</param>
/// <param name="Heights">What the user says of its values.</param>
internal sealed record ModelPath(string Path, HeightOptions Heights)
{
    private const string Scale = "scale";
    private const string Offset = "offset";

    /// <summary>Parts that a text may have behind its path.</summary>
    private const string ValidValues = "PATH[,scale=METRES][,offset=METRES] is needed";

    /// <summary>Whether a text has options behind its path.</summary>
    public static bool HasOptions(string text) => !Parse(text).Heights.IsEmpty;

    /// <summary>Reads a text; a file whose name has commas in it is found as well.</summary>
    /// <exception cref="UsageException">An option is unknown, given twice, or no number.</exception>
    public static ModelPath Parse(string text)
    {
        string[] parts = text.Split(',');
        int first = Array.FindIndex(parts, 1, IsOption);
        if (first < 0 || System.IO.Path.Exists(text))
        {
            return new ModelPath(text, default);
        }

        HeightOptions heights = default;
        foreach (string[] option in parts[first..].Select(part => part.Split('=', 2)))
        {
            double? value = option.Length == 2
                && double.TryParse(option[1], NumberStyles.Float, CultureInfo.InvariantCulture, out double number)
                && double.IsFinite(number) ? number : null;
            heights = (option[0], value) switch
            {
                (Scale, > 0.0) when heights.Scale is null => heights with { Scale = value },
                (Offset, not null) when heights.Offset is null => heights with { Offset = value },
                (Scale, _) => throw Wrong(text, "scale, metres a step of the values, is a number above 0, given once"),
                (Offset, _) => throw Wrong(text, "offset, metres that are added, is a number, given once"),
                _ => throw Wrong(text, $"'{option[0]}' is no option of a model"),
            };
        }

        return new ModelPath(string.Join(',', parts[..first]), heights);
    }

    /// <summary>A part of a text that is meant as an option, so that a mistyped one is told as such.</summary>
    private static bool IsOption(string part) =>
        part.IndexOf('=', StringComparison.Ordinal) is > 0 and var end && part.AsSpan(0, end).IndexOfAnyExceptInRange('a', 'z') < 0;

    private static UsageException Wrong(string text, string what) =>
        new UsageException($"{SurfaceOptions.Ldem.Name} {text}: {what}. {ValidValues}.").About(SurfaceOptions.Ldem);
}
