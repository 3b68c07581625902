using System.Security.Cryptography;
using Msisf.Adapters.Input;
using Msisf.Core.Camera;
using Msisf.Core.Metadata;

namespace Msisf.Adapters.Camera;

/// <summary>What a rig file says (docs/cameras.md): several cameras on one body.</summary>
/// <param name="Path">Where it is.</param>
/// <param name="Cameras">The cameras, at least one, in the order of the file.</param>
/// <param name="Input">The file as one of those that an image is made from.</param>
public sealed record RigFile(string Path, IReadOnlyList<RigFileCamera> Cameras, InputFile Input)
{
    private const string CamerasKey = "cameras";
    private const string QuaternionKey = "quaternion";
    private const string OffsetKey = "offset";

    /// <summary>Reads a file.</summary>
    /// <param name="options">The keys that a camera may have beside its mounting.</param>
    /// <param name="isRounded">Whether its quaternions may be rounded to a few decimals.</param>
    /// <exception cref="BadInputException">There is no such file, or what is wrong in it, by file, line and column.</exception>
    public static RigFile Read(string path, IReadOnlyList<string> options, bool isRounded)
    {
        byte[] content = FileErrors.ToBadInput($"{path}: the rig file can't be read", () => File.ReadAllBytes(path));
        using MemoryStream stream = new(content);
        SettingsSection file = new(path, "a rig", (1, 1), ConfigFileReader.Read(stream, path, levels: 2), [CamerasKey]);
        IReadOnlyList<(string Name, SettingsSection Section)> sections =
            file.Sections(CamerasKey, "a camera of a rig", [.. options, QuaternionKey, OffsetKey])
            ?? throw file.Missing(CamerasKey, "below it the name of each camera, and below that its keys");
        HashSet<string> names = new(StringComparer.OrdinalIgnoreCase);
        if (sections.FirstOrDefault(camera => !names.Add(camera.Name)) is { Name: { } same } second)
        {
            throw second.Section.Here($"'{same}' differs from another name in its capitals only, and files would differ so. Rename one");
        }

        return new RigFile(
            path,
            sections.Count > 0
                ? [.. sections.Select(camera => CameraOf(camera.Name, camera.Section, options, isRounded))]
                : throw file.Wrong(CamerasKey, "the rig has no camera. Add the name of one below 'cameras', and its keys below that"),
            new InputFile(
                InputKind.Rig, System.IO.Path.GetFileName(path), content.Length, Convert.ToHexStringLower(SHA256.HashData(content))));
    }

    private static RigFileCamera CameraOf(string name, SettingsSection section, IReadOnlyList<string> options, bool isRounded)
    {
        if (!MountedCamera.IsName(name))
        {
            throw section.Here($"{NumberText.Shown(name)} is not a name of a camera: {MountedCamera.Names}");
        }

        double[] turn = section.Numbers(QuaternionKey, 4, 4)
            ?? throw section.Missing(QuaternionKey, "how the camera is turned: body from camera, the scalar last");
        double[] offset = section.Numbers(OffsetKey, 3, 3) ?? [0.0, 0.0, 0.0];
        try
        {
            return new RigFileCamera(
                new MountedCamera(name, Mounting.Of(turn, offset, isRounded)),
                [.. options.Where(section.Has).Select(key => KeyValuePair.Create(key, section.Text(key)!))]);
        }
        catch (BadInputException wrong)
        {
            throw section.Wrong(QuaternionKey, wrong.Message.TrimEnd('.'));
        }
    }
}

/// <summary>A camera of a rig file.</summary>
/// <param name="Mounted">Its name and mounting.</param>
/// <param name="Options">Its other keys with their texts.</param>
public sealed record RigFileCamera(MountedCamera Mounted, IReadOnlyList<KeyValuePair<string, string>> Options);
