using System.CommandLine;
using Msisf.App.Cluster;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Settings;
using Msisf.Cli.Options;
using Msisf.Core.Errors;
using Msisf.Core.Render;
using Msisf.Core.Scene;

namespace Msisf.Cli.Pieces;

/// <summary>
/// Checks a run as the render command does, down to the cameras: what a piece would refuse is refused before there is a script.
/// </summary>
internal static class RunPlanner
{
    /// <summary>Reads and checks all of a run.</summary>
    /// <param name="line">The run's options, and those of the command.</param>
    /// <param name="options">The run's options.</param>
    /// <param name="host">The world.</param>
    /// <param name="cancellation">Ends it.</param>
    /// <exception cref="MsisfException">The run could not be made.</exception>
    public static PlannedRun Plan(ParseResult line, RenderOptions options, ProgramHost host, CancellationToken cancellation)
    {
        (Mode? given, RenderSettings settings) = options.Read(line);
        Mode mode = given ?? throw new UsageException(
            $"nothing says where the camera is. Give exactly one of {ModeRules.ModeNames(options.Mode)}.");
        if (mode == Mode.BatchFile && line.GetValue(options.Mode.BatchFile) == "-")
        {
            throw new UsageException("--batch-file -: standard input can't be read again by each piece. Save it to a file, and give that.");
        }

        using EphemerisSource ephemeris = new(settings, host);
        IReadOnlyList<SpacecraftState> states = new StateSource(
            options.Mode, line, ephemeris.Engine, host.StandardInput, host.Log).Read(mode, cancellation);
        IReadOnlyList<string> names = new FrameNaming(settings.OutputName).NamesOf([.. states.Select(state => state.Time)]);
        Frame[] frames = FramePlanner.Plan(states, names, settings, ephemeris.Engine, cancellation);
        ElevationModel model = ElevationModel.Open(
            settings.Ldem, settings.PixelsPerDegree, isSparing: settings.Renderer == RendererKind.PovRay, host);
        try
        {
            FramePlanner.RefuseCamerasInTheGround(frames, model, cancellation);
            return new PlannedRun(mode, settings, ephemeris.Opened?.Choice, states, frames, model);
        }
        catch (MsisfException)
        {
            model.Dispose();
            throw;
        }
    }
}
