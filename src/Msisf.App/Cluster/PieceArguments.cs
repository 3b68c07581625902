using Msisf.Adapters.Ephemeris;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Errors;

namespace Msisf.App.Cluster;

/// <summary>The options of the pieces' calls: those of the whole run, also where they come from a file of arguments or settings.</summary>
internal sealed class PieceArguments
{
    private readonly OptionValues _values;

    /// <summary>Takes the run's options.</summary>
    /// <param name="values">The options.</param>
    /// <param name="endsWithCheck">Whether the script looks at all frames of the run in the end.</param>
    /// <exception cref="UsageException">There is one that pieces can't have.</exception>
    public PieceArguments(OptionValues values, bool endsWithCheck)
    {
        _values = values;
        Refuse(PovOptions.ListPatterns, "prints and makes no frame; the pieces are there to make them");
        Refuse(RunOptions.FrameTimes, "names one file, and all pieces would write it");
        if (endsWithCheck)
        {
            Refuse(
                RunOptions.Frames,
                "makes a part of the run, and this script looks at all of it in the end; what is there and complete is not made again");
        }

        Refuse(RunOptions.Overwrite, "would make all frames again each time a piece is run again; remove the outputs in place of it");
    }

    /// <summary>Of each piece's call, but for <c>--frames</c>.</summary>
    /// <param name="batchFile">The states.</param>
    /// <param name="engine">
    /// The ephemeris engine that this computer takes, null for none: a node that would take another one would give the Sun other last
    /// digits.
    /// </param>
    public IReadOnlyList<string> OfPiece(string batchFile, EphemerisChoice? engine) =>
    [
        .. WordsOf(CameraOptions.BatchFile, batchFile),
        .. CommandTable.OptionsOfRun.Except(
            [.. CameraOptions.Group.Options, RunOptions.Frames, LightOptions.Ephemeris, RunOptions.Config]).SelectMany(Words),
        .. Engine(engine),
    ];

    /// <summary>Of the call of <c>msis patterns</c> that makes what all pieces need.</summary>
    /// <param name="batchFile">The states.</param>
    /// <param name="engine">As for the pieces.</param>
    public IReadOnlyList<string> OfPatterns(string batchFile, EphemerisChoice? engine) =>
    [
        PatternsOptions.ForBatch.Name, batchFile,
        .. PatternsOptions.Deciding.SelectMany(Words),
        .. Engine(engine),
    ];

    private void Refuse(OptionSpec option, string why)
    {
        if (Words(option).Length > 0)
        {
            throw new UsageException($"{option.Name} {why}. Leave it out.").About(option);
        }
    }

    private static string[] Engine(EphemerisChoice? engine) =>
        engine is { } choice ? WordsOf(LightOptions.Ephemeris, LightOptions.Ephemeris.WordOf(choice)) : [];

    private string[] Words(OptionSpec option)
    {
        if (option is FlagSpec flag)
        {
            return flag.Read(_values) ? [flag.Name] : [];
        }

        return _values.Text(option) is { } text ? WordsOf(option, text) : [];
    }

    /// <summary>One word, so that a value may begin with "-" or "@"; but an empty one is a word of its own.</summary>
    private static string[] WordsOf(OptionSpec option, string value) =>
        value.Length > 0 ? [$"{option.Name}={value}"] : [option.Name, value];
}
