using System.Globalization;
using System.Runtime.InteropServices;
using System.Security.Cryptography;
using System.Text;
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

    /// <summary>The header up to the file's length, in ASCII: equal for equal content.</summary>
    /// <param name="layout">What the mesh joins.</param>
    /// <param name="radii">m, one a vertex.</param>
    /// <param name="skirtFootRadius">m: the radius at which the mesh's skirt ends, if it has one.</param>
    /// <param name="productId">The elevation model.</param>
    /// <param name="format">The form of the mesh.</param>
    public static byte[] WithoutLength(
        TileMeshLayout layout, double[] radii, double skirtFootRadius, string productId, PatternFormat format)
    {
        string formatName = format == PatternFormat.Mesh2 ? "mesh2" : "mesh";
        SurfacePart part = layout.Part;
        string place = layout.Part == SurfacePart.Whole(part.Tile)
            ? string.Empty
            : string.Create(CultureInfo.InvariantCulture, $" level={part.Level} part={part.Row}_{part.Column}_of_{part.Subdivisions}");
        string skirt = layout.HasSkirt ? string.Create(CultureInfo.InvariantCulture, $" wall-foot={skirtFootRadius:R}") : string.Empty;
        (int vertices, int faces) = TileMesh.CountsOf(layout);
        return Encoding.ASCII.GetBytes(string.Create(
            CultureInfo.InvariantCulture,
            $"{Mark}{FormatVersion} format={formatName} product={productId} res={layout.PixelsPerDegree} "
                + $"tile={part.Tile.RangeText}{place} margin-samples={layout.MarginSamples}{skirt} samples-sha256={Hash(radii)} "
                + $"vertices={vertices} faces={faces} bytes="));
    }

    /// <summary>SHA-256 over the radii as little-endian doubles in vertex order, in small hexadecimal digits.</summary>
    private static string Hash(double[] radii)
    {
        if (!BitConverter.IsLittleEndian)
        {
            throw new PlatformNotSupportedException("The hash of a pattern is taken over little-endian doubles.");
        }

        return Convert.ToHexStringLower(SHA256.HashData(MemoryMarshal.AsBytes<double>(radii)));
    }
}
