using Msisf.Adapters.IO;

namespace Msisf.Adapters.Manifest;

/// <summary>
/// The manifest of an output folder: JSON Lines to which any number of threads, processes and nodes append. A line is written completely or
/// not at all. Safe for several threads.
/// </summary>
public sealed class ManifestFile
{
    /// <summary>Its name, in the folder of the outputs.</summary>
    public const string Name = "msisf-manifest.jsonl";

    private const string LockName = ".msisf-manifest.lock";

    /// <summary>
    /// The longest wait for the lock. A live process holds it for milliseconds, and the system frees that of a dead one: after so long, a
    /// process that holds it must be stopped.
    /// </summary>
    private static readonly TimeSpan LongestWait = TimeSpan.FromMinutes(2);

    private readonly Lock _queueGate = new();
    private readonly Lock _writeGate = new();
    private readonly string _lockPath;
    private List<Line> _queue = [];

    /// <summary>Names the manifest of a folder; the file is made with its first line.</summary>
    /// <param name="folder">The folder of the outputs.</param>
    public ManifestFile(string folder)
    {
        FilePath = Path.Combine(folder, Name);
        _lockPath = Path.Combine(folder, LockName);
    }

    /// <summary>The file.</summary>
    public string FilePath { get; }

    /// <summary>Appends lines, all or none. Lines that threads append while others wait for the lock are written together.</summary>
    /// <exception cref="ExternalPartException">The file system refuses, or another process keeps the lock.</exception>
    public void Append(params IEnumerable<ManifestRecord> records)
    {
        Line line = new([.. records.SelectMany(ManifestLine.Write)]);
        lock (_queueGate)
        {
            _queue.Add(line);
        }

        lock (_writeGate)
        {
            if (!line.IsDone)
            {
                List<Line> together;
                lock (_queueGate)
                {
                    (together, _queue) = (_queue, []);
                }

                Write(together);
            }
        }

        if (line.Error is not null)
        {
            throw new ExternalPartException(line.Error.Message, line.Error);
        }
    }

    /// <summary>Works on the file while no other process does.</summary>
    /// <typeparam name="T">Type of the result.</typeparam>
    /// <param name="work">What is done.</param>
    /// <exception cref="ExternalPartException">The file system refuses, or another process keeps the lock.</exception>
    public T Locked<T>(Func<T> work) => FileErrors.ToExternalPart($"{FilePath}: can't be written", () =>
    {
        using FileStream held = TakeLock();
        return work();
    });

    /// <summary>Appends lines. Within <see cref="Locked"/> only.</summary>
    public void AppendLocked(IEnumerable<ManifestRecord> records) => AppendBytes([.. records.SelectMany(ManifestLine.Write)]);

    /// <summary>Replaces the file by one with these lines. Within <see cref="Locked"/> only.</summary>
    /// <param name="folder">Where the new file is until it is whole: see <see cref="AtomicFileSet"/>.</param>
    public void Replace(IEnumerable<ManifestRecord> records, string folder)
    {
        using AtomicFileSet files = new(folder);
        files.Write(FilePath, stream =>
        {
            foreach (ManifestRecord record in records)
            {
                stream.Write(ManifestLine.Write(record));
            }
        });
        files.Commit();
    }

    private void Write(List<Line> lines)
    {
        ExternalPartException? error = null;
        try
        {
            Locked(() =>
            {
                AppendBytes([.. lines.SelectMany(line => line.Bytes)]);
                return true;
            });
        }
        catch (ExternalPartException exception)
        {
            error = exception;
        }

        foreach (Line line in lines)
        {
            (line.IsDone, line.Error) = (true, error);
        }
    }

    private void AppendBytes(byte[] bytes)
    {
        using FileStream stream = new(
            FilePath, FileMode.OpenOrCreate, FileAccess.ReadWrite, FileShare.ReadWrite | FileShare.Delete, bufferSize: 0);
        long end = EndOfWholeLines(stream);
        stream.SetLength(end); // what a process that was killed, or a full disk, left of a line
        stream.Position = end;
        try
        {
            stream.Write(bytes);
        }
        catch (IOException)
        {
            stream.SetLength(end);
            throw;
        }
    }

    private static long EndOfWholeLines(FileStream stream)
    {
        long end = stream.Length;
        Span<byte> last = stackalloc byte[1];
        while (end > 0)
        {
            stream.Position = end - 1;
            if (stream.Read(last) != 1 || last[0] == (byte)'\n')
            {
                break;
            }

            end--;
        }

        return end;
    }

    private FileStream TakeLock()
    {
        long start = System.Diagnostics.Stopwatch.GetTimestamp();
        while (true)
        {
            try
            {
                return new FileStream(_lockPath, FileMode.OpenOrCreate, FileAccess.ReadWrite, FileShare.None, bufferSize: 0);
            }
            catch (IOException exception) when (FileLock.IsHeldByAnother(exception))
            {
                if (System.Diagnostics.Stopwatch.GetElapsedTime(start) > LongestWait)
                {
                    throw new ExternalPartException(
                        $"{_lockPath}: another process keeps the lock, for minutes now. End it if it is stopped, and try again.",
                        exception);
                }

                Thread.Sleep(1);
            }
        }
    }

    private sealed class Line(byte[] bytes)
    {
        public byte[] Bytes { get; } = bytes;

        public bool IsDone { get; set; }

        public ExternalPartException? Error { get; set; }
    }
}
