using System.Text;

namespace Msisf.Adapters.Interop;

/// <summary>
/// The kernels in CSPICE's pool. There is one pool per process, so engines with different kernels take turns, and none sees the kernels of
/// another. Call it under <see cref="CSpice"/>'s lock.
/// </summary>
internal sealed class FurnishedKernels
{
    /// <summary>The longest path that furnsh_c takes, in bytes (CSPICE N0067: 256 gives SPICE(FILENAMETOOLONG)).</summary>
    private const int MaximumPathBytes = 255;

    private IReadOnlyList<string> _loaded = [];

    /// <summary>Loads these kernels and unloads all others.</summary>
    /// <param name="paths">Absolute paths in load order.</param>
    /// <exception cref="SpiceException">CSPICE refuses a kernel; none stays loaded.</exception>
    public void Use(IReadOnlyList<string> paths)
    {
        if (ReferenceEquals(_loaded, paths) || _loaded.SequenceEqual(paths))
        {
            return;
        }

        UnloadAll();
        List<string> furnished = [];
        _loaded = furnished;
        try
        {
            foreach (string path in paths)
            {
                Furnish(path);
                furnished.Add(path);
            }
        }
        catch (SpiceException)
        {
            UnloadAll();
            throw;
        }

        _loaded = paths;
    }

    /// <summary>Unloads these kernels if they are the loaded ones.</summary>
    /// <param name="paths">As given to <see cref="Use"/>.</param>
    public void Drop(IReadOnlyList<string> paths)
    {
        if (_loaded.SequenceEqual(paths))
        {
            UnloadAll();
        }
    }

    private static void Furnish(string path)
    {
        int bytes = Encoding.UTF8.GetByteCount(path);
        if (bytes > MaximumPathBytes)
        {
            throw new SpiceException(Invariant(
                $"{path}: the path has {bytes} bytes; CSPICE takes {MaximumPathBytes} at most. "
                    + $"Move the kernels to a shorter path, or use --ephemeris builtin."));
        }

        CSpiceNative.furnsh_c(path);
        CSpiceError.ThrowIfFailed("furnsh_c", path);
    }

    private void UnloadAll()
    {
        IReadOnlyList<string> paths = _loaded;
        _loaded = [];
        for (int i = paths.Count - 1; i >= 0; i--)
        {
            CSpiceNative.unload_c(paths[i]);
            CSpiceError.ThrowIfFailed("unload_c", paths[i]);
        }
    }
}
