namespace Msisf.Core.Metadata;

/// <summary>A file that a frame was made from: another content of it could give other outputs.</summary>
/// <param name="Kind">What it is.</param>
/// <param name="Name">Its name without folders, so that a frame is the same wherever its inputs lie.</param>
/// <param name="Bytes">Its length.</param>
/// <param name="Sha256">SHA-256 of its content: 64 hexadecimal digits in small letters.</param>
public sealed record InputFile(InputKind Kind, string Name, long Bytes, string Sha256)
{
    /// <summary>
    /// Whether the SHA-256 is that of the file's length and of pieces spread over it, because to read all of it takes minutes.
    /// </summary>
    public bool IsOfPieces { get; init; }
}
