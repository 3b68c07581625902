using Msisf.Adapters.IO;

namespace Msisf.Adapters.Manifest;

/// <summary>
/// Checks frames: what is to be there, what the manifest says was made, and what lies in the folder. Safe for several threads.
/// </summary>
public sealed class FrameChecker
{
    private readonly string _folder;
    private readonly CheckDepth _depth;
    private readonly FileStructure? _structure;

    /// <summary>Takes the folder.</summary>
    /// <param name="folder">Folder of the outputs.</param>
    /// <param name="depth">How closely to look.</param>
    /// <param name="structure">Looks into files, too, if it is given.</param>
    public FrameChecker(string folder, CheckDepth depth, FileStructure? structure = null)
    {
        _folder = folder;
        _depth = depth;
        _structure = structure;
    }

    /// <summary>Checks a frame.</summary>
    /// <param name="expected">What is to be there.</param>
    /// <param name="made">What was made last under its name; null for nothing.</param>
    /// <param name="failed">What failed since; null for nothing.</param>
    public FrameCheck Check(ExpectedRecord expected, FrameRecord? made, FailedRecord? failed)
    {
        (FrameState state, string reason) = made is null ? (FrameState.Missing, "not made yet") : CheckFiles(made, expected);
        return state != FrameState.Complete && failed is not null && failed.Frame == expected.Frame
            ? new FrameCheck(expected, FrameState.Failed, failed.Cause)
            : new FrameCheck(expected, state, reason);
    }

    private (FrameState State, string Reason) CheckFiles(FrameRecord record, ExpectedRecord expected)
    {
        FileInfo[] there = [.. record.Files.Select(file => Target(new FileInfo(Path.Combine(_folder, file.Name))))];
        if (Array.TrueForAll(there, file => !file.Exists))
        {
            return (FrameState.Missing, "its files are gone");
        }

        if (record.Frame != expected.Frame)
        {
            return (FrameState.OtherSettings, "made with other settings, or from another state");
        }

        return record.Files.Zip(there, Problem).FirstOrDefault(problem => problem is not null) is { } found
            ? (FrameState.Damaged, found)
            : (FrameState.Complete, string.Empty);
    }

    /// <summary>What is wrong with a file that belongs to all frames; null if nothing is.</summary>
    /// <param name="shared">As it was written.</param>
    public string? ProblemWith(OutputFile shared) => Problem(shared, Target(new FileInfo(Path.Combine(_folder, shared.Name))));

    private string? Problem(OutputFile made, FileInfo file)
    {
        try
        {
            return ProblemWith(made, file) is { } problem ? $"{made.Name}: {problem}" : null;
        }
        catch (Exception exception) when (exception.IsFileError())
        {
            return $"{made.Name}: can't be read: {exception.Message}";
        }
    }

    /// <summary>The file itself, where outputs were moved and links left in their place.</summary>
    private static FileInfo Target(FileInfo file) =>
        file.LinkTarget is null ? file : file.ResolveLinkTarget(returnFinalTarget: true) as FileInfo ?? file;

    private string? ProblemWith(OutputFile made, FileInfo file)
    {
        if (!file.Exists)
        {
            return "missing";
        }

        if (file.Length != made.Bytes)
        {
            return Invariant($"{file.Length} bytes long, {made.Bytes} were written");
        }

        bool isSame = _depth == CheckDepth.Lengths || FileHash.Sha256Of(file.FullName) == made.Sha256;
        return _structure?.ProblemWith(file.FullName) ?? (isSame ? null : "its checksum is not that of the file that was written");
    }
}

/// <summary>The result of checking a frame.</summary>
/// <param name="Reason">Why, in words; empty if it is complete.</param>
public sealed record FrameCheck(ExpectedRecord Expected, FrameState State, string Reason);

/// <summary>The state of a frame that a run expects.</summary>
public enum FrameState
{
    /// <summary>The files are as they were made.</summary>
    Complete,

    /// <summary>The files do not exist.</summary>
    Missing,

    /// <summary>The files are not as they were made.</summary>
    Damaged,

    /// <summary>The files belong to other settings or another state of the spacecraft.</summary>
    OtherSettings,

    /// <summary>The frame could not be made.</summary>
    Failed,
}

/// <summary>What of a frame's files is checked.</summary>
public enum CheckDepth
{
    /// <summary>That they exist, with their lengths.</summary>
    Lengths,

    /// <summary>Their content too, by its checksum.</summary>
    Checksums,
}
