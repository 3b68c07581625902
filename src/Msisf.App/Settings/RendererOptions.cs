using Msisf.Adapters.Layers;
using Msisf.App.Settings.Specs;
using Msisf.Core.Render;

namespace Msisf.App.Settings;

/// <summary>The option that selects the renderer, and the lists of options that each renderer supports.</summary>
internal static class RendererOptions
{
    public static ChoiceSpec<RendererKind> Renderer { get; } = new(
        "--renderer", DecidesBytes.As(frame => frame.Settings.Renderer),
        [new Choice("povray", RendererKind.PovRay), new Choice("native", RendererKind.Native)],
        "What draws: POV-Ray from surface patterns, or msis itself straight from the elevation model")
    {
        Default = RendererKind.PovRay,
    };

    /// <summary>This option and the looks as a group of the help text.</summary>
    public static OptionGroup Group { get; } = new("Renderer", [LookOptions.Look, Renderer]);

    /// <summary>The options that a renderer does not support and would ignore.</summary>
    public static IReadOnlyList<OptionSpec> WithoutMeaning(RendererKind renderer) =>
        renderer == RendererKind.PovRay
            ? [.. NativeOptions.Group.Options, .. NavigationOptions.Group.Options, .. SkyOptions.Group.Options]
            : PovOptions.Group.Options;

    /// <summary>Rejects options that the selected renderer would ignore.</summary>
    /// <exception cref="UsageException">An option belongs to the other renderer, or the option that it depends on is missing.</exception>
    public static void Check(OptionValues values)
    {
        RendererKind renderer = Renderer.Read(values);
        values.Refuse(
            WithoutMeaning(renderer),
            renderer == RendererKind.PovRay
                ? "is for --renderer native only. Add that, or leave it out."
                : "has no meaning with --renderer native, which needs neither POV-Ray nor patterns. Leave it out, or choose "
                    + "--renderer povray.",
            Renderer);
        values.Refuse(
            values.Text(NativeOptions.Layers) is null && values.Text(NavigationOptions.Sensitivity) is null
                && values.Text(NavigationOptions.Certify) is null
                    ? NativeOptions.OfLayers
                    : [],
            "is given, but no --layers. Name the layers, or leave it out.");
        if (NativeOptions.LayersCompression.Read(values) != LayerCompression.None
            && NativeOptions.LayersFormat.Read(values) != LayerFormat.Fits)
        {
            throw NativeOptions.LayersCompression.Wrong(
                "gzip is for --layers-format fits. Choose one of them, or compress the files afterwards.", NativeOptions.LayersFormat);
        }
    }
}

/// <summary>The options that apply to POV-Ray only.</summary>
internal static class PovOptions
{
    /// <summary>Maximum time limit, s: the longest that a .NET timer accepts.</summary>
    private const int MaxTimeout = int.MaxValue / 1000;

    public static PathSpec PatternRepository { get; } = new(
        "--pattern-repos", OptionRole.HowItRuns, PathKind.Folder, "Folder of the surface patterns")
    {
        Aliases = ["-p"],
        Default = "pattern-repository",
        DefaultNote = "./pattern-repository",
    };

    public static PathSpec Program { get; } = new(
        "--pov-path", DecidesBytes.ByFiles, PathKind.Any, "POV-Ray's program or its folder")
    {
        DefaultNote = "searched along the PATH",
    };

    public static TextSpec MoreOptions { get; } = new(
        "--pov-options", DecidesBytes.As(frame => frame.Native is null ? frame.Settings.PovOptions : null).OfRuns(),
        "TEXT", "More POV-Ray options, separated by spaces, which overrule those of msis, e.g. \"Antialias=Off\"")
    {
        Separator = " ",
    };

    public static NumberSpec Timeout { get; } = new("--timeout", OptionRole.HowItRuns, "SECONDS", "Longest time of one POV-Ray run")
    {
        Limits = new NumberRange(0.0, MaxTimeout) { ExcludesMin = true },
        DefaultNote = "no limit",
    };

    public static FlagSpec ListPatterns { get; } = new(
        "--list-patterns", OptionRole.WhatIsPrinted, "Print the tiles of each image and why each is taken or left out; render nothing")
    {
        IsOfOneCall = true,
    };

    public static OptionGroup Group { get; } = new("POV-Ray", [PatternRepository, Program, MoreOptions, Timeout, ListPatterns])
    {
        Note = "Only with --renderer povray.",
    };
}
