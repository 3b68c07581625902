using Msisf.Adapters.Catalogues;
using Msisf.App.Settings.Specs;
using Msisf.Core.Navigation;

namespace Msisf.App.Settings;

/// <summary>The checked options of truth for navigation.</summary>
internal sealed record NavigationSettings
{
    /// <summary>Path of the catalogue of craters; null for none.</summary>
    public string? Craters { get; init; }

    public CraterRim Rim { get; init; }

    /// <summary>px: least diameter of craters in the image.</summary>
    public double LeastDiameter { get; init; }

    /// <summary>Path of the list of landmarks; null for none.</summary>
    public string? Landmarks { get; init; }

    /// <summary>Which columns of the lists the user names; null for none.</summary>
    public ListColumns? Columns { get; init; }

    /// <summary>The other frame of the flow, as the user says it; null for none.</summary>
    public string? Flow { get; init; }

    /// <summary>m: baseline of a second camera; null for none.</summary>
    public double? Stereo { get; init; }

    public FlowFormats FlowFormats { get; init; }

    /// <summary>Their names in the order of the option; null without flow.</summary>
    public IEnumerable<string>? FlowFormatNames => Flow is null && Stereo is null
        ? null
        : NavigationOptions.FlowFormat.Words.Where((_, index) => FlowFormats.HasFlag((FlowFormats)(1 << index)));

    /// <returns>Null if no such truth is wanted.</returns>
    /// <exception cref="UsageException">A value is wrong, or an option has no meaning here.</exception>
    public static NavigationSettings? Read(OptionValues values)
    {
        string? craters = NavigationOptions.Craters.ReadIfGiven(values);
        values.Refuse(
            craters is null ? NavigationOptions.OfCraters : [],
            $"is given, but no {NavigationOptions.Craters.Name}. Name a catalogue, or leave it out.");
        string? landmarks = NavigationOptions.Landmarks.ReadIfGiven(values);
        values.Refuse(
            craters is null && landmarks is null ? [NavigationOptions.Columns] : [],
            $"is given, but no {NavigationOptions.Craters.Name} or {NavigationOptions.Landmarks.Name}. Name a list, or leave it out.");
        string? flow = NavigationOptions.Flow.ReadIfGiven(values);
        double? stereo = NavigationOptions.Stereo.ReadIfGiven(values);
        FlowFormats formats = NavigationOptions.FlowFormat.NamedInErrors(() => Formats(NavigationOptions.FlowFormat.Read(values)));
        if (values.IsGiven(NavigationOptions.FlowFormat) && flow is null && (stereo is null || formats == FlowFormats.Middlebury))
        {
            throw NavigationOptions.FlowFormat.Wrong(
                $"is given, but no {NavigationOptions.Flow.Name} that it is for. Add that, or leave it out.");
        }

        return craters is null && landmarks is null && flow is null && stereo is null
            ? null
            : new NavigationSettings
            {
                Craters = craters,
                Landmarks = landmarks,
                Columns = NavigationOptions.Columns.ReadIfGiven(values) is { } columns
                    ? NavigationOptions.Columns.Named(() => ListColumns.Parse(columns))
                    : null,
                Flow = flow,
                Stereo = stereo,
                FlowFormats = formats,
                Rim = NavigationOptions.Rim.Read(values),
                LeastDiameter = NavigationOptions.CraterSize.Read(values),
            };
    }

    private static FlowFormats Formats(string text)
    {
        FlowFormats formats = FlowFormats.None;
        foreach (string name in text.Split(',', StringSplitOptions.TrimEntries))
        {
            int index = NavigationOptions.FlowFormat.Words.ToList().FindIndex(word => ChoiceSpec.IsSame(word, name));
            formats |= index >= 0
                ? (FlowFormats)(1 << index)
                : throw new UsageException(
                    $"{NavigationOptions.FlowFormat.Name} {text}: '{name}' is no format. Give some of "
                        + $"{string.Join(", ", NavigationOptions.FlowFormat.Words)}.");
        }

        return formats;
    }
}

/// <summary>File formats of flows.</summary>
[Flags]
internal enum FlowFormats
{
    None = 0,
    Fits = 1,
    Npy = 2,
    Middlebury = 4,
    Kitti = 8,
}
