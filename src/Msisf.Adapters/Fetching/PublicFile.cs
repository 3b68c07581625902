using Msisf.Adapters.IO;

namespace Msisf.Adapters.Fetching;

/// <summary>A file of public data of which every byte is known.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Place">The address of its folder.</param>
/// <param name="Bytes">Its length.</param>
/// <param name="Sha256">SHA-256 of its content, 64 hexadecimal digits in small letters.</param>
public sealed record PublicFile(string Name, string Place, long Bytes, string Sha256)
{
    private const string Naif = "https://naif.jpl.nasa.gov/pub/naif/generic_kernels";

    /// <summary>The main catalogue of Hipparcos (ESA SP-1200, CDS I/239), 118,218 lines.</summary>
    public static PublicFile Hipparcos { get; } = new(
        "hip_main.dat", "https://cdsarc.cds.unistra.fr/ftp/cats/I/239", 53_316_318,
        "58ceabb104d647160d9437ce6e513a02a036bb4ad9f8879a5a22fd52943616e0");

    /// <summary>The kernels that come with the program, and the orientations of the other bodies (kernels/README.md).</summary>
    public static IReadOnlyList<PublicFile> Kernels { get; } =
    [
        new("naif0012.tls", $"{Naif}/lsk", 5_257, "678e32bdb5a744117a467cd9601cd6b373f0e9bc9bbde1371d5eee39600a039b"),
        new("moon_080317.tf", $"{Naif}/fk/satellites", 21_437, "78732477b96f9863e7b0d65bcee3c22b8707ca5ed0db56d1173319cb2e8c7993"),
        new("moon_assoc_me.tf", $"{Naif}/fk/satellites", 8_468, "52c622043ce0447d575e59ee01642f1894921e68c10f934ceff065f362da6c1c"),
        new(
            "moon_pa_de421_1900-2050.bpc", $"{Naif}/pck", 1_770_496,
            "656f90616403d75a75f0cd6c8830fc5b44f8cb4facb5ccb8915e752b397520cf"),
        new(
            "de421.bsp", "https://ssd.jpl.nasa.gov/ftp/eph/planets/bsp", 16_788_480, // NAIF's copy has 2,048 bytes of comments more
            "a20a7139da04cbc462454634918e9a9ca69127044e2cc9d4f9c16e238d2deedc"),
        new("pck00011.tpc", $"{Naif}/pck", 131_226, "3dff7b1dbeceaa01f25467767d3fa25816051c85d162d1edf04acb310ee28bb1"),
    ];

    /// <summary>What is wrong with a copy; null if it is this file.</summary>
    /// <param name="path">An existing file.</param>
    /// <exception cref="IOException">It can't be read.</exception>
    public string? FaultOf(string path)
    {
        long size = new FileInfo(path).Length;
        return size != Bytes ? Invariant($"{path}: it has {size} bytes, not {Bytes}.")
            : FileHash.Sha256Of(path) != Sha256 ? $"{path}: its SHA-256 is not that of the published file."
            : null;
    }
}
