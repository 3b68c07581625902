using Msisf.Core.Camera;

namespace Msisf.App.Settings;

/// <summary>Which scanned images are drawn strip by strip, because they are too large for the memory, and what they can't have.</summary>
internal static class StripRules
{
    /// <summary>px: larger images are drawn in strips; one of so many takes some 1.6 GB.</summary>
    public const long LargestWhole = 1L << 23;

    /// <summary>px of a strip: 50 MB.</summary>
    public const long PixelsOfStrip = 1L << 18;

    /// <summary>Whether an image is drawn in strips.</summary>
    /// <param name="scan">How it is scanned; null for a frame.</param>
    /// <param name="width">px.</param>
    /// <param name="height">px.</param>
    public static bool IsStriped(Scan? scan, int width, int height) =>
        scan is { Kind: not ScanKind.RollingShutter } && (long)width * height > LargestWhole;

    /// <summary>Refuses what needs all of an image that is drawn in strips.</summary>
    /// <exception cref="UsageException">An option asks for it.</exception>
    public static void Refuse(RenderSettings settings)
    {
        if (!IsStriped(settings.Scan, settings.Width, settings.Height))
        {
            return;
        }

        string? wrong = settings.Annotate ? OutputOptions.Annotation.Name
            : settings.Native.Navigation is not null ? "truth for navigation"
            : settings.Map is not null ? MapOptions.Map.Name
            : settings.CameraFormats.FirstOrDefault(format => format.HasPixels) is { } model
                ? $"{CameraModelOptions.OfRun.Name} {model.Word}"
            : settings.Native.FindsExposureTime ? $"{NativeOptions.ExposureTime.Name} {NativeOptions.AutomaticTime}"
            : null;
        if (wrong is not null)
        {
            throw new UsageException($"an image of {settings.Width} x {settings.Height} px is drawn in strips, and {wrong} needs more of "
                + "it "
                + $"at once. Leave it out, or scan fewer lines: {LargestWhole / settings.Width} are drawn as a whole.");
        }
    }
}
