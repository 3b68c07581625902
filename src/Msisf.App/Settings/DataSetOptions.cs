using Msisf.App.Settings.Specs;

namespace Msisf.App.Settings;

/// <summary>The command that makes data sets.</summary>
internal static class DataSetOptions
{
    public static CommandSpec Command { get; } = new("dataset", "Make a data set of images at random states, with truth, index and card.")
    {
        Details =
            "The file says how many images there are, how their states are distributed, and which options they are drawn with "
                + "(docs/data-sets.md). Called again, it makes what is missing. With --pieces or --frames-per-piece it runs on Slurm.",
        MakeArgument = () => new ArgumentSpec("FILE", "The data set's file, YAML"),
        Examples =
        [
            ("A data set:", "msis dataset craters.yaml --output-dir craters"),
            ("Its 17th image again, to the byte:", "msis dataset craters.yaml --frames 17 --output-dir again"),
        ],
        MakeGroups = () =>
        [
            new OptionGroup("Output", [OutputOptions.Folder]), RunOptions.Group,
            SlurmOptions.Group with
            {
                Options = [CutOptions.Pieces, CutOptions.FramesPerPiece, ScriptOptions.Wait, .. SlurmOptions.Group.Options],
            },
            new OptionGroup("General", [RunOptions.Help]),
        ],
    };

    /// <summary>Reads whether the data set is made on Slurm, and checks the options of that.</summary>
    /// <exception cref="UsageException">A value is wrong, or an option of Slurm is of no use.</exception>
    public static bool ReadIsOnSlurm(OptionValues values)
    {
        SlurmOptions.Read(values);
        if (values.IsGiven(CutOptions.Pieces) || values.IsGiven(CutOptions.FramesPerPiece))
        {
            CutOptions.Read(values);
            return true;
        }

        values.Refuse(
            SlurmOptions.Group.Options.Append(ScriptOptions.Wait), $"is for Slurm only. Add {CutOptions.Pieces.Name}, or leave it out.");
        return false;
    }
}
