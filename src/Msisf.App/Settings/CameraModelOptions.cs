using Msisf.Adapters.CameraExport;
using Msisf.App.Settings.Specs;
using Msisf.Core.Camera;
using Msisf.Core.Render;

namespace Msisf.App.Settings;

/// <summary>The options of camera models for other programs.</summary>
internal static class CameraModelOptions
{
    private const string Formats = "opencv, colmap, tsai (Ames Stereo Pipeline), csm (USGSCSM state), isd (ALE, J2000), isd-body, "
        + "isis (cube with the image), pds4 (the image with a label)";

    public static TextSpec OfRun { get; } = new(
        "--camera-model", DecidesBytes.UnlessDefault(frame => frame.Settings.CameraFormats.Select(format => format.Word)), "LIST",
        $"Write the camera of each image for other programs, in formats separated by commas: {Formats}")
    {
        Separator = ",",
        Words = [.. CameraFormat.All.Select(format => format.Word)],
    };

    /// <summary>The formats of <c>msis camera-model</c>.</summary>
    private static TextSpec To { get; } = new(
        "--to", OptionRole.HowItRuns, "LIST", $"The formats, separated by commas: {Formats}")
    {
        IsOfOneCall = true,
        IsRequired = true,
        Separator = OfRun.Separator,
        Words = OfRun.Words,
    };

    public static CommandSpec Command { get; } = new("camera-model", "Write the camera of an image that is there for other programs.")
    {
        Details = "The files are written beside the meta files, and are printed. docs/camera-export.md says what each holds.",
        MakeArgument = () => new ArgumentSpec("META", "Meta files (.xml) of images") { TakesSeveralWords = true },
        Examples =
            [("For ISIS and the Ames Stereo Pipeline:", "msis camera-model output/MoonSurfIllumSim_step_00001.xml --to csm")],
        MakeGroups = () =>
        [
            new OptionGroup("Camera model", [To, LightOptions.Ephemeris, LightOptions.Kernels]),
            new OptionGroup("General", [RunOptions.Help]),
        ],
    };

    /// <exception cref="UsageException">A word is not a format, or the renderer does not know the pixels.</exception>
    public static IReadOnlyList<CameraFormat> ReadOfRun(OptionValues values, RendererKind renderer)
    {
        if (OfRun.ReadIfGiven(values) is not { } text)
        {
            return [];
        }

        IReadOnlyList<CameraFormat> formats = OfRun.Named(() => CameraFormat.Parse(text));
        return renderer == RendererKind.PovRay && formats.FirstOrDefault(format => format.HasPixels) is { } wrong
            ? throw OfRun.Wrong(
                $"{wrong.Word} holds I/F of each pixel, which POV-Ray does not tell. Add --renderer native.", RendererOptions.Renderer)
            : formats;
    }

    /// <summary>Refuses a camera that a format can't say.</summary>
    /// <exception cref="BadInputException">Format, lens, and which formats can.</exception>
    public static void Require(RenderSettings settings) => OfRun.NamedInErrors(() => CameraFormat.Require(
        settings.CameraFormats,
        settings.Scan is { Kind: not ScanKind.RollingShutter } scan
            ? scan.ExposureOf(settings.CameraModel, 0, 0.0)
            : settings.CameraModel,
        settings.Scan?.Kind));

    /// <summary>Reads the formats of <c>msis camera-model</c>.</summary>
    /// <exception cref="UsageException">A word is not a format.</exception>
    public static IReadOnlyList<CameraFormat> ReadTo(OptionValues values) => To.Named(() => CameraFormat.Parse(To.Read(values)));
}
