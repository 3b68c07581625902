using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Settings;
using Msisf.Core.Tiles.Selection;

namespace Msisf.App.Rendering;

/// <summary>Lists the tiles that the frames of a run use or leave out, with reasons.</summary>
internal static class PatternList
{
    /// <summary>Prints one line for each tile of each frame: step, tile, taken or not, reason; separated by tabs.</summary>
    /// <param name="trajectory">The positions of the camera.</param>
    /// <param name="settings">The run's other settings.</param>
    /// <param name="cancellation">Cancels the work between two frames.</param>
    /// <exception cref="MsisfException">The run can't be made.</exception>
    public static void Print(TrajectorySettings trajectory, RenderSettings settings, ProgramHost host, CancellationToken cancellation)
    {
        using EphemerisSource ephemeris = new(settings, host);
        using PreparedRun run = PreparedRun.Of(trajectory, [settings], ephemeris, host, cancellation);
        foreach (Frame frame in run.Frames)
        {
            cancellation.ThrowIfCancellationRequested();
            foreach (TileChoice choice in run.Model.Select(frame).All)
            {
                host.Results.WriteLine(Invariant(
                    $"{frame.Step}\t{choice.Tile.RangeText}\t{(choice.IsKept ? "taken" : "left out")}\t{choice.ReasonText}"));
            }
        }
    }
}
