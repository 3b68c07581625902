using Msisf.Adapters.Camera;
using Msisf.Adapters.CameraImport;
using Msisf.Adapters.Ephemeris;
using Msisf.Adapters.Input;
using Msisf.Adapters.IO;
using Msisf.App.Settings.Specs;
using Msisf.Core.Render;

namespace Msisf.App.Settings;

/// <summary>Reads the camera that <c>--camera</c> names: a preset of the installation, or a file.</summary>
internal static class CameraChoice
{
    /// <summary>Separates a file from the beginning of its checksum, as the arguments of a frame name it.</summary>
    private const char ChecksumMark = '#';

    /// <summary>Digits of the checksum in the arguments of a frame.</summary>
    private const int ShownDigits = 16;

    private const string Extension = ".yaml";

    /// <param name="open">Opens the camera of a name; null for a preset or a file.</param>
    /// <exception cref="MsisfException">
    /// There is no such camera, its file is wrong or not the one that is meant, or the renderer or another option contradicts it.
    /// </exception>
    public static CameraFile? Read(OptionValues values, Func<string, CameraFile>? open = null)
    {
        if (ImageOptions.Camera.ReadIfGiven(values) is not { } given)
        {
            return OfInstrument(values);
        }

        Refuse(values, [ImageOptions.FieldOfView]);
        (int? Width, int? Height) size = (ImageOptions.Width.ReadIfGiven(values), ImageOptions.Height.ReadIfGiven(values));
        CameraFile camera = ImageOptions.Camera.NamedInErrors(
            () => open is null ? Open(given, Installation.Above(AppContext.BaseDirectory), size) : open(given));
        Refuse(
            values,
            [
                .. camera.AddedWidth is null ? (OptionSpec[])[ImageOptions.Width] : [],
                .. camera.AddedHeight is null ? (OptionSpec[])[ImageOptions.Height] : [],
            ]);
        return Drawable(camera, $"{ImageOptions.Camera.Name} {given}", ImageOptions.Camera, values);
    }

    private static CameraFile Drawable(CameraFile camera, string given, OptionSpec option, OptionValues values) =>
        camera.Model.Distortion is null || RendererOptions.Renderer.Read(values) == RendererKind.Native
            ? camera
            : throw new UsageException(
                $"{given} has a lens with distortion, which POV-Ray can't draw. Add --renderer native, or remove it.")
                .About(option, RendererOptions.Renderer);

    /// <summary>The camera of an instrument kernel; null if none is asked for, or other options say what the camera is.</summary>
    private static CameraFile? OfInstrument(OptionValues values)
    {
        OptionSpec[] others = [ImageOptions.FieldOfView, ImageOptions.Width, ImageOptions.Height];
        if (MissionOptions.Instrument.ReadIfGiven(values) is not { } instrument || others.Any(values.IsGiven))
        {
            return null;
        }

        Installation installation = Installation.Above(AppContext.BaseDirectory);
        KernelPool pool = LightOptions.Kernels.NamedInErrors(() => KernelPool.Of(KernelList.Expand(
            KernelList.OnTop(installation.MetaKernel, LightOptions.Kernels.ReadAll(values), SpacecraftKernels.None))));
        return Drawable(
            MissionOptions.Instrument.NamedInErrors(() => new InstrumentKernel(pool, instrument).Camera(
                MissionSettingsReader.ReadAxes(values))),
            $"{MissionOptions.Instrument.Name} {instrument}", MissionOptions.Instrument, values);
    }

    public static IReadOnlyList<CameraFile> Presets(Installation installation) =>
        [.. NamesIn(installation).Select(name => CameraFileReader.Read(PathOf(installation, name), name))];

    /// <summary>The preset of a name, in capitals or small letters; null if there is none.</summary>
    public static CameraFile? Preset(string name, Installation installation) =>
        NamesIn(installation).FirstOrDefault(preset => preset.Equals(name, StringComparison.OrdinalIgnoreCase)) is { } found
            ? CameraFileReader.Read(PathOf(installation, found), found)
            : null;

    /// <summary>The camera as the arguments of a frame name it: a file with the beginning of its checksum, a preset by its name.</summary>
    public static string TextOf(CameraFile camera) =>
        camera.IsPreset ? camera.Name : $"{camera.Name}{ChecksumMark}{camera.Sha256[..ShownDigits]}";

    /// <summary>Looks for the file that the arguments of a frame name (<see cref="TextOf"/>).</summary>
    /// <param name="text">Its name, with the beginning of its checksum.</param>
    /// <param name="folders">Where it may be.</param>
    /// <returns>The camera; null if none of the folders has this very file.</returns>
    public static CameraFile? Find(string text, IEnumerable<string> folders)
    {
        int mark = text.LastIndexOf(ChecksumMark);
        if (mark < 0 || Path.GetFileName(text) != text)
        {
            return null;
        }

        foreach (string path in folders.Select(folder => Path.Combine(folder, text[..mark]))
            .Where(path => File.Exists(CameraFormats.Split(path).Path)))
        {
            try
            {
                CameraFile camera = CameraFileReader.Read(path);
                if (TextOf(camera) == text)
                {
                    return camera;
                }
            }
            catch (BadInputException)
            {
                // Another file of that name: none of the frame's.
            }
        }

        return null;
    }

    /// <summary>Refuses options that say what the camera file says.</summary>
    private static void Refuse(OptionValues values, OptionSpec[] replaced) => values.Refuse(
        replaced, "and --camera exclude each other: the camera file says it. Leave one of them out.", ImageOptions.Camera);

    private static CameraFile Open(string given, Installation installation, (int? Width, int? Height) size)
    {
        if (Preset(given, installation) is { } preset)
        {
            return preset;
        }

        int mark = given.LastIndexOf(ChecksumMark);
        (string named, string? checksum) = File.Exists(given) || mark < 0 ? (given, null) : (given[..mark], given[(mark + 1)..]);
        string path = CameraFormats.Split(named).Path;
        if (Directory.Exists(path))
        {
            throw new BadInputException($"--camera {path}: is a folder; a camera file is needed.");
        }

        if (!File.Exists(path))
        {
            // A path is looked for as every file is; a plain word can only have meant a preset.
            throw Path.GetExtension(path).Length > 0 || path.Contains('/')
                ? new BadInputException($"--camera {path}: there is no such file.")
                : new UsageException($"--camera '{path}' is neither a file nor a preset"
                    + $"{NearestName.Question(path, [.. NamesIn(installation)])} "
                    + $"('msis cameras' lists the presets)");
        }

        CameraFile camera = CameraFileReader.Read(named, size: size);
        return checksum is null || camera.Sha256.StartsWith(checksum, StringComparison.OrdinalIgnoreCase)
            ? camera
            : throw new BadInputException(
                $"--camera {given}: the file's SHA-256 begins with {camera.Sha256[..ShownDigits]}. Give the file that is meant, or leave "
                    + $"{ChecksumMark}{checksum} out.");
    }

    private static IEnumerable<string> NamesIn(Installation installation) => Directory.Exists(installation.Cameras)
        ? Directory.EnumerateFiles(installation.Cameras, $"*{Extension}")
            .Select(path => Path.GetFileNameWithoutExtension(path))
            .Order(StringComparer.Ordinal)
        : [];

    private static string PathOf(Installation installation, string name) => Path.Combine(installation.Cameras, name + Extension);
}
