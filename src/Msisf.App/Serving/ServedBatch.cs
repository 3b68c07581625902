using Msisf.Adapters.Camera;
using Msisf.Adapters.Ccsds;
using Msisf.Adapters.Ephemeris;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Settings;
using Msisf.Core.Attitude;
using Msisf.Core.Scene;

namespace Msisf.App.Serving;

/// <summary>The states of a batch file or of a trajectory (OEM), for the viewer's time line.</summary>
internal static class ServedBatch
{
    /// <summary>Frames of a trajectory, which has states at all times.</summary>
    private const double MostFrames = 1000.0;

    private const double LeastStep = 1.0; // s

    /// <summary>Reads the states as a run does; named columns may need the terrain.</summary>
    /// <param name="requested">Options, and the model whose terrain it is.</param>
    /// <param name="ephemeris">Where the Sun is, for cameras that are pointed by it.</param>
    /// <exception cref="MsisfException">The file is wrong.</exception>
    public static IReadOnlyList<ServedFrame> Frames(
        string path, RequestedFrame requested, ServedEphemeris ephemeris, ProgramHost host, CancellationToken cancellation)
    {
        RunGeometry geometry = new(
            () => requested.Model.Opened, () => ephemeris.Of(requested.Settings).Engine(), requested.Settings.Aberration);
        StateReader reader = new(() => ephemeris.Of(requested.Settings).Engine(), geometry, host)
        {
            Kernels = () => ephemeris.Of(requested.Settings).Kernels(),
        };
        TrajectorySettings trajectory = IsOem(path)
            ? OfOem(path, () => ephemeris.Of(requested.Settings).Kernels(), geometry)
            : new BatchFileSettings(path, CameraOptions.BatchFile);
        return [.. reader.Read(trajectory, cancellation).Select(
            (state, index) => new ServedFrame(
                index + 1, state with { Motion = null }, new Dictionary<string, string>(), new Dictionary<string, string>()))];
    }

    private static bool IsOem(string path) => FileErrors.ToBadInput($"{path}: can't be read", () =>
    {
        using FileStream stream = File.OpenRead(path);
        return CcsdsFile.IsOem(stream);
    });

    /// <summary>Evenly over the file's cover, the nadir in the middle.</summary>
    private static MissionSettings OfOem(string path, Func<OpenedEphemeris> kernels, RunGeometry geometry)
    {
        MissionSettings settings = new(new OemPosition(path), new PointedChoice(new CameraPointing()), Times: null, LeastStep);
        double seconds = MissionPath.Open(settings, kernels(), geometry, _ => { }).Path.Cover.Intervals.Sum(
            interval => interval.End - interval.Start);
        return settings with { Every = Math.Max(LeastStep, seconds / MostFrames) };
    }
}

/// <summary>A frame on the viewer's time line.</summary>
/// <param name="Number">From 1.</param>
/// <param name="State">Where and when.</param>
/// <param name="Options">Its other options as a request has them, by their names without dashes.</param>
/// <param name="Files">Paths of its stored files by kind: image, annotated, meta; none for a line of a batch file.</param>
/// <param name="Camera">The camera that its options name; null if they name none, or one that was not found.</param>
internal sealed record ServedFrame(
    int Number, SpacecraftState State, IReadOnlyDictionary<string, string> Options, IReadOnlyDictionary<string, string> Files,
    CameraFile? Camera = null);
