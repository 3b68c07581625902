using System.CommandLine;
using Msisf.App.Settings;

namespace Msisf.Cli.Options;

/// <summary>
/// All options of a render run, for each command that takes one: where the camera is, the image, its sources, how it goes.
/// </summary>
internal sealed class RenderOptions
{
    public ModeOptions Mode { get; } = new();

    public ImageOptions Image { get; } = new();

    public SourceOptions Source { get; } = new();

    public NativeOptions Native { get; } = new();

    public RunOptions Run { get; } = new();

    public IEnumerable<Option> All => [.. Mode.All, .. Image.All, .. Source.All, .. Native.All, .. Run.All];

    /// <summary>Reads and checks a parsed line.</summary>
    /// <param name="line">The line.</param>
    /// <returns>The way the states are given, null if none is given, and the settings.</returns>
    /// <exception cref="Core.Errors.MsisfException">An option is wrong, missing or forbidden beside another.</exception>
    public (Mode? Mode, RenderSettings Settings) Read(ParseResult line)
    {
        StrayOptions.Refuse(line, Run.PovOptions);
        bool IsGiven(Option option) => line.GetResult(option) is { Implicit: false };
        Mode? mode = ModeRules.Check(Mode, IsGiven);
        RenderSettings settings = new RenderSettingsReader(line).Read(Image, Source, Run, Native);
        RendererRules.Check(settings.Renderer, Native, Source, Run, IsGiven);
        return (mode, settings);
    }
}
