using System.Buffers.Binary;
using System.Collections.Concurrent;
using System.Security.Cryptography;
using System.Text;

namespace Msisf.Adapters.IO;

/// <summary>
/// Says which process works on what, so that several processes can share the work in one folder. A claim is a lock on one byte of a file
/// that stays empty; the byte follows from the name of what is claimed. The system releases the claims of a process that dies, over NFS
/// also those of a node. Where the file system (or .NET on macOS) has no such locks, every claim is granted: work is then done twice, with
/// the same bytes as result. Safe for several threads.
/// </summary>
public sealed class ClaimFile : IDisposable
{
    private readonly ConcurrentDictionary<long, bool> _own = new();
    private readonly FileStream? _locks;

    private ClaimFile(FileStream? locks) => _locks = locks;

    /// <summary>Opens the file, or creates it.</summary>
    /// <param name="path">
    /// In the folder of what is claimed. A folder that can't be written to has no claims but those within the process.
    /// </param>
    public static ClaimFile Open(string path)
    {
        try
        {
            // Sharing both ways takes no lock on the whole file over NFS, which would be in the way of the claims.
            return new ClaimFile(
                new FileStream(path, FileMode.OpenOrCreate, FileAccess.ReadWrite, FileShare.ReadWrite | FileShare.Delete, bufferSize: 0));
        }
        catch (Exception exception) when (exception.IsFileError())
        {
            return new ClaimFile(null);
        }
    }

    /// <summary>Claims a name, without waiting.</summary>
    /// <param name="name">What is claimed, the same text in all processes.</param>
    /// <returns>Gives the claim back when disposed; null if another process or thread has it.</returns>
    public Claim? TryTake(string name)
    {
        long place = PlaceOf(name);
        if (!_own.TryAdd(place, true))
        {
            return null;
        }

        try
        {
            if (_locks is null || OperatingSystem.IsMacOS())
            {
                return new Claim(() => GiveBack(place), isExclusive: false);
            }

            _locks.Lock(place, 1);
            return new Claim(() => GiveBack(place), isExclusive: true);
        }
        catch (Exception exception) when (exception.IsFileError())
        {
            if (!FileLock.IsHeldByAnother(exception))
            {
                return new Claim(() => GiveBack(place), isExclusive: false); // this file system knows no locks
            }

            _own.TryRemove(place, out _);
            return null;
        }
    }

    /// <summary>Releases all claims.</summary>
    public void Dispose() => _locks?.Dispose();

    private static long PlaceOf(string name) =>
        BinaryPrimitives.ReadInt64LittleEndian(SHA256.HashData(Encoding.UTF8.GetBytes(name))) & (long.MaxValue >> 1);

    private void GiveBack(long place)
    {
        try
        {
            if (!OperatingSystem.IsMacOS())
            {
                _locks?.Unlock(place, 1);
            }
        }
        catch (Exception exception) when (exception.IsFileError())
        {
            return; // there was no lock: the claim held within the process only
        }
        finally
        {
            _own.TryRemove(place, out _);
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
