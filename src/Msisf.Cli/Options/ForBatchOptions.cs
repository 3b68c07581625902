using System.CommandLine;
using Msisf.App.Settings;
using Msisf.Core.Errors;

namespace Msisf.Cli.Options;

/// <summary>
/// What <c>msis patterns</c> asks of a run to know what its frames need: where the camera is, and what else the choice of meshes depends
/// on.
/// </summary>
internal sealed class ForBatchOptions
{
    private readonly ImageOptions _image = new();
    private readonly RunOptions _run = new();

    /// <summary>The way the states are given; a batch file is named for what it is here.</summary>
    public ModeOptions Mode { get; } = new()
    {
        BatchFile = OptionFactory.Value(
            "--for-batch", ["--batch-file"], "FILE",
            "Only what the frames of this batch file need, from the summary of the model to the parts of the surface at their levels"),
    };

    /// <summary>The command's own too.</summary>
    public Option<bool> Batch => _run.Batch;

    /// <summary>Options that have a meaning with a run only.</summary>
    public IEnumerable<Option> All =>
    [
        .. Mode.All, _image.FieldOfView, _image.Width, _image.Height, _image.LevelOfDetail, _image.LevelOfDetailError, _image.IgnoreSun,
        _run.Frames, _run.Ephemeris, _run.Kernels, _run.Aberration, _run.Jobs,
    ];

    /// <summary>Reads the run, if one is given.</summary>
    /// <param name="line">The line.</param>
    /// <param name="source">The command's options that both ways share.</param>
    /// <param name="ofWholeMoon">The command's options that have a meaning without a run only.</param>
    /// <exception cref="MsisfException">An option is wrong, or forbidden beside another.</exception>
    public (Mode Mode, RenderSettings Settings)? Read(ParseResult line, SourceOptions source, IEnumerable<Option> ofWholeMoon)
    {
        bool IsGiven(Option option) => line.GetResult(option) is { Implicit: false };
        if (ModeRules.Check(Mode, IsGiven) is not { } mode)
        {
            Refuse(All, IsGiven, $"is for the patterns of a run only. Say of which by {Mode.BatchFile.Name}, or leave it out.");
            return null;
        }

        Refuse(ofWholeMoon, IsGiven, "has no meaning for the patterns of a run. Leave it out, or make those of the whole Moon.");
        return (mode, new RenderSettingsReader(line).Read(_image, source, _run, new NativeOptions()));
    }

    private static void Refuse(IEnumerable<Option> options, Func<Option, bool> isGiven, string why)
    {
        if (options.FirstOrDefault(isGiven) is { } wrong)
        {
            throw new UsageException($"{wrong.Name} {why}");
        }
    }
}
