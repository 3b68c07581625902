using Msisf.Adapters.Manifest;
using Msisf.App.Settings;
using Msisf.Core.Scene;
using Msisf.Core.Time;
using System.Runtime.InteropServices;
using System.Security.Cryptography;
using System.Text;

namespace Msisf.App.Series;

/// <summary>The frames of a whole run, including those that this call does not make. Immutable.</summary>
internal sealed class RunPlan
{
    private readonly IReadOnlyList<PlannedCamera> _cameras;

    /// <param name="cameras">What is planned for each camera of the rig, or for the only one.</param>
    public RunPlan(IReadOnlyList<PlannedCamera> cameras)
    {
        _cameras = cameras;
        Key = KeyOfAll();
    }

    /// <summary>Key of the run in the manifest.</summary>
    public string Key { get; }

    public string Version => _cameras[0].Identity.Version;

    /// <summary>What decides the frames of a camera.</summary>
    /// <param name="camera">From 0.</param>
    public RunIdentity IdentityOf(int camera) => _cameras[camera].Identity;

    /// <summary>The key of a frame and its settings in the manifest.</summary>
    /// <param name="step">Number of the step, from 1.</param>
    /// <param name="camera">From 0.</param>
    public string FrameKey(int step, int camera = 0) => _cameras[camera].FrameKey(step);

    /// <inheritdoc cref="FrameKey"/>
    public ExpectedRecord Expected(int step, int camera = 0) => Expected(_cameras[camera], step);

    /// <summary>The manifest's records of all frames that the run should make, in the order of their steps, with the settings of
    /// each.</summary>
    public IEnumerable<(ExpectedRecord Frame, SettingsRecord Settings)> Frames =>
        from step in Enumerable.Range(1, _cameras[0].States.Count)
        from camera in _cameras
        select (Expected(camera, step), camera.Identity.Record);

    /// <summary>The arguments that describe one frame, for its metadata.</summary>
    /// <inheritdoc cref="FrameKey"/>
    public string ArgumentsOf(int step, int camera = 0) =>
        FrameArguments.Of(_cameras[camera].States[step - 1], _cameras[camera].Identity.Arguments);

    /// <summary>
    /// The records to add to a manifest for this run; empty if the manifest contains the run and no later run expects other frames of the
    /// same names.
    /// </summary>
    public IReadOnlyList<ManifestRecord> Registration(ManifestContent known)
    {
        ExpectedRecord[] frames = [.. Frames.Select(planned => planned.Frame)];
        if (frames.All(frame => known.Expected.TryGetValue(frame.Name, out ExpectedRecord? expected) && expected.Run == Key))
        {
            return [];
        }

        IEnumerable<SettingsRecord> settings = _cameras.Select(camera => camera.Identity.Record).DistinctBy(record => record.Key);
        return
        [
            .. settings.Where(record => !known.Settings.ContainsKey(record.Key)),
            new RunRecord(Key, _cameras[0].Identity.Record.Key, frames.Length), .. frames,
        ];
    }

    private ExpectedRecord Expected(PlannedCamera camera, int step) => new(Key, step, camera.Names[step - 1], camera.FrameKey(step));

    private string KeyOfAll()
    {
        using IncrementalHash hash = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);
        foreach (PlannedCamera camera in _cameras)
        {
            camera.AppendTo(hash);
        }

        return RunIdentity.KeyOf(hash.GetHashAndReset());
    }
}

/// <summary>The frames of one camera of a run.</summary>
/// <param name="States">The states of all its frames, in the order of the input.</param>
/// <param name="Identity">What decides them beside their states.</param>
internal sealed record PlannedCamera(IReadOnlyList<SpacecraftState> States, IReadOnlyList<string> Names, RunIdentity Identity)
{
    /// <summary>The key of a frame and its settings.</summary>
    /// <param name="step">Number of the step, from 1.</param>
    public string FrameKey(int step) =>
        RunIdentity.KeyOf([.. Encoding.ASCII.GetBytes(Identity.Record.Key), .. BytesOf(States[step - 1])]);

    /// <summary>Adds all that tells the camera's frames from others.</summary>
    public void AppendTo(IncrementalHash hash)
    {
        hash.AppendData(Encoding.ASCII.GetBytes(Identity.Record.Key));
        for (int index = 0; index < States.Count; index++)
        {
            hash.AppendData(BytesOf(States[index]));
            hash.AppendData(Encoding.UTF8.GetBytes(Names[index] + "\n"));
        }
    }

    private static byte[] BytesOf(Instant time, double[] numbers) =>
        [.. Encoding.ASCII.GetBytes(time.Utc.ToExactText()), .. MemoryMarshal.AsBytes<double>(numbers.AsSpan(1))];

    private static byte[] BytesOf(in SpacecraftState state) =>
    [
        .. BytesOf(state.Time, state.ToNumbers()),
        .. state.Flow is { } flow ? BytesOf(flow.Time, flow.ToNumbers()) : [],
        .. state.ExposureFactor is { } factor ? MemoryMarshal.AsBytes<double>([factor]) : [],
        .. state.Path is { States.Count: > 1 } path ? Encoding.ASCII.GetBytes(path.Digest()) : [],
        .. state.Noise is { } noise ? MemoryMarshal.AsBytes<ulong>([noise.Number, noise.Step]) : [],
    ];
}
