using System.Runtime.InteropServices;
using System.Security.Cryptography;
using System.Text;
using Msisf.Core.Blocks;
using Msisf.Core.Tiles;

namespace Msisf.Adapters.Tiles;

/// <summary>
/// The first line of a pattern file: what the file holds, a hash of the radii that it was made from, and the file's length. So reading it
/// is enough to know whether the file is the wanted one and complete.
/// </summary>
internal static class PatternHeader
{
    /// <summary>The beginning of every pattern of this program.</summary>
    public const string Mark = "// msisf-pattern ";

    /// <summary>Digits of the file's length, with leading zeros, so that the length of the header does not depend on it.</summary>
    public const int LengthDigits = 12;

    private const int FormatVersion = 1;

    /// <summary>2: the scene declares its origin and unit.</summary>
    private const int BlockFormatVersion = 2;

    /// <summary>The header up to the file's length, in ASCII: equal for equal content.</summary>
    /// <param name="layout">What the mesh joins.</param>
    /// <param name="radii">m, one a vertex.</param>
    /// <param name="productId">The elevation model.</param>
    /// <param name="format">The form of the mesh.</param>
    public static byte[] WithoutLength(TileMeshLayout layout, double[] radii, string productId, PatternFormat format)
    {
        string formatName = format == PatternFormat.Mesh2 ? "mesh2" : "mesh";
        return Encoding.ASCII.GetBytes(Invariant(
            $"{Mark}{FormatVersion} format={formatName} product={productId} res={layout.PixelsPerDegree} "
                + $"tile={layout.Tile.RangeText} margin-samples={layout.MarginSamples} samples-sha256={Hash(radii)} "
                + $"vertices={layout.VertexCount} faces={layout.FaceCount} bytes="));
    }

    /// <summary>The same of a block of a surface; the hash is over all that the file holds.</summary>
    public static byte[] WithoutLength(SceneBlocks blocks, SceneBlock block, IReadOnlyList<BlockMesh> meshes)
    {
        string place = blocks.ProductIdOf(block) is { } product
            ? Invariant($"product={BlockPatterns.NameOf(product)} model={block.Part} block={block.Row}_{block.Column}")
            : Invariant($"seams={block.Column}");
        return Encoding.ASCII.GetBytes(Invariant(
            $"{Mark}{BlockFormatVersion} format=mesh2 {place} sides={(blocks.IsClosed ? "both" : "outside")} meshes={meshes.Count} "
                + $"facets-sha256={Hash(meshes)} vertices={meshes.Sum(mesh => mesh.VertexCount)} "
                + $"faces={meshes.Sum(mesh => mesh.FaceCount)} bytes="));
    }

    /// <summary>
    /// SHA-256 over each mesh: lattice and origin, offsets, vertex numbers, as little-endian integers of 64, 32 and 32 bits.
    /// </summary>
    private static string Hash(IEnumerable<BlockMesh> meshes)
    {
        RequireLittleEndian();
        using IncrementalHash hash = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);
        foreach (BlockMesh mesh in meshes)
        {
            hash.AppendData(MemoryMarshal.AsBytes<long>([mesh.LatticeExponent, mesh.Origin.X, mesh.Origin.Y, mesh.Origin.Z]));
            hash.AppendData(MemoryMarshal.AsBytes<int>(mesh.Offsets));
            hash.AppendData(MemoryMarshal.AsBytes<int>(mesh.Faces));
        }

        return Convert.ToHexStringLower(hash.GetHashAndReset());
    }

    /// <summary>SHA-256 over the radii as little-endian doubles in vertex order, in small hexadecimal digits.</summary>
    private static string Hash(double[] radii)
    {
        RequireLittleEndian();
        return Convert.ToHexStringLower(SHA256.HashData(MemoryMarshal.AsBytes<double>(radii)));
    }

    private static void RequireLittleEndian()
    {
        if (!BitConverter.IsLittleEndian)
        {
            throw new PlatformNotSupportedException("The hash of a pattern is taken over little-endian numbers.");
        }
    }
}

/// <summary>Tells by its first line and its length whether a file is the wanted pattern.</summary>
internal static class PatternFile
{
    /// <summary>What a file can be.</summary>
    public enum State
    {
        /// <summary>The wanted pattern, complete.</summary>
        Good,

        /// <summary>No file.</summary>
        Missing,

        /// <summary>A pattern of this program that is damaged, of another format, or made from other samples: it is made again.</summary>
        Outdated,

        /// <summary>A file that this program has not written: it is left alone.</summary>
        Foreign,
    }

    /// <summary>Checks a file by one read, whatever its size.</summary>
    /// <param name="headerWithoutLength">The header that is wanted (see <see cref="PatternHeader"/>).</param>
    /// <exception cref="ExternalPartException">The file is there but can't be read.</exception>
    public static State Inspect(string path, byte[] headerWithoutLength)
    {
        if (!File.Exists(path) && !Directory.Exists(path))
        {
            return State.Missing; // an exception would take as long as making a small pattern
        }

        try
        {
            using Microsoft.Win32.SafeHandles.SafeFileHandle file = File.OpenHandle(path, share: FileShare.ReadWrite | FileShare.Delete);
            Span<byte> start = stackalloc byte[headerWithoutLength.Length + PatternHeader.LengthDigits + 1];
            start = start[..RandomAccess.Read(file, start, fileOffset: 0)];
            return IsWanted(start, headerWithoutLength, RandomAccess.GetLength(file)) ? State.Good
                : IsOurs(start) ? State.Outdated
                : State.Foreign;
        }
        catch (Exception exception) when (exception is FileNotFoundException or DirectoryNotFoundException)
        {
            return State.Missing;
        }
        catch (Exception exception) when (exception.IsFileError())
        {
            throw new ExternalPartException(
                $"{path}: can't be read: {exception.Message} Move it away, or choose another pattern repository.", exception);
        }
    }

    private static bool IsWanted(ReadOnlySpan<byte> start, byte[] headerWithoutLength, long length) =>
        start.Length == headerWithoutLength.Length + PatternHeader.LengthDigits + 1
        && start.StartsWith(headerWithoutLength)
        && start[^1] == '\n'
        && long.TryParse(start[headerWithoutLength.Length..^1], NumberStyles.None, CultureInfo.InvariantCulture, out long expected)
        && expected == length;

    /// <summary>
    /// Whether it begins with our mark, or with as much of it as there are bytes. After a power cut a file can also be empty or all zeros.
    /// </summary>
    private static bool IsOurs(ReadOnlySpan<byte> start)
    {
        ReadOnlySpan<byte> mark = System.Text.Encoding.ASCII.GetBytes(PatternHeader.Mark);
        int common = Math.Min(mark.Length, start.Length);
        return start[..common].SequenceEqual(mark[..common]) || !start.ContainsAnyExcept((byte)0);
    }
}
