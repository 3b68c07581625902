namespace Msisf.Server;

/// <summary>A part of an answer.</summary>
/// <param name="Name">Name of a file with it, e.g. "depth.npy".</param>
/// <param name="ContentType">Its content type.</param>
/// <param name="Content">Its bytes; empty if they are sent as they are made.</param>
/// <param name="Headers">Further headers.</param>
internal sealed record AnswerPart(string Name, string ContentType, MemoryStream Content, IReadOnlyList<(string Name, string Value)> Headers)
{
    /// <summary>bytes: its length; null if that is not known before it is sent.</summary>
    public required long? Length { get; init; }

    /// <summary>The bytes.</summary>
    public ReadOnlyMemory<byte> Bytes => Content.GetBuffer().AsMemory(0, (int)Content.Length);
}
