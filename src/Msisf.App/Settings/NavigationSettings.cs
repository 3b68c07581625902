using Msisf.Adapters.Camera;
using Msisf.Adapters.Catalogues;
using Msisf.App.Settings.Specs;
using Msisf.Core.Certainty;
using Msisf.Core.Navigation;
using Msisf.Core.Render.Options;
using Msisf.Core.Sensitivity;

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

    /// <summary>The numbers by which pixels are differentiated; null for none.</summary>
    public IReadOnlyList<Parameter>? Sensitivity { get; init; }

    /// <summary>The numbers of which the image's information is found; null for none.</summary>
    public IReadOnlyList<Parameter>? Information { get; init; }

    /// <summary>How accurately ground, camera and Sun are known, as the user says it; null if nothing is bounded.</summary>
    public string? Certify { get; init; }

    /// <summary>How many standard deviations of these are allowed; null if nothing is bounded.</summary>
    public double? Sigmas { get; init; }

    /// <summary>The limits within which pixels are bounded; null for none.</summary>
    public Uncertainty? Limits { get; init; }

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

        IReadOnlyList<Parameter>? sensitivity = NavigationOptions.Sensitivity.ReadIfGiven(values) is { } derivatives
            ? NavigationOptions.Sensitivity.NamedInErrors(() => Parameter.ParseList(derivatives, NavigationOptions.Sensitivity.Name))
            : null;
        IReadOnlyList<Parameter>? information = NavigationOptions.Information.ReadIfGiven(values) is { } known
            ? NavigationOptions.Information.NamedInErrors(
                () => ChoiceSpec.IsSame(NavigationOptions.Pose, known)
                    ? Parameter.Pose
                    : Parameter.ParseList(known, NavigationOptions.Information.Name))
            : null;
        string? certify = NavigationOptions.Certify.ReadIfGiven(values);
        values.Refuse(
            certify is null ? [NavigationOptions.Sigmas] : [],
            $"is given, but no {NavigationOptions.Certify.Name}. Give that, or leave it out.");
        Uncertainty? limits = certify is null
            ? null
            : NavigationOptions.Certify.NamedInErrors(() => LimitsText.Parse(certify, NavigationOptions.Sigmas.Read(values)));
        return craters is null && landmarks is null && flow is null && stereo is null && sensitivity is null && information is null
            && limits is null
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
                Sensitivity = sensitivity,
                Information = information,
                Certify = certify?.ToLowerInvariant().Replace(" ", string.Empty, StringComparison.Ordinal),
                Sigmas = certify is null ? null : NavigationOptions.Sigmas.Read(values),
                Limits = limits,
                Rim = NavigationOptions.Rim.Read(values),
                LeastDiameter = NavigationOptions.CraterSize.Read(values),
            };
    }

    /// <summary>Refuses derivatives where a part of the image has none here.</summary>
    /// <param name="detector">The camera's detector; null without one.</param>
    /// <param name="indirect">Light from the ground; null without it.</param>
    /// <param name="scans">Whether the camera's rows have times of their own.</param>
    /// <exception cref="UsageException">An option has no meaning here.</exception>
    public void RefuseWithoutDerivatives(OptionValues values, CameraFileDetector? detector, IndirectLight? indirect, bool scans)
    {
        OptionSpec? option = Information is not null ? NavigationOptions.Information
            : Sensitivity is not null ? NavigationOptions.Sensitivity
            : Limits is not null ? NavigationOptions.Certify
            : null;
        if (option is null)
        {
            return;
        }

        if (Information is not null && detector is null)
        {
            throw option.Wrong(
                "needs the noise of a camera with a detector. Name a --camera file that has the section 'detector'.", ImageOptions.Camera);
        }

        if (scans)
        {
            throw option.Wrong(
                "is not for cameras that scan: each of their rows has a pose of its own. Leave it out.", ImageOptions.Camera);
        }

        if (detector?.Settings.Shutter is not null)
        {
            throw option.Wrong(
                "is not for cameras that move while the shutter is open. Leave it out, or remove 'shutter' from the camera file.",
                ImageOptions.Camera);
        }

        if (indirect is not null)
        {
            throw option.Wrong(
                $"does not know how light from the ground changes. Leave {IndirectOptions.Bounces.Name} out.", IndirectOptions.Bounces);
        }

        if (LightOptions.IgnoreSun.Read(values))
        {
            throw option.Wrong(
                "needs the Sun: a lamp at the camera moves with it. Leave --ignore-sun out.", LightOptions.IgnoreSun);
        }

        if (SkyOptions.Group.Options.FirstOrDefault(values.IsGiven) is { } sky)
        {
            throw option.Wrong($"does not know how the sky and its light change. Leave {sky.Name} out.", sky);
        }
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
                    $"{NavigationOptions.FlowFormat.Name} {text}: '{name}' is not a format. Give some of "
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
