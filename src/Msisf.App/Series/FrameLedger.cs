using Msisf.Adapters.IO;
using Msisf.Adapters.Manifest;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Products;

namespace Msisf.App.Series;

/// <summary>
/// The record of a run's frames: finds frames that are complete, claims frames against other processes, and writes to the manifest.
/// Thread-safe.
/// </summary>
internal sealed class FrameLedger : IDisposable
{
    private const string ClaimsName = ".msisf-claims";

    private readonly Lock _gate = new();
    private readonly string _folder;
    private readonly RunPlan _plan;
    private readonly ManifestFile _manifest;
    private readonly ManifestReader _reader;
    private readonly FrameChecker _checker;
    private readonly ClaimFile _claims;
    private readonly WorkFolder _staging;
    private readonly Lazy<IReadOnlyDictionary<string, string>> _owners;

    /// <summary>Opens the manifest of a folder, and registers the run there if it is new.</summary>
    /// <param name="folder">Existing folder of the outputs.</param>
    /// <param name="overwrite">Whether existing frames are to be made again.</param>
    /// <param name="log">Receives a warning about lines of the manifest that can't be read, and a note on a frame to replace.</param>
    /// <exception cref="UsageException">
    /// Finished frames of a series, or files that no run has recorded, would be replaced, without <paramref name="overwrite"/>.
    /// </exception>
    public FrameLedger(string folder, RunPlan plan, bool overwrite, ILog log)
    {
        _folder = folder;
        _plan = plan;
        _manifest = new ManifestFile(folder);
        _checker = new FrameChecker(folder, CheckDepth.Checksums);
        _reader = new ManifestReader(_manifest);
        Register(overwrite, log);
        if (overwrite)
        {
            _reader.Dispose();
            _reader = new ManifestReader(_manifest, onlyNew: true);
        }

        _staging = Stage(folder);
        _claims = ClaimFile.Open(Path.Combine(folder, ClaimsName)); // after what may fail: it stays open until it is disposed of
        _owners = new Lazy<IReadOnlyDictionary<string, string>>(Owners);
    }

    /// <summary>Which frames seem to be there and complete, by the lengths of their files; nothing is written.</summary>
    /// <param name="folder">Folder of the outputs; it may be missing.</param>
    /// <param name="overwrite">Whether existing frames are to be made again.</param>
    /// <returns>In the order of the frames.</returns>
    public static bool[] AreThere(string folder, RunPlan plan, IReadOnlyList<Frame> frames, bool overwrite)
    {
        ManifestFile manifest = new(folder);
        if (overwrite || !File.Exists(manifest.FilePath))
        {
            return new bool[frames.Count];
        }

        using ManifestReader reader = new(manifest);
        reader.Refresh();
        FrameChecker checker = new(folder, CheckDepth.Lengths);
        return [.. frames.Select(frame => checker.Check(
            plan.Expected(frame.Step, frame.CameraIndex), reader.Content.Frames.GetValueOrDefault(frame.Name), null).State
                == FrameState.Complete)];
    }

    /// <summary>Folder of files that are not yet complete.</summary>
    public string Staging => _staging.Path;

    public RunPlan Plan => _plan;

    /// <summary>The current state of a frame, including work of other processes since the last call.</summary>
    public FrameCheck Check(Frame frame)
    {
        FrameRecord? made;
        FailedRecord? failed;
        lock (_gate)
        {
            _reader.Refresh();
            made = _reader.Content.Frames.GetValueOrDefault(frame.Name);
            failed = _reader.Content.Failed.GetValueOrDefault(frame.Name);
        }

        return _checker.Check(_plan.Expected(frame.Step, frame.CameraIndex), made, failed);
    }

    /// <summary>The paths of a complete frame's files, in the order in which they are shown to the user.</summary>
    public IReadOnlyList<string> PathsOf(Frame frame)
    {
        lock (_gate)
        {
            return [.. _reader.Content.Frames[frame.Name].Files.Select(file => Path.Combine(_folder, file.Name))];
        }
    }

