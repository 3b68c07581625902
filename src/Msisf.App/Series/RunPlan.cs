using System.Runtime.InteropServices;
using System.Security.Cryptography;
using System.Text;
using Msisf.Adapters.Manifest;
using Msisf.App.Settings;
using Msisf.Core.Scene;

namespace Msisf.App.Series;

/// <summary>The frames of a whole run, including those that this call does not make. Immutable.</summary>
internal sealed class RunPlan
{
    private readonly IReadOnlyList<SpacecraftState> _states;
    private readonly IReadOnlyList<string> _names;

    public RunPlan(IReadOnlyList<SpacecraftState> states, IReadOnlyList<string> names, RunIdentity identity)
    {
        _states = states;
        _names = names;
        Identity = identity;
        Key = KeyOfAll();
    }

    public RunIdentity Identity { get; }

    /// <summary>Key of the run in the manifest.</summary>
    public string Key { get; }

    /// <summary>The key of a frame and its settings in the manifest.</summary>
    /// <param name="step">Number of the step, from 1.</param>
    public string FrameKey(int step) =>
        RunIdentity.KeyOf(
            [.. Encoding.ASCII.GetBytes(Identity.Record.Key), .. BytesOf(_states[step - 1])]);

    /// <summary>The manifest's record of a frame that the run should make.</summary>
    /// <param name="step">Number of the step, from 1.</param>
    public ExpectedRecord Expected(int step) => new(Key, step, _names[step - 1], FrameKey(step));

    /// <summary>The manifest's records of all frames that the run should make, in the order of their steps.</summary>
    public IEnumerable<ExpectedRecord> Frames => Enumerable.Range(1, _states.Count).Select(Expected);

    /// <summary>The arguments that describe one frame, for its metadata.</summary>
    /// <param name="step">Number of the step, from 1.</param>
    public string ArgumentsOf(int step) => FrameArguments.Of(_states[step - 1], Identity.Arguments);

    /// <summary>
    /// The records to add to a manifest for this run; empty if the manifest contains the run and no later run expects other frames of the
    /// same names.
    /// </summary>
    /// <param name="known">Content of the manifest.</param>
    public IReadOnlyList<ManifestRecord> Registration(ManifestContent known)
    {
        if (_names.All(name => known.Expected.TryGetValue(name, out ExpectedRecord? expected) && expected.Run == Key))
        {
            return [];
        }

        ManifestRecord[] settings = known.Settings.ContainsKey(Identity.Record.Key) ? [] : [Identity.Record];
        return [.. settings, new RunRecord(Key, Identity.Record.Key, _states.Count), .. Frames];
    }

    private static byte[] BytesOf(in SpacecraftState state) =>
    [
        .. MemoryMarshal.AsBytes<double>(state.ToNumbers()),
        .. state.Flow is { } flow ? MemoryMarshal.AsBytes<double>(flow.ToNumbers()) : [],
        .. state.ExposureFactor is { } factor ? MemoryMarshal.AsBytes<double>([factor]) : [],
        .. state.Path is { States.Count: > 1 } path ? Encoding.ASCII.GetBytes(path.Digest()) : [],
        .. state.Noise is { } noise ? MemoryMarshal.AsBytes<ulong>([noise.Number, noise.Step]) : [],
    ];

    private string KeyOfAll()
    {
        using IncrementalHash hash = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);
        hash.AppendData(Encoding.ASCII.GetBytes(Identity.Record.Key));
        for (int index = 0; index < _states.Count; index++)
        {
            hash.AppendData(BytesOf(_states[index]));
            hash.AppendData(Encoding.UTF8.GetBytes(_names[index] + "\n"));
        }

        return RunIdentity.KeyOf(hash.GetHashAndReset());
    }
}
