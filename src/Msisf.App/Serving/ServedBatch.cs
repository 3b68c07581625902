using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Settings;
using Msisf.Core.Errors;

namespace Msisf.App.Serving;

/// <summary>The states of a batch file, for the viewer's time line.</summary>
internal static class ServedBatch
{
    /// <summary>Reads the states as a run does; named columns may need the terrain.</summary>
    /// <param name="path">The file.</param>
    /// <param name="requested">Options, and the model whose terrain it is.</param>
    /// <param name="ephemeris">Where the Sun is, for cameras that are pointed by it.</param>
    /// <param name="host">Output, log, clock and environment of the program.</param>
    /// <param name="cancellation">Stops the work.</param>
    /// <exception cref="MsisfException">The file is wrong.</exception>
    public static IReadOnlyList<ServedFrame> Frames(
        string path, RequestedFrame requested, ServedEphemeris ephemeris, ProgramHost host, CancellationToken cancellation)
    {
        RunGeometry geometry = new(
            () => requested.Model.Opened, () => ephemeris.Of(requested.Settings).Engine(), requested.Settings.Aberration);
        StateReader reader = new(() => ephemeris.Of(requested.Settings).Engine(), geometry, host);
        return [.. reader.Read(new BatchFileSettings(path, CameraOptions.BatchFile), cancellation).Select(
            (state, index) => new ServedFrame(
                index + 1, state with { Motion = null }, new Dictionary<string, string>(), new Dictionary<string, string>()))];
    }
}
