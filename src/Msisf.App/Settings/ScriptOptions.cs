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
        return format == ScriptFormat.Slurm || SlurmOptions.Group.Options.FirstOrDefault(values.IsGiven) is not { } wrong
            ? format
            : throw new UsageException($"{wrong.Name} is for --format slurm only. Choose that, or leave it out.").About(wrong);
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
