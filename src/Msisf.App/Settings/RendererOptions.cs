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

    /// <summary>This option as a group of the help text.</summary>
    public static OptionGroup Group { get; } = new("Renderer", [Renderer]);

    /// <summary>The options that a renderer does not support and would ignore.</summary>
    public static IReadOnlyList<OptionSpec> WithoutMeaning(RendererKind renderer) =>
        renderer == RendererKind.PovRay
            ? [.. NativeOptions.Group.Options, .. NavigationOptions.Group.Options]
            : PovOptions.Group.Options;

    /// <summary>Rejects options that the selected renderer would ignore.</summary>
    /// <exception cref="UsageException">An option belongs to the other renderer, or the option that it depends on is missing.</exception>
    public static void Check(OptionValues values)
    {
        RendererKind renderer = Renderer.Read(values);
        if (WithoutMeaning(renderer).FirstOrDefault(values.IsGiven) is { } wrong)
        {
            throw new UsageException(renderer == RendererKind.PovRay
                ? $"{wrong.Name} is for --renderer native only. Add that, or leave it out."
                : $"{wrong.Name} has no meaning with --renderer native, which needs neither POV-Ray nor patterns. "
                    + $"Leave it out, or choose --renderer povray.")
                .About(wrong, Renderer);
        }

        if (NativeOptions.OfLayers.FirstOrDefault(values.IsGiven) is { } ofLayers && values.Text(NativeOptions.Layers) is null)
        {
            throw new UsageException(
                $"{ofLayers.Name} is given, but no --layers. Name the layers, or leave it out.").About(ofLayers);
        }

        if (NativeOptions.LayersCompression.Read(values) != LayerCompression.None
            && NativeOptions.LayersFormat.Read(values) != LayersFormat.Fits)
        {
            throw new UsageException(
                "--layers-compression gzip is for --layers-format fits. Choose one of them, or compress the .npy files afterwards.")
                .About(NativeOptions.LayersCompression, NativeOptions.LayersFormat);
        }
    }
}
