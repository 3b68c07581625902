using System.Globalization;
using Msisf.Adapters.Ephemeris;
using Msisf.Core.Ephemeris;
using Msisf.Core.Metadata;
using Msisf.Core.Render;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Scene;

namespace Msisf.App.Settings;

/// <summary>
/// The arguments that make a frame what it is, all of them and in a fixed order, whatever the user's own call said of it, by config file,
/// batch file or orbit. What only says where files are and how a run goes is left out: it changes no byte.
/// </summary>
internal static class FrameArguments
{
    /// <summary>All but the state.</summary>
    /// <param name="settings">Of the run.</param>
    /// <param name="engine">The ephemeris engine that gives the Sun; null if none is asked.</param>
    public static string OfSettings(RenderSettings settings, EphemerisChoice? engine)
    {
        List<string> words = ["--fov", Text(
            settings.FieldOfViewDegrees), "--width", Text(settings.Width), "--height", Text(settings.Height)];
        words.AddRange(["--gridH", Text(settings.GridHorizontal), "--gridV", Text(settings.GridVertical)]);
        words.AddRange(
            ["--surface", settings.Surface == PixelSurface.Terrain ? "terrain" : "sphere", "--res", Text(settings.PixelsPerDegree)]);
        words.AddRange(settings.LevelOfDetailError is double error ? ["--lod-error", Text(error)] : ["--lod", "off"]);
        words.AddRange(
            settings.IgnoreSun ? ["--ignore-sun"] : ["--ephemeris", TextOf(engine), "--aberration", TextOf(settings.Aberration)]);
        if (settings.Annotate)
        {
            words.Add("--rendering-annotation");
        }

        if (settings.Renderer == RendererKind.Native)
        {
            AddNative(words, settings.Native);
        }
        else
        {
            words.AddRange(["--renderer", "povray"]);
            words.AddRange(settings.PovOptions.Count > 0 ? ["--pov-options", $"'{string.Join(' ', settings.PovOptions)}'"] : []);
        }

        return string.Join(' ', words);
    }

    /// <summary>The arguments that make this frame alone.</summary>
    /// <param name="state">Its state.</param>
    /// <param name="settings">What <see cref="OfSettings"/> gives.</param>
    public static string Of(SpacecraftState state, string settings) =>
        $"--fixed-state '{{{string.Join(',', state.ToNumbers().Select(Text))}}}' {settings}";

    private static void AddNative(List<string> words, NativeSettings native)
    {
        words.AddRange(["--renderer", "native", "--reflectance", native.ReflectanceText]);
        words.AddRange(native.Albedo is double albedo ? ["--albedo", Text(albedo)] : []);
        words.AddRange(["--sun", native.Render.Sun == SunModel.Disc ? "disc" : "point"]);
        words.AddRange(["--samples", Text(native.Render.SubsamplesPerAxis * native.Render.SubsamplesPerAxis)]);
        words.AddRange(["--shading", native.Render.Normals == NormalModel.Smooth ? "smooth" : "facet"]);
        words.AddRange(
            ["--exposure", Text(native.Grey.Exposure), "--transfer", native.Grey.Transfer == GreyTransfer.Linear ? "linear" : "srgb"]);
        words.AddRange(["--bit-depth", Text(native.BitDepth)]);
        if (native.Layers is not null)
        {
            words.AddRange(["--layers", string.Join(',', native.Layers.Layers.Select(layer => layer.Name))]);
            words.AddRange(["--layers-format", native.LayersFormat == LayersFormat.Npy ? "npy" : "fits"]);
        }
    }

    private static string TextOf(EphemerisChoice? engine) => engine == EphemerisChoice.CSpice ? "cspice" : "builtin";

    private static string TextOf(Aberration aberration) => aberration switch
    {
        Aberration.LightTime => "lt",
        Aberration.LightTimeAndStellar => "lt+s",
        _ => "none",
    };

    private static string Text(double value) => value.ToString("R", CultureInfo.InvariantCulture);

    private static string Text(int value) => value.ToString(CultureInfo.InvariantCulture);
}
