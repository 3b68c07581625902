namespace Msisf.Adapters.Manifest;

/// <summary>One file of a finished frame.</summary>
/// <param name="Name">Without folder.</param>
/// <param name="Bytes">Its length.</param>
/// <param name="Sha256">SHA-256 of its content, 64 hexadecimal digits in small letters.</param>
public sealed record OutputFile(string Name, long Bytes, string Sha256);
