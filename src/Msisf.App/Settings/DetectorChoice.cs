using Msisf.Adapters.Camera;
using Msisf.App.Settings.Specs;
using Msisf.Core.Errors;
using Msisf.Core.Layers;
using Msisf.Core.Render;

namespace Msisf.App.Settings;

/// <summary>Checks what the detector of a camera file needs of the other options.</summary>
internal static class DetectorChoice
{
    /// <summary>The detector of a camera; null without one.</summary>
    /// <exception cref="UsageException">An option contradicts it.</exception>
    public static CameraFileDetector? Of(CameraFile? camera, OptionValues values)
    {
        if (values.IsGiven(CameraOptions.Motion) && camera?.Detector?.Settings.Shutter is null)
        {
            throw new UsageException(
                $"{CameraOptions.Motion.Name} has no meaning without a camera file whose section 'detector' has a 'shutter' "
                    + "(docs/detector.md). Add the key, or remove the option.")
                .About(CameraOptions.Motion, ImageOptions.Camera);
        }

        if (camera?.Detector is null)
        {
            return null;
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

    /// <summary>The layers that there are: those of the detector only with one.</summary>
    /// <param name="layers">What the user wants; null for nothing.</param>
    /// <param name="detector">The camera's detector.</param>
    /// <exception cref="UsageException">A layer of the detector is named, and there is none.</exception>
    public static LayerSet? LayersOf(LayerSet? layers, CameraFileDetector? detector)
    {
        if (layers is null || detector is not null)
        {
            return layers;
        }

        return layers == LayerSet.All
            ? LayerSet.WithoutDetector
            : layers.Layers.FirstOrDefault(layer => layer.NeedsDetector) is Layer layer
                ? throw new UsageException(
                    $"--layers: {layer.Name} needs a camera with a detector. Name a --camera file that has the section 'detector'.")
                    .About(NativeOptions.Layers, ImageOptions.Camera)
                : layers;
    }
}
