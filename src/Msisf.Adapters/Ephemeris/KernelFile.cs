using System.IO.Compression;
using System.Text;

namespace Msisf.Adapters.Ephemeris;

/// <summary>Opens kernel files, and tells the kinds of a mission's files apart by their first characters.</summary>
public static class KernelFile
{
    private const int IdWordBytes = 8;

    /// <summary>The kinds of files, and the option that takes them; null for one that nothing here reads.</summary>
    private static readonly (string Start, string What, string? Option)[] Kinds =
    [
        ("DAF/SPK", "an SPK (trajectories)", "--spk"), ("DAF/CK", "a CK (attitudes)", "--ck"),
        ("DAF/PCK", "a binary PCK (orientations of bodies)", "--kernels"), ("DAS/DSK", "a DSK (shapes)", null),
        ("DAS/EK", "an EK (events)", null), ("KPL/FK", "a frame kernel (FK)", "--kernels"),
        ("KPL/IK", "an instrument kernel (IK)", "--kernels"),
        ("KPL/SCLK", "a clock kernel (SCLK)", "--kernels"), ("KPL/LSK", "a leap seconds kernel (LSK)", "--kernels"),
        ("KPL/PCK", "a text PCK", "--kernels"), (MetaKernel, "a meta-kernel", "--kernels"),
        ("CCSDS_OE", "a CCSDS orbit message (OEM)", "--oem"), ("CCSDS_AE", "a CCSDS attitude message (AEM)", "--aem"),
    ];

    /// <summary>What a meta-kernel begins with.</summary>
    public const string MetaKernel = "KPL/MK";

    /// <summary>
    /// The first eight characters up to the first blank, by which SPICE tells the kinds of kernels; "" for an empty file.
    /// </summary>
    /// <exception cref="BadInputException">The file can't be opened.</exception>
    public static string IdWordOf(string path)
    {
        using FileStream stream = OpenBinary(path);
        Span<byte> start = stackalloc byte[IdWordBytes];
        int read = stream.ReadAtLeast(start, IdWordBytes, throwOnEndOfStream: false);
        if (start is [0x1F, 0x8B, ..])
        {
            read = ReadCompressed(stream, start);
        }

        string text = Encoding.Latin1.GetString(start[..read]);
        int end = text.AsSpan().IndexOfAny(" \r\n\t=");
        return end < 0 ? text : text[..end];
    }

    /// <summary>Refuses a file of a kind that another option takes.</summary>
    /// <param name="option">The option that names the file.</param>
    /// <param name="takes">The kinds that it takes, by how they begin.</param>
    /// <exception cref="BadInputException">It is of a known kind, but of none of these.</exception>
    public static void Require(string path, string option, params string[] takes)
    {
        string idWord = IdWordOf(path);
        foreach ((string start, string what, string? other) in Kinds)
        {
            if (idWord == start && !takes.Contains(start))
            {
                throw new BadInputException(other is null
                    ? $"{path}: this is {what}, which is not used for images. Leave it out."
                    : $"{path}: this is {what}. Give it with {other} in place of {option}.");
            }
        }
    }

    /// <summary>Whether a kernel is binary, by its first characters.</summary>
    /// <exception cref="BadInputException">It is of no kind that is known.</exception>
    public static bool IsBinary(string path)
    {
        string idWord = IdWordOf(path);
        if (idWord is "DAF/SPK" or "DAF/PCK" or "DAF/CK" or "DAS/DSK" or "DAS/EK")
        {
            return true;
        }

        if (idWord.Length == 0 && new FileInfo(path).Length == 0)
        {
            throw new BadInputException($"{path}: the file is empty. Get the kernel anew.");
        }

        if (idWord.StartsWith("DAF/", StringComparison.Ordinal) || idWord.StartsWith("DAS/", StringComparison.Ordinal))
        {
            throw new BadInputException(
                $"{path}: damaged kernel: it begins with \"{idWord.Replace('\0', '?')}\", which no kernel does. Is it cut off? Get the "
                    + "file anew.");
        }

        if (idWord.Contains('\0', StringComparison.Ordinal) || idWord is "NAIF/DAF" or "DAFETF")
        {
            throw new BadInputException(
                $"{path}: neither a text kernel nor a binary SPK, CK or PCK: the file begins with \"{idWord.Replace('\0', '?')}\". "
                    + $"Get the file anew, or convert it with NAIF's tobin.");
        }

        Require(
            path, "--kernels",
            [.. Kinds.Select(kind => kind.Start).Where(start => start.StartsWith("KPL/", StringComparison.Ordinal))]);
        return false;
    }

    /// <summary>Opens a text kernel.</summary>
    /// <exception cref="BadInputException">It can't be opened.</exception>
    public static StreamReader OpenText(string path) => new(OpenBinary(path), Encoding.UTF8);

    /// <summary>Opens a binary kernel. The stream has no buffer, because each read takes a whole record.</summary>
    /// <exception cref="BadInputException">It can't be opened.</exception>
    public static FileStream OpenBinary(string path) => FileErrors.ToBadInput(
        $"{path}: the kernel can't be opened",
        () => new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.Read, bufferSize: 0));

    /// <summary>Reads the first characters of what is compressed by gzip.</summary>
    private static int ReadCompressed(FileStream stream, Span<byte> start)
    {
        try
        {
            stream.Position = 0;
            using GZipStream content = new(stream, CompressionMode.Decompress, leaveOpen: true);
            return content.ReadAtLeast(start, start.Length, throwOnEndOfStream: false);
        }
        catch (InvalidDataException)
        {
            return 0; // gzip in name only: whoever reads it says what is wrong
        }
    }
}
