using Msisf.Adapters.Camera;
using Msisf.Adapters.Input;
using Msisf.App.Settings.Specs;
using Msisf.Core.Layers;
using Msisf.Core.Render;

namespace Msisf.App.Settings;

/// <summary>Checks what the detector of a camera file needs of the other options.</summary>
internal static class DetectorChoice
{
    /// <summary>s: an exposure is above 0 and no longer than a day.</summary>
    private static readonly NumberRange LimitsOfTime = new(0.0, 86400.0) { ExcludesMin = true };

    /// <summary>The detector of a camera; null without one.</summary>
    /// <exception cref="UsageException">An option contradicts it.</exception>
    public static CameraFileDetector? Of(CameraFile? camera, OptionValues values)
    {
        if (values.IsGiven(CameraOptions.Motion) && camera?.Detector?.Settings.Shutter is null
            && camera?.Scan is null && !values.IsGiven(RigOptions.Rig))
        {
            throw new UsageException(
                $"{CameraOptions.Motion.Name} has no meaning without a camera file whose section 'detector' has a 'shutter' "
                    + "(docs/detector.md). Add the key, or remove the option.")
                .About(CameraOptions.Motion, ImageOptions.Camera);
        }

        if (camera?.Detector is null)
        {
            OptionSpec? needless = ((OptionSpec[])[NativeOptions.ExposureTime, NativeOptions.NoiseSeed]).FirstOrDefault(values.IsGiven);
            return needless is null
                ? null
                : throw new UsageException(
                    $"{needless.Name} has no meaning without a camera file that has the section 'detector' (docs/detector.md). Name one by "
                        + "--camera, or remove the option.")
                    .About(needless, ImageOptions.Camera);
        }

        if (RendererOptions.Renderer.Read(values) != RendererKind.Native)
        {
            throw new UsageException(
                $"--camera {camera.Name} has a detector, which needs the radiance of each pixel. Add --renderer native.")
                .About(ImageOptions.Camera, RendererOptions.Renderer);
        }

        return !LightOptions.IgnoreSun.Read(values)
            ? camera.Detector
            : throw new UsageException(
                $"--camera {camera.Name} has a detector, which counts electrons of sunlight. Leave --ignore-sun out.")
                .About(ImageOptions.Camera, LightOptions.IgnoreSun);
    }

    /// <summary>The settings with the exposure time of the options; without a detector, a file's exposure time is not looked at.</summary>
    /// <exception cref="UsageException">It is no time.</exception>
    public static NativeSettings WithExposureTime(OptionValues values, NativeSettings native)
    {
        string? text = NativeOptions.ExposureTime.ReadIfGiven(values);
        if (text is null || native.Detector is null)
        {
            return native;
        }

        if (ChoiceSpec.IsSame(text, NativeOptions.AutomaticTime))
        {
            return native with { FindsExposureTime = true };
        }

        return NumberText.TryParse(text, out double seconds) && LimitsOfTime.Contains(seconds)
            ? native.WithExposureTime(seconds)
            : throw new UsageException(
                $"{NativeOptions.ExposureTime.Name} is {NumberText.Shown(text)}; seconds {LimitsOfTime}, or {NativeOptions.AutomaticTime}, "
                    + "are needed.").About(NativeOptions.ExposureTime);
    }

    /// <summary>The layers that there are: those of the detector only with one.</summary>
    /// <param name="layers">What the user wants; null for nothing.</param>
    /// <exception cref="UsageException">A layer of the detector is named, and there is none.</exception>
    public static LayerSet? LayersOf(LayerSet? layers, CameraFileDetector? detector)
    {
        if (layers is null || detector is not null)
        {
            return layers;
        }

        return layers == LayerSet.All
            ? layers.Without(layer => layer.NeedsDetector)
            : layers.Layers.FirstOrDefault(layer => layer.NeedsDetector) is Layer layer
                ? throw new UsageException(
                    $"--layers: {layer.Name} needs a camera with a detector. Name a --camera file that has the section 'detector'.")
                    .About(NativeOptions.Layers, ImageOptions.Camera)
                : layers;
    }
}
