using System.Text.RegularExpressions;
using Msisf.Adapters.Input;

namespace Msisf.Adapters.CameraImport;

/// <summary>
/// Camera files of other programs (docs/cameras.md, "Files of other programs"), recognised by their content and not by their names.
/// </summary>
public static class CameraFormats
{
    private const string Selector = ",camera=";

    /// <summary>The formats, in the order in which they are tried: the first that takes a text reads it.</summary>
    private static readonly (string Name, Func<string, bool> Is, Func<string, string, IReadOnlyList<NamedCamera>> Read)[] All =
    [
        ("an ISIS cube", CubeCamera.Is, CubeCamera.Read),
        ("USGSCSM's state", CsmCamera.IsState, CsmCamera.ReadState),
        ("ALE's image support data (ISD)", CsmCamera.IsIsd, CsmCamera.ReadIsd),
        ("Ames Stereo Pipeline (.tsai)", TsaiFile.Is, TsaiFile.Read),
        ("Kalibr", KalibrFile.Is, KalibrFile.Read),
        ("EuRoC", EurocFile.Is, EurocFile.Read),
        ("ORB-SLAM", OrbSlamFile.Is, OrbSlamFile.Read),
        ("OpenCV", OpenCvFile.Is, OpenCvFile.Read),
        ("ROS", RosFile.Is, RosFile.Read),
        ("COLMAP", ColmapFile.Is, ColmapFile.Read),
    ];

    /// <summary>What is read, for messages.</summary>
    public static string Names => string.Join(", ", All.Select(format => format.Name));

    /// <summary>Parts a file from the camera of it that is meant, <c>FILE,camera=NAME</c>.</summary>
    /// <returns>The file, and the name; null without one.</returns>
    public static (string Path, string? Camera) Split(string given)
    {
        int at = given.LastIndexOf(Selector, StringComparison.Ordinal);
        return at < 0 || File.Exists(given) ? (given, null) : (given[..at], given[(at + Selector.Length)..]);
    }

    /// <summary>Reads the file of another program.</summary>
    /// <param name="content">The file, or the beginning of a cube.</param>
    /// <param name="path">For messages.</param>
    /// <param name="camera">Which of its cameras; null for the only one.</param>
    /// <returns>The keys of a camera file; null for a file of none of these programs.</returns>
    /// <exception cref="BadInputException">
    /// What is wrong in it; or it has several cameras, and none or another one is asked for; or msis has no such camera.
    /// </exception>
    public static IReadOnlyList<ConfigEntry>? Read(byte[] content, string path, string? camera)
    {
        if (KnownFormats.Of(content) is { } known)
        {
            throw new BadInputException($"{path}: {known.Refusal(FormatUse.Camera)}");
        }

        string text = TextFile.Decode(content).Text;
        (string name, _, Func<string, string, IReadOnlyList<NamedCamera>>? read) = All.FirstOrDefault(format => format.Is(text));
        if (read is null)
        {
            return camera is null ? null : throw new BadInputException(
                $"{path}: '{Selector[1..]}' chooses from a file with several cameras, as Kalibr and COLMAP write them. Leave it out.");
        }

        IReadOnlyList<NamedCamera> cameras = read(text, path);
        string list = string.Join(", ", cameras.Select(one => one.Name));
        return (camera, cameras) switch
        {
            (null, [var only]) => only.Camera().Entries(),
            (null, { Count: 0 }) => throw new BadInputException($"{path}: this file of {name} has no camera."),
            (null, _) => throw new BadInputException(
                $"{path}: this file of {name} has several cameras: {list}. Choose one: --camera '{path}{Selector}{cameras[0].Name}'."),
            _ => (cameras.FirstOrDefault(one => one.Name == camera)
                ?? throw new BadInputException($"{path}: there is no camera '{camera}'; there are {list}.")).Camera().Entries(),
        };
    }

    /// <summary>The lines with something in them, without comments that begin with '#'.</summary>
    internal static IEnumerable<(string Text, int Line)> Lines(string text) => text.Split('\n')
        .Select((line, index) => (line.Split('#')[0].Trim(), index + 1)).Where(line => line.Item1.Length > 0);

    /// <summary>Whether a text has a key in a line of its own.</summary>
    internal static bool HasKey(string text, string pattern) =>
        Regex.IsMatch(text, $@"(?m)^[ \t]*(?:{pattern})[ \t]*:", RegexOptions.NonBacktracking);
}

/// <summary>A camera of a file.</summary>
/// <param name="Name">By which it is chosen.</param>
/// <param name="Camera">Reads it.</param>
internal sealed record NamedCamera(string Name, Func<ImportedCamera> Camera);
