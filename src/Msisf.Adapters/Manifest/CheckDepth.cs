namespace Msisf.Adapters.Manifest;

/// <summary>How closely a frame's files are looked at.</summary>
public enum CheckDepth
{
    /// <summary>That they are there, with their lengths.</summary>
    Lengths,

    /// <summary>Their content too, by its checksum.</summary>
    Checksums,
}
