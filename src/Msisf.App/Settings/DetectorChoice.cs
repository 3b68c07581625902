using Msisf.Adapters.Camera;
using Msisf.Adapters.Input;
using Msisf.App.Settings.Specs;
using Msisf.Core.Render;

namespace Msisf.App.Settings;

/// <summary>Checks what the detector of a camera file needs of the other options.</summary>
internal static class DetectorChoice
{
    /// <summary>s: an exposure is above 0 and no longer than a day.</summary>
    private static readonly NumberRange LimitsOfTime = new(0.0, 86400.0) { ExcludesMin = true };

    /// <exception cref="UsageException">An option contradicts it.</exception>
    public static CameraFileDetector? Of(CameraFile? camera, OptionValues values)
    {
        if (values.IsGiven(CameraOptions.Motion) && camera?.Detector?.Settings.Shutter is null
            && camera?.Scan is null && !values.IsGiven(RigOptions.Rig))
        {
            throw CameraOptions.Motion.Wrong(
                "has no meaning without a camera file whose section 'detector' has a 'shutter' (docs/detector.md). Add the key, or remove "
                    + "the option.", ImageOptions.Camera);
        }

        if (camera?.Detector is null)
        {
            values.Refuse(
                [NativeOptions.ExposureTime, NativeOptions.NoiseSeed],
                "has no meaning without a camera file that has the section 'detector' (docs/detector.md). Name one by --camera, or remove "
                    + "the option.",
                ImageOptions.Camera);
            return null;
        }

        if (RendererOptions.Renderer.Read(values) != RendererKind.Native)
        {
            throw ImageOptions.Camera.Wrong(
                $"{camera.Name} has a detector, which needs the radiance of each pixel. Add --renderer native.", RendererOptions.Renderer);
        }

        return !LightOptions.IgnoreSun.Read(values)
            ? camera.Detector
            : throw ImageOptions.Camera.Wrong(
                $"{camera.Name} has a detector, which counts electrons of sunlight. Leave --ignore-sun out.", LightOptions.IgnoreSun);
    }

    /// <summary>The settings with the exposure time of the options; without a detector, a file's exposure time is not looked at.</summary>
    /// <exception cref="UsageException">It is not a time.</exception>
    public static NativeSettings WithExposureTime(OptionValues values, NativeSettings native)
    {
        string? text = NativeOptions.ExposureTime.ReadIfGiven(values);
        if (text is null || native.Detector is null)
        {
            return native;
        }

        if (ChoiceSpec.IsSame(text, NativeOptions.Automatic))
        {
            return native with { FindsExposureTime = true };
        }

        return NumberText.TryParse(text, out double seconds) && LimitsOfTime.Contains(seconds)
            ? native.WithExposureTime(seconds)
            : throw NativeOptions.ExposureTime.Wrong(
                $"is {NumberText.Shown(text)}; seconds {LimitsOfTime}, or {NativeOptions.Automatic}, are needed.");
    }
}
