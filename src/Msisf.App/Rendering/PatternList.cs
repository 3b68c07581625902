using System.Globalization;
using Msisf.App.Preparation;
using Msisf.Core.Tiles;

namespace Msisf.App.Rendering;

/// <summary>Prints which tiles a frame takes and which it leaves out, and why.</summary>
internal static class PatternList
{
    /// <summary>One line a tile: step, tile, taken or not, reason; separated by tabs.</summary>
    public static void Print(IReadOnlyList<Frame> frames, ElevationModel model, TextWriter results, CancellationToken cancellation)
    {
        foreach (Frame frame in frames)
        {
            cancellation.ThrowIfCancellationRequested();
            foreach (TileChoice choice in model.Select(frame).All)
            {
                results.WriteLine(string.Create(
                    CultureInfo.InvariantCulture,
                    $"{frame.Step}\t{choice.Tile.RangeText}\t{(choice.IsKept ? "taken" : "left out")}\t{choice.ReasonText}"));
            }
        }
    }
}
