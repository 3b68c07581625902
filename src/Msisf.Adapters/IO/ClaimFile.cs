using System.Buffers.Binary;
using System.Collections.Concurrent;
using System.Security.Cryptography;
using System.Text;

namespace Msisf.Adapters.IO;

/// <summary>
/// Says which process works on what, so that several processes can share the work in one folder. A claim is a lock on one byte of a file
/// that stays empty; the byte follows from the name of what is claimed. The system releases the claims of a process that dies, over NFS
/// also those of a node. Where the file system (or .NET on macOS) has no such locks, every claim is granted: work is then done twice, with
/// the same bytes as result. Objects of one process on the same file exclude each other too, by whatever links
/// it is named. Safe for several threads.
/// </summary>
public sealed class ClaimFile : IDisposable
{
    private static readonly Dictionary<string, SharedLocks> OpenFiles = new(StringComparer.Ordinal);

    private readonly ConcurrentDictionary<long, bool> _own = new();
    private readonly SharedLocks _shared;
    private bool _isDisposed;

    private ClaimFile(SharedLocks shared) => _shared = shared;

    /// <summary>Opens the file, or creates it.</summary>
    /// <param name="path">
    /// In the folder of what is claimed. A folder that can't be written to has no claims but those within the process.
    /// </param>
    public static ClaimFile Open(string path)
    {
        string fullPath = RealPath.Of(path);
        lock (OpenFiles)
        {
            if (!OpenFiles.TryGetValue(fullPath, out SharedLocks? shared))
            {
                OpenFiles.Add(fullPath, shared = new SharedLocks(fullPath));
            }

            shared.Users++;
            shared.File ??= TryOpen(fullPath);
            return new ClaimFile(shared);
        }
    }

    /// <summary>Claims a name, without waiting.</summary>
    /// <param name="name">What is claimed, the same text in all processes.</param>
    /// <returns>Gives the claim back when disposed; null if another process or thread has it.</returns>
    public Claim? TryTake(string name)
    {
        ObjectDisposedException.ThrowIf(_isDisposed, this);
        long place = PlaceOf(name);
        if (_shared.TryTake(place) is not { } isExclusive)
        {
            return null;
        }

        _own.TryAdd(place, true);
        return new Claim(() => GiveBack(place), isExclusive);
    }

    /// <summary>Releases all claims that this object has granted.</summary>
    public void Dispose()
    {
        lock (OpenFiles)
        {
            if (_isDisposed)
            {
                return;
            }

            _isDisposed = true;
            foreach (long place in _own.Keys)
            {
                GiveBack(place);
            }

            if (--_shared.Users == 0)
            {
                OpenFiles.Remove(_shared.Path);
                _shared.File?.Dispose();
            }
        }
    }

    private static FileStream? TryOpen(string path)
    {
        try
        {
            // Sharing both ways takes no lock on the whole file over NFS, which would be in the way of the claims.
            return new FileStream(
                path, FileMode.OpenOrCreate, FileAccess.ReadWrite, FileShare.ReadWrite | FileShare.Delete, bufferSize: 0);
        }
        catch (Exception exception) when (exception.IsFileError())
        {
            return null;
        }
    }

    private static long PlaceOf(string name) =>
        BinaryPrimitives.ReadInt64LittleEndian(SHA256.HashData(Encoding.UTF8.GetBytes(name))) & (long.MaxValue >> 1);

    private void GiveBack(long place)
    {
        if (_own.TryRemove(place, out _))
        {
            _shared.GiveBack(place);
        }
    }

    /// <summary>
    /// One open file for all objects on a path: the system's locks belong to the process, which gets each lock that it has already, and
    /// loses them all when it closes one of its files of that path.
    /// </summary>
    private sealed class SharedLocks(string path)
    {
        private readonly ConcurrentDictionary<long, bool> _taken = new();

        public string Path { get; } = path;

        /// <summary>Null if the folder can't be written to.</summary>
        public FileStream? File { get; set; }

        /// <summary>Number of objects that share the file.</summary>
        public int Users { get; set; }

        /// <summary>Takes a place; tells whether the file system keeps other processes from it. Null if another has it.</summary>
        public bool? TryTake(long place)
        {
            if (!_taken.TryAdd(place, true))
            {
                return null;
            }

            try
            {
                if (File is null || OperatingSystem.IsMacOS())
                {
                    return false;
                }

                File.Lock(place, 1);
                return true;
            }
            catch (Exception exception) when (exception.IsFileError())
            {
                if (!FileLock.IsHeldByAnother(exception))
                {
                    return false; // this file system knows no locks
                }

                _taken.TryRemove(place, out _);
                return null;
            }
        }

        public void GiveBack(long place)
        {
            try
            {
                if (!OperatingSystem.IsMacOS())
                {
                    File?.Unlock(place, 1);
                }
            }
            catch (Exception exception) when (exception.IsFileError())
            {
                return; // there was no lock: the claim held within the process only
            }
            finally
            {
                _taken.TryRemove(place, out _);
            }
        }
    }
}

/// <summary>A claim that was granted by a <see cref="ClaimFile"/>; disposing of it gives it back.</summary>
public sealed class Claim : IDisposable
{
    private Action? _giveBack;

    internal Claim(Action giveBack, bool isExclusive)
    {
        _giveBack = giveBack;
        IsExclusive = isExclusive;
    }

    /// <summary>Whether the file system keeps other processes from the same claim; false where it knows no locks.</summary>
    public bool IsExclusive { get; }

    /// <inheritdoc/>
    public void Dispose() => Interlocked.Exchange(ref _giveBack, null)?.Invoke();
}
