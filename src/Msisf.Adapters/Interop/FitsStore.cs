namespace Msisf.Adapters.Interop;

/// <summary>Where CFITSIO has a file until it is copied to a stream: in memory or on disk.</summary>
internal interface IFitsStore : IDisposable
{
    /// <summary>Opens it as a file; <see cref="CFitsio.Gate"/> is held.</summary>
    int Open(out CFitsioHandle file, ref int status);

    /// <summary>Copies a part of the file.</summary>
    void CopyTo(Stream destination, long start, long end);
}

/// <summary>A FITS file on disk for what is too large for memory; it goes when it is done with.</summary>
/// <param name="path">Where no file is yet.</param>
internal sealed class FitsDiskFile(string path) : IFitsStore
{
    /// <summary>bytes: what is copied at once.</summary>
    private const int CopiedAtOnce = 1 << 20;

    public int Open(out CFitsioHandle file, ref int status) => CFitsioNative.ffdkinit(out file, path, ref status);

    public void CopyTo(Stream destination, long start, long end)
    {
        using FileStream file = new(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite);
        file.Position = start;
        byte[] bytes = new byte[CopiedAtOnce];
        for (long left = end - start; left > 0;)
        {
            int count = (int)Math.Min(left, bytes.Length);
            file.ReadExactly(bytes, 0, count);
            destination.Write(bytes, 0, count);
            left -= count;
        }
    }

    public void Dispose() => File.Delete(path);
}
