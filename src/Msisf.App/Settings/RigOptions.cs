using Msisf.Adapters.Camera;
using Msisf.Adapters.Raster.Heights;
using Msisf.App.Settings.Specs;
using Msisf.Core.Camera;
using Msisf.Core.Render;

namespace Msisf.App.Settings;

/// <summary>The option of several cameras on one body, which gives the options of each of them.</summary>
internal static class RigOptions
{
    /// <summary>Stands for the name of a rig's camera in names of files.</summary>
    public const string CameraField = "{camera}";

    public static PathSpec Rig { get; } = new(
        "--rig", DecidesBytes.ByStatesOfRun, PathKind.File,
        "Several cameras on one body (docs/cameras.md), in place of --camera: each state is the body's, and each camera draws an image of "
            + "it. {camera} in --output-name stands for its name");

    /// <summary>The options that a camera of a rig may have, by their keys.</summary>
    public static IReadOnlyList<OptionSpec> OfCamera =>
    [
        ImageOptions.Camera, ImageOptions.FieldOfView, ImageOptions.Width, ImageOptions.Height, ScanOptions.Lines, ScanOptions.Framelets,
        ScanOptions.Period,
    ];

    /// <summary>Reads the settings of a run: those of each camera of its rig, or of the only one.</summary>
    /// <param name="geoTiffs">Opens elevation models in GeoTIFF, to be used again for the run; null if the run is not made here.</param>
    /// <exception cref="MsisfException">A value is wrong, or an option can't be combined with another.</exception>
    public static IReadOnlyList<RenderSettings> Read(OptionValues values, GeoTiffFiles? geoTiffs = null)
    {
        if (Rig.ReadIfGiven(values) is not { } path)
        {
            return [RenderSettingsReader.Read(values, geoTiffs: geoTiffs)];
        }

        values.Refuse(OfCamera, $"and {Rig.Name} exclude each other: the rig file says it of each camera. Leave one out.", Rig);
        RigFile file = Rig.NamedInErrors(() => File.Exists(path)
            ? RigFile.Read(path, [.. OfCamera.Select(option => option.Key)], CameraOptions.Normalize.Read(values))
            : throw new BadInputException(Directory.Exists(path)
                ? $"{Rig.Name} {path}: is a folder; a rig file is needed."
                : $"{Rig.Name} {path}: there is no such file."));
        MountedCamera[] cameras = [.. file.Cameras.Select(camera => camera.Mounted)];
        RenderSettings[] settings = [.. file.Cameras.Select((camera, index) => Read(values, file, camera, geoTiffs) with
        {
            Rig = new RigCamera(cameras, index),
            RigFile = file.Input,
        })];
        return !values.IsGiven(CameraOptions.Motion) || settings.Any(camera => camera.Shutter is not null || camera.Scan is not null)
            ? settings
            : throw CameraOptions.Motion.Wrong($"has no meaning for the cameras of {path}: none has a shutter or scans. Remove it.", Rig);
    }

    /// <summary>Reads the settings of a run that draws with one camera.</summary>
    /// <exception cref="UsageException">There is a rig.</exception>
    public static RenderSettings ReadOne(OptionValues values, GeoTiffFiles? geoTiffs, string what) => Rig.ReadIfGiven(values) is null
        ? RenderSettingsReader.Read(values, geoTiffs: geoTiffs)
        : throw Rig.Wrong($"has several cameras, and {what}. Give one by {ImageOptions.Camera.Name}.");

    private static RenderSettings Read(OptionValues values, RigFile file, RigFileCamera camera, GeoTiffFiles? geoTiffs)
    {
        OptionValues own = values.Replacing(
            OfCamera,
            camera.Options.Select(option => KeyValuePair.Create(
                OfCamera.First(known => known.Key == option.Key).Name,
                new OptionValue([option.Key == ImageOptions.Camera.Key ? Beside(file.Path, option.Value) : option.Value]))));
        RenderSettings settings;
        try
        {
            settings = RenderSettingsReader.Read(own, geoTiffs: geoTiffs);
        }
        catch (MsisfException wrong) when (wrong.Options.Any(name => OfCamera.Any(option => option.Name == name)))
        {
            throw new BadInputException($"{file.Path}, camera {camera.Mounted.Name}: {wrong.Message}", wrong);
        }

        return settings.Renderer == RendererKind.Native
            ? settings
            : throw Rig.Wrong(
                $"draws with the program's own renderer. Add {RendererOptions.Renderer.Name} native.", RendererOptions.Renderer);
    }

    /// <summary>The path of a camera's file or folder: its name is in the path of all.</summary>
    /// <param name="path">With {camera}; null to print.</param>
    /// <param name="rig">The camera; null without a rig.</param>
    /// <exception cref="UsageException">All cameras of a rig would be written to one file.</exception>
    public static string? PathOf(string? path, RigCamera? rig) => rig is null ? path
        : path?.Contains(CameraField, StringComparison.Ordinal) == true
            ? path.Replace(CameraField, rig.Name, StringComparison.Ordinal)
            : throw new UsageException($"the cameras of a rig have states of their own. Give {StatesOptions.To.Name} a path with "
                + $"{CameraField} in it, for the camera's name.").About(StatesOptions.To, Rig);

    /// <summary>A file beside the rig's counts before one of the working folder, and before a preset.</summary>
    private static string Beside(string rig, string camera)
    {
        string path = Path.Combine(Path.GetDirectoryName(rig) ?? string.Empty, camera);
        return File.Exists(path) ? path : camera;
    }
}
