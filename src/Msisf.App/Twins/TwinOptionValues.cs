using Msisf.App.Preparation;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Camera;
using Msisf.Core.Render;
using Msisf.Core.Render.Photometry;

namespace Msisf.App.Twins;

/// <summary>The options of the run that draws a twin: the user's, and those that the label answers.</summary>
internal static class TwinOptionValues
{
    /// <summary>Layer that is compared.</summary>
    public const string RadianceFactor = "radiance-factor";

    /// <summary>Layer by which the comparison is divided.</summary>
    public const string Phase = "phase";

    /// <summary>The user's options, checked, with what holds for every twin.</summary>
    /// <exception cref="MsisfException">A value is wrong, or options contradict each other.</exception>
    public static OptionValues Begin(OptionValues values)
    {
        OptionValues begun = With(
            values,
            [
                (RendererOptions.Renderer, RendererOptions.Renderer.WordOf(RendererKind.Native)),
                (NativeOptions.Layers, $"{RadianceFactor},{Phase}"), (NativeOptions.LayersFormat, "npy"),
                (NativeOptions.Reflectance, "moon"), (LightOptions.Aberration, "lt+s"),
            ]);

        // What is wrong in an option is said before the label is looked at.
        _ = new FrameNaming(OutputOptions.Name.Read(values));
        ScanOptions.Period.ReadIfGiven(values);
        TwinOptions.Band.ReadIfGiven(values);
        TwinOptions.ReadLines(values);
        TwinOptions.ReadHasKernels(values);
        MissionSettingsReader.ReadAxes(values);
        MissionOptions.OfGround.Read(values);
        RenderSettingsReader.Read(begun.Replacing([ScanOptions.Period, .. MissionOptions.All], []));
        return begun;
    }

    /// <summary>
    /// The band of the law and the map that is nearest to that of the product, unless the user gives one; of 604 nm no scale of a map is
    /// known.
    /// </summary>
    public static OptionValues WithBand(OptionValues values, double? nanometres) => nanometres is not { } wavelength
        ? values
        : With(values, [(AlbedoOptions.Band, NumberSpec.TextOf(
            SpectralBand.All.Where(band => band.Nanometres != 604).MinBy(band => Math.Abs(band.Nanometres - wavelength))!.Nanometres))]);

    /// <summary>Adds the camera and its exposures.</summary>
    public static OptionValues WithCamera(OptionValues values, TwinCamera camera, TwinPlan plan)
    {
        string count = plan.Exposures.ToString(CultureInfo.InvariantCulture);
        OptionValues withCamera = With(values, [(ImageOptions.Camera, camera.Word)]);
        return camera.File.Scan?.Kind is not { } kind || kind == ScanKind.RollingShutter
            ? withCamera
            : With(
                withCamera.Replacing([ScanOptions.Period], []),
                [
                    (kind == ScanKind.LineScan ? ScanOptions.Lines : ScanOptions.Framelets, count),
                    (ScanOptions.Period, NumberSpec.TextOf(plan.Period)),
                ]);
    }

    /// <summary>Adds options that the user does not give.</summary>
    public static OptionValues With(OptionValues values, IEnumerable<(OptionSpec Option, string Word)> more) => values.With(
        more.Where(pair => values.Words(pair.Option) is null)
            .Select(pair => KeyValuePair.Create(pair.Option.Name, new OptionValue([pair.Word]))));
}
