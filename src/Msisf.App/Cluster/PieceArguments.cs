using Msisf.Adapters.Ephemeris;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Ephemeris;

namespace Msisf.App.Cluster;

/// <summary>
/// The options of the calls that make the pieces: the options of the whole run, including those from response and configuration files.
/// </summary>
internal sealed class PieceArguments
{
    private readonly OptionValues _values;

    /// <summary>Collects the options of the run.</summary>
    /// <param name="endsWithCheck">Whether the script checks all frames of the run at its end.</param>
    /// <exception cref="UsageException">An option can't be used in pieces.</exception>
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

        if (MissionOptions.OfGround.Read(values) != Aberration.None)
        {
            string why = $"with {MissionOptions.OfGround.Name} needs the velocity of the camera, which the states of pieces do not have";
            foreach (OptionSpec drawn in SkyOptions.Drawn)
            {
                Refuse(drawn, why);
            }
        }

        Refuse(RunOptions.Overwrite, "would make all frames again each time a piece is run again; remove the outputs in place of it");
    }

    /// <summary>Arguments of the call that makes a piece, except <c>--frames</c>.</summary>
    /// <param name="batchFile">File with the states of the run.</param>
    /// <param name="engine">
    /// The ephemeris engine that this computer uses; null for none. It is fixed because another engine changes the last digits of the Sun's
    /// position.
    /// </param>
    /// <param name="exposureTime">s: the exposure time of the run, so that no piece looks for it again; null for the camera file's.</param>
    /// <param name="exposure">The exposure that was found for the run; null for that of the options.</param>
    public IReadOnlyList<string> OfPiece(string batchFile, EphemerisChoice? engine, double? exposureTime, double? exposure) =>
    [
        .. WordsOf(CameraOptions.BatchFile, batchFile),
        .. CommandTable.OptionsOfRun.Except(
            [.. CameraOptions.Group.Options, RunOptions.Frames, LightOptions.Ephemeris, RunOptions.Config,
                NativeOptions.ExposureTime, .. exposure is null ? Array.Empty<OptionSpec>() : [NativeOptions.Exposure]])
            .SelectMany(Words),
        .. exposure is { } grey ? WordsOf(NativeOptions.Exposure, NumberSpec.TextOf(grey)) : [],
        .. Engine(engine),
        .. exposureTime is { } seconds ? WordsOf(NativeOptions.ExposureTime, NumberSpec.TextOf(seconds)) : [],
    ];

    /// <summary>Arguments of the call of <c>msis patterns</c> that makes the patterns of all pieces.</summary>
    /// <param name="batchFile">File with the states of the run.</param>
    /// <param name="engine">The ephemeris engine, as for the pieces.</param>
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
            throw option.Wrong($"{why}. Leave it out.");
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

        if (option.MayBeRepeated)
        {
            return [.. (_values.Words(option) ?? []).SelectMany(word => WordsOf(option, word))];
        }

        return _values.Text(option) is { } text ? WordsOf(option, text) : [];
    }

    /// <summary>
    /// An option with its value as one word, because the value may begin with "-" or "@"; an empty value is a separate word.
    /// </summary>
    private static string[] WordsOf(OptionSpec option, string value) =>
        value.Length > 0 ? [$"{option.Name}={value}"] : [option.Name, value];
}
