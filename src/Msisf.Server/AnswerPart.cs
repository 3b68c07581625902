namespace Msisf.Server;

/// <summary>A part of an answer.</summary>
/// <param name="Name">Name of a file with it, e.g. "depth.npy".</param>
/// <param name="ContentType">Its content type.</param>
/// <param name="Content">Its bytes.</param>
/// <param name="Headers">Further headers.</param>
internal sealed record AnswerPart(string Name, string ContentType, MemoryStream Content, IReadOnlyList<(string Name, string Value)> Headers)
{
    /// <summary>The bytes.</summary>
    public ReadOnlyMemory<byte> Bytes => Content.GetBuffer().AsMemory(0, (int)Content.Length);
}
