using Msisf.App.Settings.Specs;

namespace Msisf.App.Settings;

/// <summary>The options of the image itself.</summary>
internal static class ImageOptions
{
    /// <summary>Maximum width and height of an image, px.</summary>
    private const int MaxSide = 16384;

    public static NumberSpec FieldOfView { get; } = new(
        "--fov", DecidesBytes.As(frame => frame.Settings.Camera is null ? frame.Settings.FieldOfViewDegrees : null).AndTiles(),
        "DEGREES", "Horizontal field of view")
    {
        Aliases = ["-f"],
        Limits = new NumberRange(0.0, 180.0) { ExcludesMin = true, ExcludesMax = true },
        Default = 40.0,
    };

    public static WholeNumberSpec Width { get; } = new(
        "--width", DecidesBytes.As(frame => frame.Settings.Camera is { } camera ? camera.AddedWidth : frame.Settings.Width).AndTiles(),
        "PX", 1, MaxSide, "Image width")
    { Aliases = ["-w"], Default = 1024 };

    public static WholeNumberSpec Height { get; } = new(
        "--height", DecidesBytes.As(frame => frame.Settings.Camera is { } camera ? camera.AddedHeight : frame.Settings.Height).AndTiles(),
        "PX", 1, MaxSide, "Image height")
    { Aliases = ["-h"], Default = 1024 };

    public static TextSpec Camera { get; } = new(
        "--camera", DecidesBytes.As(frame => frame.Settings.Camera is { } camera ? CameraChoice.TextOf(camera) : null).AndTiles(),
        "FILE", "Camera file, or a preset's name (msis cameras lists them): focal length, pixels and lens, in place of --fov, "
            + "--width and --height. A file without width or height needs that option");

    public static OptionGroup Group { get; } = new("Image", [FieldOfView, Width, Height, Camera, RigOptions.Rig, .. ScanOptions.OfImage]);
}
