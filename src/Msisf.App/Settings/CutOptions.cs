using Msisf.App.Settings.Specs;
using Msisf.Core.Errors;

namespace Msisf.App.Settings;

/// <summary>The options that say into which pieces a run is cut.</summary>
internal static class CutOptions
{
    /// <summary>How many pieces.</summary>
    public static WholeNumberSpec Pieces { get; } = new(
        "--pieces", "N", 1, int.MaxValue, "Cut the run into so many pieces")
    {
        IsOfOneCall = true,
    };

    /// <summary>How large they are.</summary>
    public static WholeNumberSpec FramesPerPiece { get; } = new(
        "--frames-per-piece", "N", 1, int.MaxValue, "Cut the run into pieces of so many images")
    {
        IsOfOneCall = true,
    };

    /// <summary>Reads and checks them.</summary>
    /// <exception cref="MsisfException">None of the two, both, or one that is no number.</exception>
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
