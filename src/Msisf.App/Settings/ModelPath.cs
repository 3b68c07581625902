using Msisf.Adapters.Raster.Heights;
using Msisf.App.Settings.Specs;

namespace Msisf.App.Settings;

/// <summary>
/// One elevation model as <c>--ldem</c> names it: a path, what its values mean, and where it is moved, as in "site.tif,offset=-37.5".
/// </summary>
/// <param name="Path">The file or folder.</param>
/// <param name="Heights">What the user says of its values.</param>
/// <param name="Placement">How the user moves it.</param>
internal sealed record ModelPath(string Path, HeightOptions Heights, ModelPlacement Placement = default)
{
    private const string Scale = "scale";
    private const string Offset = "offset";
    private const string Shift = "shift";
    private const string Values = "values";
    private const string Means = "means";
    private const string Samples = "samples";

    /// <summary>Value of <see cref="Offset"/> for a model that is raised to meet those around it.</summary>
    private const string Automatic = "auto";

    /// <summary>Parts that a text may have behind its path.</summary>
    private const string ValidValues = "PATH[,scale=METRES][,offset=METRES|auto][,shift=EAST,NORTH][,values=means|samples] is needed";

    /// <summary>Whether a text has options behind its path.</summary>
    public static bool HasOptions(string text) => Parse(text) is { Heights.IsEmpty: false } or { Placement: not (false, 0.0, 0.0) };

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
        ModelPlacement placement = default;
        HashSet<string> given = [];
        for (int i = first; i < parts.Length; i++)
        {
            string[] option = parts[i].Split('=', 2);
            string? value = option.Length == 2 ? option[1] : null;
            bool isFirst = given.Add(option[0]);
            switch (option[0])
            {
                case Scale:
                    heights = heights with
                    {
                        Scale = isFirst && Number(value) is > 0.0 and var scale
                            ? scale
                            : throw Wrong(text, "scale, metres a step of the values, is a number above 0, given once"),
                    };
                    break;
                case Offset when isFirst && value == Automatic:
                    placement = placement with { MeetsBorder = true };
                    break;
                case Offset:
                    heights = heights with
                    {
                        Offset = (isFirst ? Number(value) : null)
                            ?? throw Wrong(text, "offset, metres that are added, is a number or auto, given once"),
                    };
                    break;
                case Shift:
                    i++;
                    placement = isFirst && Number(value) is { } east && Number(parts.ElementAtOrDefault(i)) is { } north
                        ? placement with { East = east, North = north }
                        : throw Wrong(text, "shift is two numbers, metres towards east and north, given once");
                    break;
                case Values:
                    heights = heights with
                    {
                        HoldsMeans = isFirst && (value is Means or Samples)
                            ? value == Means
                            : throw Wrong(text, $"values, what --refine keeps, is {Means} or {Samples}, given once"),
                    };
                    break;
                default:
                    throw Wrong(text, $"'{option[0]}' is not an option of a model");
            }
        }

        return new ModelPath(string.Join(',', parts[..first]), heights, placement);
    }

    private static double? Number(string? text) =>
        double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double number) && double.IsFinite(number)
            ? number
            : null;

    /// <summary>A part of a text that is meant as an option, so that a mistyped one is reported as an option.</summary>
    private static bool IsOption(string part) =>
        part.IndexOf('=', StringComparison.Ordinal) is > 0 and var end && part.AsSpan(0, end).IndexOfAnyExceptInRange('a', 'z') < 0;

    private static UsageException Wrong(string text, string what) =>
        SurfaceOptions.Ldem.Wrong($"{text}: {what}. {ValidValues}.");
}

/// <summary>How the user moves an elevation model; <c>default</c> is not at all.</summary>
/// <param name="MeetsBorder">Whether it is raised by what makes its border meet the models around it in the mean.</param>
/// <param name="East">m towards the east.</param>
/// <param name="North">m towards the north.</param>
internal readonly record struct ModelPlacement(bool MeetsBorder, double East, double North)
{
    /// <summary>Whether it is moved over the ground.</summary>
    public bool IsShifted => (East, North) != (0.0, 0.0);
}
