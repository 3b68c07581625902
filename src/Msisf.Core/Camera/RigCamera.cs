namespace Msisf.Core.Camera;

/// <summary>A camera of a rig.</summary>
/// <param name="Name">Its name, of which the rig has no other.</param>
/// <param name="Mounting">How it sits on the body.</param>
public sealed record MountedCamera(string Name, Mounting Mounting)
{
    /// <summary>What a name may be, for messages.</summary>
    public const string Names = "1 to 40 letters, digits, '-' and '_' are possible, as it stands in names of files";

    private const int LongestName = 40;

    /// <summary>Whether a text can be a camera's name.</summary>
    public static bool IsName(string text) =>
        text.Length is > 0 and <= LongestName && text.All(letter => char.IsAsciiLetterOrDigit(letter) || letter is '-' or '_');
}

/// <summary>One of several cameras on a body (docs/rigs.md). Immutable.</summary>
/// <param name="Cameras">All of them.</param>
/// <param name="Index">Which one it is, from 0.</param>
public sealed record RigCamera(IReadOnlyList<MountedCamera> Cameras, int Index)
{
    /// <summary>Its name.</summary>
    public string Name => Cameras[Index].Name;

    /// <summary>How it sits on the body.</summary>
    public Mounting Mounting => Cameras[Index].Mounting;
}
