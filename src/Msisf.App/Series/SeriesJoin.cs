using Msisf.Adapters.IO;
using Msisf.Adapters.Manifest;
using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;

namespace Msisf.App.Series;

/// <summary>
/// Copies the finished frames of several folders into one, with their records: results of several machines, each with its own manifest.
/// </summary>
internal sealed class SeriesJoin
{
    private readonly string _target;
    private readonly ManifestFile _manifest;
    private readonly ProgramHost _host;
    private readonly JoinedFolder[] _folders;
    private readonly ManifestContent _known;

    private SeriesJoin(IReadOnlyList<string> sources, string target, ProgramHost host)
    {
        (_target, _manifest, _host) = (target, new ManifestFile(target), host);
        _folders = [.. sources.Select(source => new JoinedFolder(source, SeriesManifest.Read(source, host.Log)))];
        using ManifestReader reader = new(_manifest);
        reader.Refresh();
        _known = reader.Content;
    }

    /// <summary>Copies what is complete; nothing is written if folders contradict each other.</summary>
    /// <param name="sources">Folders of outputs.</param>
    /// <param name="target">The folder to copy to; it may hold frames already.</param>
    /// <exception cref="MsisfException">A folder has no run, two have different frames of one name, or a file can't be written.</exception>
    public static void Run(IReadOnlyList<string> sources, string target, ProgramHost host, CancellationToken cancellation)
    {
        if (sources.FirstOrDefault(source => Path.GetFullPath(source) == Path.GetFullPath(target)) is { } same)
        {
            throw new UsageException($"{FolderOptions.To.Name} {target}: is {same} itself. Give another folder.").About(FolderOptions.To);
        }

        SeriesJoin join = new(sources, target, host);
        join.RefuseContradictions();
        join.Copy(cancellation);
    }

    private void RefuseContradictions()
    {
        Dictionary<string, (string Folder, string Frame)> expected = [];
        Dictionary<string, (string Folder, OutputFile File)> files = [];
        foreach (JoinedFolder folder in (JoinedFolder[])[new(_target, _known), .. _folders])
        {
            foreach (ExpectedRecord frame in folder.Content.Expected.Values)
            {
                (string Folder, string Frame) first = expected.GetValueOrDefault(frame.Name, (folder.Path, frame.Frame));
                if (first.Frame != frame.Frame)
                {
                    throw new BadInputException(
                        $"{first.Folder} and {folder.Path} have different frames of the name {frame.Name}: of other settings, or of "
                            + "another state. Make one of the runs again with another --output-name.");
                }

                expected[frame.Name] = first;
            }

            foreach (OutputFile file in folder.CompleteFrames.SelectMany(frame => frame.Files).Concat(folder.Content.Shared.Values))
            {
                (string Folder, OutputFile File) first = files.GetValueOrDefault(file.Name, (folder.Path, file));
                if (first.File != file)
                {
                    throw new BadInputException(
                        $"{first.Folder} and {folder.Path} have different files of the name {file.Name}. Join only parts of one run, made "
                            + "by one version of msis.");
                }

                files[file.Name] = first;
            }
        }

        HashSet<string> recorded =
            [.. _known.Frames.Values.SelectMany(frame => frame.Files).Select(file => file.Name), .. _known.Shared.Keys];
        if (files.Keys.FirstOrDefault(name => !recorded.Contains(name) && File.Exists(Path.Combine(_target, name))) is { } stray)
        {
            throw new UsageException(
                $"{Path.Combine(_target, stray)}: is there, and no record in that folder names it. Give another folder.")
                .About(FolderOptions.To);
        }
    }

    private void Copy(CancellationToken cancellation) => FolderOptions.To.NamedInErrors(() => FileErrors.ToExternalPart(
        $"{_target}: can't be written", () =>
        {
            Directory.CreateDirectory(_target);
            WorkFolder.RemoveStale(_target);
            using WorkFolder work = WorkFolder.In(_target);
            HashSet<string> there = [.. new JoinedFolder(_target, _known).CompleteFrames.Select(frame => frame.Name)];
            int copied = 0;
            foreach (JoinedFolder folder in _folders)
            {
                _manifest.Append(folder.Content.InOrder().Where(record => record is SettingsRecord or RunRecord or ExpectedRecord));
                foreach (FrameRecord frame in folder.CompleteFrames.Where(frame => there.Add(frame.Name)))
                {
                    cancellation.ThrowIfCancellationRequested();
                    CopyFiles(folder.Path, frame.Files, frame, work.Path);
                    copied++;
                }

                foreach (OutputFile shared in folder.Content.Shared.Values.Where(file => folder.Checker.ProblemWith(file) is null))
                {
                    CopyFiles(folder.Path, [shared], new SharedFileRecord(shared), work.Path);
                }
            }

            _host.Log.Note(Invariant($"{copied} frames copied to {_target}."));
        }));

    /// <summary>Copies files, and records them before they get their names, so that no file is there without its record.</summary>
    private void CopyFiles(string folder, IReadOnlyList<OutputFile> names, ManifestRecord record, string work)
    {
        using AtomicFileSet files = new(work);
        foreach (OutputFile file in names)
        {
            string path = Path.Combine(_target, file.Name);
            files.Write(path, stream =>
            {
                using FileStream source = File.OpenRead(Path.Combine(folder, file.Name));
                source.CopyTo(stream);
            });
            if (files.Measure(path) != (file.Bytes, file.Sha256))
            {
                throw new BadInputException(
                    $"{Path.Combine(folder, file.Name)}: is not as it was written. msis verify {folder} says more.");
            }
        }

        _manifest.Append(record);
        files.Commit();
    }

    /// <summary>A folder whose frames are joined.</summary>
    private sealed class JoinedFolder(string path, ManifestContent content)
    {
        public string Path { get; } = path;

        public ManifestContent Content { get; } = content;

        public FrameChecker Checker { get; } = new(path, CheckDepth.Lengths);

        /// <summary>Frames that are there as a run of the folder expects them, in the order of their steps.</summary>
        public IEnumerable<FrameRecord> CompleteFrames => Content.Expected.Values
            .OrderBy(expected => expected.Step)
            .Where(expected =>
                Checker.Check(expected, Content.Frames.GetValueOrDefault(expected.Name), null).State == FrameState.Complete)
            .Select(expected => Content.Frames[expected.Name]);
    }
}
