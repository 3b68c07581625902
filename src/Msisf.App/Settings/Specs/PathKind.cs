namespace Msisf.App.Settings.Specs;

/// <summary>What a path leads to.</summary>
internal enum PathKind
{
    /// <summary>A file.</summary>
    File,

    /// <summary>A folder.</summary>
    Folder,

    /// <summary>A file or a folder.</summary>
    Any,
}
