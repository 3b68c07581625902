using System.CommandLine;
using Msisf.Cli.Options;
using Msisf.Core.Errors;

namespace Msisf.Cli.Pieces;

/// <summary>The options of the pieces' calls: those of the whole run, also where they come from a file of arguments or settings.</summary>
internal sealed class PieceArguments
{
    private readonly ParseResult _line;
    private readonly RenderOptions _options;

    /// <summary>Takes the run's line.</summary>
    /// <exception cref="UsageException">It has an option that pieces can't have.</exception>
    public PieceArguments(ParseResult line, RenderOptions options)
    {
        _line = line;
        _options = options;
        Refuse(options.Run.ListPatterns, "prints and makes no frame; the pieces are there to make them");
        Refuse(options.Run.FrameTimes, "names one file, and all pieces would write it");
        Refuse(options.Run.Overwrite, "would make all frames again each time a piece is run again; remove the outputs in place of it");
    }

    /// <summary>Of each piece's call, but for <c>--frames</c>.</summary>
    /// <param name="batchFile">The states.</param>
    public IReadOnlyList<string> OfPiece(string batchFile) =>
        [.. WordsOf(_options.Mode.BatchFile, batchFile), .. _options.All.Except([.. _options.Mode.All, _options.Run.Frames]).SelectMany(Words)];

    /// <summary>Of the call of <c>msis patterns</c> that makes what all pieces need.</summary>
    /// <param name="batchFile">The states.</param>
    public IReadOnlyList<string> OfPatterns(string batchFile)
    {
        PictureOptions picture = _options.Picture;
        Option[] deciding =
        [
            picture.FieldOfView, picture.Width, picture.Height, picture.LevelOfDetail, picture.LevelOfDetailError, picture.IgnoreSun,
            .. _options.Source.All, _options.Run.Ephemeris, _options.Run.Aberration, _options.Run.Kernels, _options.Run.Frames,
        ];
        return ["--for-batch", batchFile, .. deciding.SelectMany(Words)];
    }

    private void Refuse(Option option, string why)
    {
        if (_line.GetResult(option) is { Implicit: false })
        {
            throw new UsageException($"{option.Name} {why}. Leave it out.");
        }
    }

    private string[] Words(Option option) => option switch
    {
        Option<bool> flag => _line.GetValue(flag) ? [flag.Name] : [],
        Option<string?> value => _line.GetValue(value) is string text ? WordsOf(value, text) : [],
        _ => throw new ArgumentException($"{option.Name} has no single value.", nameof(option)),
    };

    /// <summary>One word, so that a value may begin with "-" or "@"; but an empty one is a word of its own.</summary>
    private static string[] WordsOf(Option option, string value) => value.Length > 0 ? [$"{option.Name}={value}"] : [option.Name, value];
}
