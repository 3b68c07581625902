using System.CommandLine;
using Msisf.App.Settings;
using Msisf.Core.Errors;

namespace Msisf.Cli.Options;

/// <summary>Into which pieces a run is cut.</summary>
internal sealed class CutOptions
{
    public Option<string?> Pieces { get; } = OptionFactory.Value("--pieces", [], "N", "Cut the run into so many pieces");

    public Option<string?> FramesPerPiece { get; } = OptionFactory.Value(
        "--frames-per-piece", [], "N", "Cut the run into pieces of so many frames");

    public IEnumerable<Option> All => [Pieces, FramesPerPiece];

    /// <summary>Reads and checks them.</summary>
    /// <exception cref="MsisfException">None of the two numbers, both, or one that is none.</exception>
    public CutSettings Read(ParseResult line)
    {
        string? pieces = line.GetValue(Pieces);
        string? frames = line.GetValue(FramesPerPiece);
        if (pieces is null == frames is null)
        {
            throw new UsageException(pieces is null
                ? "nothing says how the run is cut. Give --pieces or --frames-per-piece."
                : "--pieces and --frames-per-piece exclude each other. Give one of them.");
        }

        return new CutSettings(
            pieces is null ? null : OptionText.WholeNumber(Pieces, pieces, 1, int.MaxValue),
            frames is null ? null : OptionText.WholeNumber(FramesPerPiece, frames, 1, int.MaxValue));
    }
}
