using System.CommandLine;
using Msisf.Adapters.Ephemeris;
using Msisf.Cli.Options;
using Msisf.Core.Errors;

namespace Msisf.Cli.Pieces;

/// <summary>The options of the pieces' calls: those of the whole run, also where they come from a file of arguments or settings.</summary>
internal sealed class PieceArguments
{
    private readonly ParseResult _line;
    private readonly RenderOptions _options;

    /// <summary>Takes the run's line.</summary>
    /// <param name="line">The line.</param>
    /// <param name="options">The run's options.</param>
    /// <param name="endsWithCheck">Whether the script looks at all frames of the run in the end.</param>
    /// <exception cref="UsageException">It has an option that pieces can't have.</exception>
    public PieceArguments(ParseResult line, RenderOptions options, bool endsWithCheck)
    {
        _line = line;
        _options = options;
        Refuse(options.Run.ListPatterns, "prints and makes no frame; the pieces are there to make them");
        Refuse(options.Run.FrameTimes, "names one file, and all pieces would write it");
        if (endsWithCheck)
        {
            Refuse(
                options.Run.Frames,
                "makes a part of the run, and this script looks at all of it in the end; what is there and right is not made again");
        }

        Refuse(options.Run.Overwrite, "would make all frames again each time a piece is run again; remove the outputs in place of it");
    }

    /// <summary>Of each piece's call, but for <c>--frames</c>.</summary>
    /// <param name="batchFile">The states.</param>
    /// <param name="engine">
    /// The ephemeris engine that this computer takes, null for none: a node that would take another one would give the Sun other last
    /// digits.
    /// </param>
    public IReadOnlyList<string> OfPiece(string batchFile, EphemerisChoice? engine) =>
    [
        .. WordsOf(_options.Mode.BatchFile, batchFile),
        .. _options.All.Except([.. _options.Mode.All, _options.Run.Frames, _options.Run.Ephemeris]).SelectMany(Words),
        .. Engine(engine),
    ];

    /// <summary>Of the call of <c>msis patterns</c> that makes what all pieces need.</summary>
    /// <param name="batchFile">The states.</param>
    /// <param name="engine">As for the pieces.</param>
    public IReadOnlyList<string> OfPatterns(string batchFile, EphemerisChoice? engine)
    {
        ImageOptions image = _options.Image;
        Option[] deciding =
        [
            image.FieldOfView, image.Width, image.Height, image.LevelOfDetail, image.LevelOfDetailError, image.IgnoreSun,
            .. _options.Source.All, _options.Run.Aberration, _options.Run.Kernels,
        ];
        return ["--for-batch", batchFile, .. deciding.SelectMany(Words), .. Engine(engine)];
    }

    private void Refuse(Option option, string why)
    {
        if (Words(option).Length > 0)
        {
            throw new UsageException($"{option.Name} {why}. Leave it out.");
        }
    }

    private string[] Engine(EphemerisChoice? engine) =>
        engine is EphemerisChoice choice ? WordsOf(_options.Run.Ephemeris, choice == EphemerisChoice.CSpice ? "cspice" : "builtin") : [];

    private string[] Words(Option option) => option switch
    {
        Option<bool> flag => _line.GetValue(flag) ? [flag.Name] : [],
        Option<string?> value => _line.GetValue(value) is string text ? WordsOf(value, text) : [],
        _ => throw new ArgumentException($"{option.Name} has no single value.", nameof(option)),
    };

    /// <summary>One word, so that a value may begin with "-" or "@"; but an empty one is a word of its own.</summary>
    private static string[] WordsOf(Option option, string value) => value.Length > 0 ? [$"{option.Name}={value}"] : [option.Name, value];
}