    /// <summary>Claims a frame, so that no other process makes it; does not wait.</summary>
    /// <returns>The claim, released by disposal; null if another process has claimed the frame.</returns>
    public IDisposable? TryClaim(Frame frame) => _claims.TryTake(frame.Name);

    /// <summary>
    /// Records a frame's files in the manifest before they get their final names, so that no file exists without its record. Files of an
    /// earlier frame of this name that the new one does not replace are removed.
    /// </summary>
    /// <param name="files">The frame's files, written but not yet renamed to their final names.</param>
    /// <param name="paths">The paths of the files, in the order in which they are shown to the user.</param>
    public void Made(Frame frame, AtomicFileSet files, IReadOnlyList<string> paths)
    {
        IEnumerable<OutputFile> made = paths.Select(path =>
        {
            (long bytes, string hash) = files.Measure(path);
            return new OutputFile(Path.GetFileName(path), bytes, hash);
        });
        FrameRecord record = new(
            frame.Step, frame.Name, _plan.FrameKey(frame.Step, frame.CameraIndex), _plan.IdentityOf(frame.CameraIndex).Record.Key,
            [.. made]);
        _manifest.Append(record);
        RemoveOthers(record);
    }

    /// <summary>Records in the manifest that a frame could not be made.</summary>
    public void Failed(Frame frame, string cause) =>
        _manifest.Append(new FailedRecord(frame.Step, frame.Name, _plan.FrameKey(frame.Step, frame.CameraIndex), cause));

    public void Dispose()
    {
        _staging.Dispose();
        _claims.Dispose();
        _reader.Dispose();
    }

    private static WorkFolder Stage(string folder) =>
        FileErrors.ToExternalPart($"--output-dir {folder}: can't be written", () => WorkFolder.In(folder));

    /// <summary>Removes files that have the name of a file of the frame, but are not among those that were made now.</summary>
    private void RemoveOthers(FrameRecord made)
    {
        foreach (string name in ProductTable.NamesOf(made.Name).Except(made.Files.Select(file => file.Name)))
        {
            string path = Path.Combine(_folder, name);
            if (File.Exists(path) && (!_owners.Value.TryGetValue(name, out string? owner) || owner == made.Name))
            {
                FileErrors.ToExternalPart($"{path}: can't be removed", () => File.Delete(path));
            }
        }
    }

    /// <summary>The frame of each file that the manifest names: "a.annotated.png" may be the image of a frame "a.annotated".</summary>
    private Dictionary<string, string> Owners()
    {
        using ManifestReader all = new(_manifest);
        all.Refresh();
        return all.Content.Frames.Values
            .SelectMany(frame => frame.Files.Select(file => (File: file.Name, Frame: frame.Name)))
            .ToLookup(pair => pair.File, pair => pair.Frame)
            .ToDictionary(group => group.Key, group => group.Last());
    }

    private void Register(bool overwrite, ILog log)
    {
        _reader.Refresh();
        if (_reader.Content.DamagedLines > 0)
        {
            log.Warning(
                $"{_manifest.FilePath}: {_reader.Content.DamagedLines} lines can't be read and are left out; "
                    + $"frames whose lines they were are made again.");
        }

        if (_plan.Registration(_reader.Content).Count > 0)
        {
            if (!overwrite)
            {
                ReplacedFrames.Refuse(_folder, _plan, _reader.Content, log);
            }

            _manifest.Locked(() =>
            {
                _reader.Refresh(); // another process may have told it meanwhile, and made frames of it
                IReadOnlyList<ManifestRecord> news = _plan.Registration(_reader.Content);
                if (news.Count > 0 && !overwrite)
                {
                    ReplacedFrames.RefuseUnrecorded(_folder, _plan, _reader.Content);
                }

                _manifest.AppendLocked(news);
                return true;
            });
        }
    }
}
