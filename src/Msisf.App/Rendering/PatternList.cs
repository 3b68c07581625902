using System.Globalization;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Settings;
using Msisf.Core.Errors;
using Msisf.Core.Tiles;

namespace Msisf.App.Rendering;

/// <summary>Says which tiles the frames of a run take and which they leave out, and why.</summary>
internal static class PatternList
{
    /// <summary>Prints one line a tile of each frame: step, tile, taken or not, reason; separated by tabs.</summary>
    /// <param name="camera">Where the camera is.</param>
    /// <param name="settings">The run's other settings.</param>
    /// <param name="host">The world.</param>
    /// <param name="cancellation">Stops between two frames.</param>
    /// <exception cref="MsisfException">The run could not be made.</exception>
    public static void Print(CameraSettings camera, RenderSettings settings, ProgramHost host, CancellationToken cancellation)
    {
        using EphemerisSource ephemeris = new(settings, host);
        using PreparedRun run = PreparedRun.Of(camera, settings, ephemeris, host, cancellation);
        foreach (Frame frame in run.Frames)
        {
            cancellation.ThrowIfCancellationRequested();
            foreach (TileChoice choice in run.Model.Select(frame).All)
            {
                host.Results.WriteLine(string.Create(
                    CultureInfo.InvariantCulture,
                    $"{frame.Step}\t{choice.Tile.RangeText}\t{(choice.IsKept ? "taken" : "left out")}\t{choice.ReasonText}"));
            }
        }
    }
}
