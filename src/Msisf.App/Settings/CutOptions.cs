using Msisf.App.Settings.Specs;

namespace Msisf.App.Settings;

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
    /// <exception cref="MsisfException">Neither or both options are given, or a value is no number.</exception>
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
