using System.CommandLine;
using Msisf.Adapters.Ephemeris;
using Msisf.Adapters.Render;
using Msisf.Cli.Run;
using Msisf.Core.Camera;
using Msisf.Core.Ephemeris;
using Msisf.Core.Errors;
using Msisf.Core.Metadata;
using Msisf.Core.Render;
using Msisf.Core.Scene;
using Msisf.Core.Tiles;

namespace Msisf.Cli.Options;

/// <summary>Turns the text of the options into checked values, with the defaults of thesis appendix A.</summary>
internal sealed class RenderSettingsReader
{
    /// <summary>px: the largest side of a picture.</summary>
    private const int LargestSide = 16384;

    /// <summary>More frames at once than any computer runs.</summary>
    private const int MostJobs = 1024;

    /// <summary>px: from here on nothing of the Moon would be left to see.</summary>
    private const double GreatestLevelOfDetailError = 100.0;

    private readonly ParseResult _line;

    public RenderSettingsReader(ParseResult line) => _line = line;

    public RenderSettings Read(PictureOptions picture, SourceOptions source, RunOptions run, NativeOptions nativeOptions)
    {
        NativeSettingsReader native = new(_line, nativeOptions);
        PixelSurface surface = _line.GetValue(picture.Surface) is string words
            ? OptionText.Choice(picture.Surface, words, [("sphere", PixelSurface.Sphere), ("terrain", PixelSurface.Terrain)])
            : PixelSurface.Sphere;
        int width = WholeNumber(picture.Width, 1024, LargestSide);
        int height = WholeNumber(picture.Height, 1024, LargestSide);
        int grid = WholeNumber(picture.Grid, PixelGrid.DefaultSpacing, int.MaxValue);
        return new RenderSettings
        {
            FieldOfViewDegrees = FieldOfView(picture.FieldOfView),
            Width = width,
            Height = height,
            GridHorizontal = WholeNumber(picture.GridHorizontal, grid, int.MaxValue),
            GridVertical = WholeNumber(picture.GridVertical, grid, int.MaxValue),
            Surface = surface,
            PixelsPerDegree = SourceSettings.Resolution(_line, source),
            Renderer = native.Renderer(),
            Native = native.Read(needsTruth: surface == PixelSurface.Terrain),
            LevelOfDetailError = LevelOfDetailError(picture, native.Renderer()),
            IgnoreSun = _line.GetValue(picture.IgnoreSun),
            Annotate = _line.GetValue(picture.Annotation),
            OutputFolder = PathOf(picture.OutputFolder) ?? "output",
            OutputName = _line.GetValue(picture.OutputName) ?? FrameNaming.DefaultPattern,
            PatternRepository = PathOf(source.PatternRepository) ?? SourceSettings.DefaultRepository,
            Ldem = PathOf(source.Ldem),
            Ephemeris = _line.GetValue(run.Ephemeris) is string engine
                ? OptionText.Choice(
                    run.Ephemeris,
                    engine,
                    [("cspice", EphemerisChoice.CSpice), ("builtin", EphemerisChoice.BuiltIn), ("auto", EphemerisChoice.Auto)])
                : EphemerisChoice.Auto,
            Aberration = Aberration(run.Aberration, picture.IgnoreSun),
            Kernels = PathOf(run.Kernels),
            PovPath = PathOf(run.PovPath),
            PovOptions = PovRayOptions.Parse(_line.GetValue(run.PovOptions) ?? string.Empty),
            Timeout = Timeout(run.Timeout),
            Jobs = _line.GetValue(run.Jobs) is null ? null : WholeNumber(run.Jobs, 1, MostJobs),
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
            : throw new BadInputException($"--fov is {_line.GetValue(option)}; a field of view between 0 and 180 degrees (without them) is needed.");
    }

    private double? LevelOfDetailError(PictureOptions picture, RendererKind renderer)
    {
        bool isOff = _line.GetValue(picture.LevelOfDetail) is string word && OptionText.Choice(picture.LevelOfDetail, word, [("auto", false), ("off", true)]);
        if (_line.GetValue(picture.LevelOfDetailError) is not string text)
        {
            return isOff ? null : renderer == RendererKind.Native ? LevelOfDetail.UsualErrorPixels : PartSelector.UsualErrorPixels;
        }

        if (isOff)
        {
            throw new UsageException("--lod-error has no meaning with --lod off, which always shows the model itself. Leave one of them out.");
        }

        double error = OptionText.Number(picture.LevelOfDetailError, text);
        return error is >= 0.0 and <= GreatestLevelOfDetailError
            ? error
            : throw new BadInputException($"--lod-error is {text}; 0 to {GreatestLevelOfDetailError} pixels are possible.");
    }

    private Aberration Aberration(Option<string?> option, Option<bool> ignoreSun)
    {
        if (_line.GetValue(option) is not string text)
        {
            return Core.Ephemeris.Aberration.None;
        }

        return _line.GetValue(ignoreSun)
            ? throw new UsageException($"{option.Name} has no meaning with {ignoreSun.Name}, which lights the scene from the camera. Leave one out.")
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
