using System.Globalization;
using Msisf.Core.Tiles;

namespace Msisf.Cli.Run;

/// <summary>Prints which tiles a frame takes and which it leaves out, and why.</summary>
internal static class PatternList
{
    /// <summary>One line a tile: step, tile, taken or not, reason; separated by tabs.</summary>
    public static void Print(IReadOnlyList<Frame> frames, ElevationModel model, TextWriter results)
    {
        foreach (Frame frame in frames)
        {
            foreach (TileVerdict verdict in model.Explain(frame))
            {
                results.WriteLine(string.Create(
                    CultureInfo.InvariantCulture,
                    $"{frame.Step}\t{verdict.Tile.RangeText}\t{(verdict.IsTaken ? "taken" : "left out")}\t{verdict.Reason}"));
            }
        }
    }
}
