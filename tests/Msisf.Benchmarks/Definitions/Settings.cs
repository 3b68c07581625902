using System.Globalization;
using Msisf.Core.Render.Options;

namespace Msisf.Benchmarks.Definitions;

/// <summary>The ways to make an image that are measured against each other.</summary>
internal static class Settings
{
    private const string Auto = "auto";
    private const string Off = "off";
    private const string AntialiasingOption = "--pov-options";

    private static readonly string[] WithoutAntialiasing = [AntialiasingOption, "Antialias=Off"];

    /// <summary>Up to 4 x 4 samples a pixel wherever neighbours differ by 3 % of white, instead of 3 x 3 from 30 % on.</summary>
    private static readonly string[] DeepAntialiasing = [AntialiasingOption, "Antialias_Depth=4 Antialias_Threshold=0.03"];

    /// <summary>The base line of every ratio.</summary>
    public static Setting Thesis { get; } = new("thesis", SettingKind.Thesis, [], IsRepeated: true);

    /// <summary>The model's own facets.</summary>
    public static Setting PovRayFull { get; } = PovRay("povray, full", Off, [], isRepeated: true);

    /// <summary>The program's defaults.</summary>
    public static Setting PovRayDefault { get; } = new("povray", SettingKind.PovRay, [], IsRepeated: true);

    /// <summary>The native renderer's defaults.</summary>
    public static Setting NativeDefault { get; } = Native(1, Auto);

    /// <summary>What every scene is made in, by the program itself.</summary>
    public static IReadOnlyList<Setting> Own { get; } =
    [
        PovRayFull,
        PovRayDefault,
        NativeDefault,
        Native(1, Off),
        Native(2, Auto),
        Native(4, Auto),
        NativeAdaptive(1.0),
        NativeAdaptive(AdaptiveSampling.DefaultError),
    ];

    /// <summary>Those and the base line.</summary>
    public static IReadOnlyList<Setting> Few { get; } = [Thesis, .. Own];

    /// <summary>Those and other errors that the levels of detail are allowed, from which the default is chosen.</summary>
    public static IReadOnlyList<Setting> Default { get; } =
    [
        .. Few,
        PovRay("povray, 0.5 px", Auto, ["--lod-error", "0.5"]),
        PovRay("povray, 1 px", Auto, ["--lod-error", "1"]),
        PovRay("povray, 2 px", Auto, ["--lod-error", "2"]),
        PovRay("povray, 4 px", Auto, ["--lod-error", "4"]),
        Native(2, Off),
        Native(4, Off),
    ];

    /// <summary>Those and other antialiasing with levels of detail.</summary>
    public static IReadOnlyList<Setting> Antialiased { get; } =
    [
        .. Default,
        PovRay("povray, no antialiasing", Auto, WithoutAntialiasing),
        PovRay("povray, deep antialiasing", Auto, DeepAntialiasing),
    ];

    /// <summary>Those and other antialiasing at full resolution, which takes minutes where many tiles of a fine model are seen.</summary>
    public static IReadOnlyList<Setting> All { get; } =
    [
        .. Antialiased,
        PovRay("povray, full, no antialiasing", Off, WithoutAntialiasing),
        PovRay("povray, full, deep antialiasing", Off, DeepAntialiasing),
    ];

    private static Setting PovRay(string name, string levels, string[] options, bool isRepeated = false) =>
        new(name, SettingKind.PovRay, ["--lod", levels, .. options], isRepeated)
        {
            IsFull = levels == Off,
            HasOwnSurface = !options.Contains(AntialiasingOption),
        };

    /// <summary>Samples only where they matter.</summary>
    private static Setting NativeAdaptive(double error)
    {
        string text = string.Create(CultureInfo.InvariantCulture, $"auto:{error}");
        return new Setting($"native, {text}", SettingKind.Native, ["--samples", text, "--lod", Auto], IsRepeated: true)
        {
            SubsamplesPerAxis = AdaptiveSampling.SubsamplesPerAxis,
        };
    }

    private static Setting Native(int subsamplesPerAxis, string levels)
    {
        string samples = (subsamplesPerAxis * subsamplesPerAxis).ToString(CultureInfo.InvariantCulture);
        string name = $"native, {samples}{(levels == Off ? ", full" : string.Empty)}";
        return new Setting(name, SettingKind.Native, ["--samples", samples, "--lod", levels], IsRepeated: true)
        {
            SubsamplesPerAxis = subsamplesPerAxis,
            IsFull = levels == Off,
        };
    }
}
