using System.CommandLine;
using Msisf.Adapters.Ephemeris;
using Msisf.Adapters.Render;
using Msisf.App.Preparation;
using Msisf.App.Settings;
using Msisf.Core.Camera;
using Msisf.Core.Ephemeris;
using Msisf.Core.Errors;
using Msisf.Core.Lod;
using Msisf.Core.Metadata;
using Msisf.Core.Render;
using Msisf.Core.Scene;

namespace Msisf.Cli.Options;

/// <summary>Turns the text of the options into checked values, with the defaults of thesis appendix A.</summary>
internal sealed class RenderSettingsReader
{
    /// <summary>px: the largest side of an image.</summary>
    private const int LargestSide = 16384;

    /// <summary>More frames at once than any computer runs.</summary>
    private const int MaxJobs = 1024;

    /// <summary>px: from here on nothing of the Moon would be left to see.</summary>
    private const double MaxLevelOfDetailError = 100.0;

    private readonly ParseResult _line;

    public RenderSettingsReader(ParseResult line) => _line = line;

    public RenderSettings Read(ImageOptions image, SourceOptions source, RunOptions run, NativeOptions nativeOptions)
    {
        NativeSettingsReader native = new(_line, nativeOptions);
        PixelSurface surface = _line.GetValue(image.Surface) is string words
            ? OptionText.Choice(image.Surface, words, [("sphere", PixelSurface.Sphere), ("terrain", PixelSurface.Terrain)])
            : PixelSurface.Sphere;
        int width = WholeNumber(image.Width, 1024, LargestSide);
        int height = WholeNumber(image.Height, 1024, LargestSide);
        int grid = WholeNumber(image.Grid, PixelGrid.DefaultSpacing, int.MaxValue);
        return new RenderSettings
        {
            FieldOfViewDegrees = FieldOfView(image.FieldOfView),
            Width = width,
            Height = height,
            GridHorizontal = WholeNumber(image.GridHorizontal, grid, int.MaxValue),
            GridVertical = WholeNumber(image.GridVertical, grid, int.MaxValue),
            Surface = surface,
            PixelsPerDegree = source.ReadResolution(_line),
            Renderer = native.Renderer(),
            Native = native.Read(needsTruth: surface == PixelSurface.Terrain),
            LevelOfDetailError = LevelOfDetailError(image, native.Renderer()),
            IgnoreSun = _line.GetValue(image.IgnoreSun),
            Annotate = _line.GetValue(image.Annotation),
            OutputFolder = PathOf(image.OutputFolder) ?? "output",
            OutputName = _line.GetValue(image.OutputName) ?? FrameNaming.DefaultPattern,
            PatternRepository = PathOf(source.PatternRepository) ?? SourceSettings.DefaultRepository,
            Ldem = PathOf(source.Ldem),
            Ephemeris = _line.GetValue(run.Ephemeris) is string engine
                ? OptionText.Choice(
                    run.Ephemeris,
                    engine,
                    [("cspice", EphemerisChoice.CSpice), ("builtin", EphemerisChoice.BuiltIn), ("auto", EphemerisChoice.Auto)])
                : EphemerisChoice.Auto,
            Aberration = Aberration(run.Aberration, image.IgnoreSun),
            Kernels = PathOf(run.Kernels),
            PovPath = PathOf(run.PovPath),
            PovOptions = PovRayOptions.Parse(_line.GetValue(run.PovOptions) ?? string.Empty),
            Timeout = Timeout(run.Timeout),
            Jobs = _line.GetValue(run.Jobs) is null ? null : WholeNumber(run.Jobs, 1, MaxJobs),
            Frames = _line.GetValue(run.Frames) is string steps ? OptionText.Named(run.Frames, () => StepRanges.Parse(steps)) : null,
            Overwrite = _line.GetValue(run.Overwrite),
            FailFast = _line.GetValue(run.FailFast),
            FrameTimes = PathOf(run.FrameTimes),
            Unattended = _line.GetValue(run.Batch),
            ListPatterns = _line.GetValue(run.ListPatterns),
            Timing = _line.GetValue(run.Timing),
        };
    }

    private double FieldOfView(Option<string?> option)
    {
        double degrees = _line.GetValue(option) is string text ? OptionText.Number(option, text) : 40.0;
        return degrees > 0.0 && degrees < 180.0
            ? degrees
            : throw new BadInputException(
                $"--fov is {_line.GetValue(option)}; a field of view between 0 and 180 degrees (without them) is needed.");
    }

    private double? LevelOfDetailError(ImageOptions image, RendererKind renderer)
    {
        bool isOff = _line.GetValue(image.LevelOfDetail) is string word
            && OptionText.Choice(image.LevelOfDetail, word, [("auto", false), ("off", true)]);
        if (_line.GetValue(image.LevelOfDetailError) is not string text)
        {
            return isOff ? null : renderer == RendererKind.Native ? DetailRule.DefaultErrorOfImage : DetailRule.DefaultErrorOfParts;
        }

        if (isOff)
        {
            throw new UsageException(
                "--lod-error has no meaning with --lod off, which always shows the model itself. Leave one of them out.");
        }

        double error = OptionText.Number(image.LevelOfDetailError, text);
        return error is >= 0.0 and <= MaxLevelOfDetailError
            ? error
            : throw new BadInputException($"--lod-error is {text}; 0 to {MaxLevelOfDetailError} pixels are possible.");
    }

    private Aberration Aberration(Option<string?> option, Option<bool> ignoreSun)
    {
        if (_line.GetValue(option) is not string text)
        {
            return Core.Ephemeris.Aberration.None;
        }

        return _line.GetValue(ignoreSun)
            ? throw new UsageException(
                $"{option.Name} has no meaning with {ignoreSun.Name}, which lights the scene from the camera. Leave one out.")
            : OptionText.Choice(
                option,
                text,
                [
                    ("none", Core.Ephemeris.Aberration.None),
                    ("lt", Core.Ephemeris.Aberration.LightTime),
                    ("lt+s", Core.Ephemeris.Aberration.LightTimeAndStellar),
                ]);
    }

    private TimeSpan? Timeout(Option<string?> option)
    {
        if (_line.GetValue(option) is not string text)
        {
            return null;
        }

        double seconds = OptionText.Number(option, text);
        return seconds > 0.0 && seconds <= int.MaxValue / 1000
            ? TimeSpan.FromSeconds(seconds)
            : throw new BadInputException($"--timeout is {text}; seconds above 0 and up to {int.MaxValue / 1000} are needed.");
    }

    private int WholeNumber(Option<string?> option, int otherwise, int maximum) =>
        _line.GetValue(option) is string text ? OptionText.WholeNumber(option, text, 1, maximum) : otherwise;

    private string? PathOf(Option<string?> option) =>
        _line.GetValue(option) is string text ? OptionText.FilePath(option, text) : null;
}
