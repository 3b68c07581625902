using Msisf.App.Settings.Specs;

namespace Msisf.App.Settings;

/// <summary>The options of a script that makes a run in pieces.</summary>
internal static class ScriptOptions
{
    public static ChoiceSpec<ScriptFormat> Format { get; } = new(
        "--format", OptionRole.HowItRuns,
        [
            new Choice("sh", ScriptFormat.Sh),
            new Choice("bat", ScriptFormat.Bat),
            new Choice("parallel", ScriptFormat.Parallel),
            new Choice("slurm", ScriptFormat.Slurm),
        ],
        "What runs the pieces: a shell or Windows's cmd one after another, GNU parallel, or Slurm")
    {
        IsRequired = true,
    };

    public static PathSpec Script { get; } = new("--script", OptionRole.HowItRuns, PathKind.File, "The script")
    {
        IsOfOneCall = true,
        DefaultNote = "./msis-pieces with the format's ending",
    };

    /// <summary>File name of the script of msis submit, in the folder of the outputs.</summary>
    public static string SlurmScriptName { get; } = NameOf(ScriptFormat.Slurm);

    public static FlagSpec Wait { get; } = new(
        "--wait", OptionRole.WhatIsPrinted, "Tell the progress, and end with the exit code of the whole")
    {
        IsOfOneCall = true,
    };

    /// <summary>Reads the format, and rejects options of Slurm with any other format.</summary>
    /// <exception cref="MsisfException">An option is wrong, or forbidden.</exception>
    public static ScriptFormat ReadFormat(OptionValues values)
    {
        ScriptFormat format = Format.Read(values);
        values.Refuse(
            format == ScriptFormat.Slurm ? [] : SlurmOptions.Group.Options, "is for --format slurm only. Choose that, or leave it out.");
        return format;
    }

    /// <summary>Reads the path of the script.</summary>
    /// <exception cref="BadInputException">The path is empty.</exception>
    public static string ReadPath(OptionValues values) => Script.ReadIfGiven(values) ?? NameOf(Format.Read(values));

    private static string NameOf(ScriptFormat format) => format switch
    {
        ScriptFormat.Sh => "msis-pieces.sh",
        ScriptFormat.Bat => "msis-pieces.bat",
        ScriptFormat.Parallel => "msis-pieces.parallel.sh",
        _ => "msis-pieces.slurm.sh",
    };
}

/// <summary>The format of a script: which program runs the pieces of a run.</summary>
internal enum ScriptFormat
{
    /// <summary>A POSIX shell, one after another.</summary>
    Sh,

    /// <summary>Windows's cmd, one after another.</summary>
    Bat,

    /// <summary>GNU parallel, several at once.</summary>
    Parallel,

    /// <summary>Slurm, as a job array.</summary>
    Slurm,
}

/// <summary>The options that define how a run is cut into pieces.</summary>
internal static class CutOptions
{
    public static WholeNumberSpec Pieces { get; } = new(
        "--pieces", OptionRole.HowItRuns, "N", 1, int.MaxValue, "Cut the run into so many pieces")
    {
        IsOfOneCall = true,
    };

    public static WholeNumberSpec FramesPerPiece { get; } = new(
        "--frames-per-piece", OptionRole.HowItRuns, "N", 1, int.MaxValue, "Cut the run into pieces of so many images")
    {
        IsOfOneCall = true,
    };

    /// <summary>Reads and checks the options.</summary>
    /// <exception cref="MsisfException">Neither or both options are given, or a value is not a number.</exception>
    public static CutSettings Read(OptionValues values)
    {
        bool hasPieces = values.IsGiven(Pieces);
        return hasPieces != values.IsGiven(FramesPerPiece)
            ? new CutSettings(Pieces.ReadIfGiven(values), FramesPerPiece.ReadIfGiven(values))
            : throw new UsageException(hasPieces
                ? "--pieces and --frames-per-piece exclude each other. Give one of them."
                : "nothing says how the run is cut. Give --pieces or --frames-per-piece.");
    }
}

/// <summary>How a run is cut into pieces.</summary>
/// <param name="Pieces">Number of pieces; null if the number of frames is given.</param>
/// <param name="FramesPerPiece">Frames of each piece except the last; null if the number of pieces is given.</param>
internal sealed record CutSettings(int? Pieces, int? FramesPerPiece);
