using Msisf.Adapters.IO;
using Msisf.Adapters.Manifest;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.Core.Errors;

namespace Msisf.App.Series;

/// <summary>
/// What a run knows of its frames: which are there and complete, which one another process is making, and what the manifest is told.
/// Safe for several threads.
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

    /// <summary>Opens what the folder has; tells the manifest of the run if it does not know it.</summary>
    /// <param name="folder">Existing folder of the outputs.</param>
    /// <param name="plan">The run.</param>
    /// <param name="overwrite">What is there does not count.</param>
    /// <param name="log">Gets a warning of lines that can't be read.</param>
    public FrameLedger(string folder, RunPlan plan, bool overwrite, ILog log)
    {
        _folder = folder;
        _plan = plan;
        _manifest = new ManifestFile(folder);
        _checker = new FrameChecker(folder, CheckDepth.Checksums);
        _reader = new ManifestReader(_manifest);
        Register(log);
        if (overwrite)
        {
            _reader.Dispose();
            _reader = new ManifestReader(_manifest, onlyNew: true);
        }

        _claims = ClaimFile.Open(Path.Combine(folder, ClaimsName));
        _staging = Stage(folder);
    }

    /// <summary>Where files are until they are complete.</summary>
    public string Staging => _staging.Path;

    /// <summary>The run.</summary>
    public RunPlan Plan => _plan;

    /// <summary>The state of a frame by now; also what another process made since the last call counts.</summary>
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

        return _checker.Check(_plan.Expected(frame.Step), made, failed);
    }

    /// <summary>The files of a frame that is complete, in the order in which they are named to the user.</summary>
    public IReadOnlyList<string> PathsOf(Frame frame)
    {
        lock (_gate)
        {
            return [.. _reader.Content.Frames[frame.Name].Files.Select(file => Path.Combine(_folder, file.Name))];
        }
    }

    /// <summary>Claims a frame against other processes; does not wait.</summary>
    /// <returns>Null if another one is making it.</returns>
    public IDisposable? TryClaim(Frame frame) => _claims.TryTake(frame.Name);

    /// <summary>Tells the manifest what a frame's files are, before they get their names: no file is ever there without its line.</summary>
    /// <param name="frame">The frame.</param>
    /// <param name="files">Its files, written and not yet committed.</param>
    /// <param name="paths">Their names, in the order in which they are named to the user.</param>
    public void Made(Frame frame, AtomicFileSet files, IReadOnlyList<string> paths)
    {
        IEnumerable<OutputFile> made = paths.Select(path =>
        {
            (long bytes, string hash) = files.Measure(path);
            return new OutputFile(Path.GetFileName(path), bytes, hash);
        });
        _manifest.Append(new FrameRecord(frame.Step, frame.Name, _plan.FrameKey(frame.Step), _plan.Identity.Record.Key, [.. made]));
    }

    /// <summary>Tells the manifest that a frame could not be made.</summary>
    public void Failed(Frame frame, string cause) =>
        _manifest.Append(new FailedRecord(frame.Step, frame.Name, _plan.FrameKey(frame.Step), cause));

    public void Dispose()
    {
        _staging.Dispose();
        _claims.Dispose();
        _reader.Dispose();
    }

    private static WorkFolder Stage(string folder) =>
        FileErrors.ToExternalPart($"--output-dir {folder}: can't be written", () => WorkFolder.In(folder));

    private void Register(ILog log)
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
            _manifest.Locked(() =>
            {
                _reader.Refresh(); // another process may have told it meanwhile
                _manifest.AppendLocked(_plan.Registration(_reader.Content));
                return true;
            });
        }
    }
}
