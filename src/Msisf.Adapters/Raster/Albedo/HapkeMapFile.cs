using System.Buffers.Binary;
using System.Security.Cryptography;
using Msisf.Core.Render.Photometry;

namespace Msisf.Adapters.Raster.Albedo;

/// <summary>
/// The product WAC_HAPKEPARAMMAP_643NM.IMG of LROC: nine maps of one degree from 70 N to 70 S, one after the other: w, b, c, BC0, hc, BS0,
/// hs, theta, phi. Its label gives another place of the data than it has, so the places are fixed here.
/// </summary>
/// <param name="FileBytes">Length of the file.</param>
/// <param name="Sha256">SHA-256 of the file: 64 hexadecimal digits.</param>
public sealed record HapkeMapFile(HapkeMap Map, long FileBytes, string Sha256)
{
    /// <summary>Band of the product, nm.</summary>
    public const int BandNanometres = 643;

    private const int Samples = 360;
    private const int Lines = 140;
    private const int PlanesInFile = 9;
    private const int DataOffset = 5760;
    private const int PlaneBytes = Samples * Lines * sizeof(float);
    private const double FirstLatitudeDegrees = 69.5;
    private const double FirstLongitudeDegrees = 0.5;

    /// <summary>Number of the map in the file, name and range of each parameter that is used.</summary>
    private static readonly (int Plane, string Name, double Least, double Greatest)[] Used =
    [
        (0, "w", 0.0, 1.0), (1, "b", 0.0, 0.95), (2, "c", -1.0, 5.0), (5, "Bs0", 0.0, 10.0), (6, "hs", 1e-4, 10.0), (7, "theta", 0.0, 60.0),
    ];

    /// <summary>Reads the file.</summary>
    /// <exception cref="BadInputException">It is missing, of another length, or holds values that can't be right.</exception>
    public static HapkeMapFile Read(string path)
    {
        if (!File.Exists(path))
        {
            throw new BadInputException($"{path}: there is no such file. Give LROC's WAC_HAPKEPARAMMAP_643NM.IMG.");
        }

        byte[] bytes = FileErrors.ToBadInput($"{path}: can't be read", () => File.ReadAllBytes(path));
        int needed = DataOffset + (PlanesInFile * PlaneBytes);
        if (bytes.Length < needed)
        {
            throw new BadInputException(
                $"{path}: {bytes.Length} bytes, at least {needed} expected (9 maps of 360 x 140 real numbers behind 5760 bytes). "
                    + $"Give LROC's WAC_HAPKEPARAMMAP_643NM.IMG.");
        }

        // The byte order is the one in which all values are possible.
        double[][]? planes = TryRead(bytes, (all, at) => BinaryPrimitives.ReadSingleLittleEndian(all.AsSpan(at)), out string? problem)
            ?? TryRead(bytes, (all, at) => BinaryPrimitives.ReadSingleBigEndian(all.AsSpan(at)), out _);
        return planes is null
            ? throw new BadInputException($"{path}: {problem}. Get the file again.")
            : new HapkeMapFile(
                new HapkeMap(planes, Samples, FirstLatitudeDegrees, FirstLongitudeDegrees),
                bytes.Length,
                Convert.ToHexStringLower(SHA256.HashData(bytes)));
    }

    private static double[][]? TryRead(byte[] bytes, Func<byte[], int, float> read, out string? problem)
    {
        problem = null;
        double[][] planes = new double[Used.Length][];
        for (int used = 0; used < Used.Length; used++)
        {
            (int plane, string name, double least, double greatest) = Used[used];
            planes[used] = new double[Samples * Lines];
            for (int i = 0; i < planes[used].Length; i++)
            {
                double value = read(bytes, DataOffset + (plane * PlaneBytes) + (i * sizeof(float)));
                if (!(value >= least && value <= greatest))
                {
                    problem = Invariant(
                        $"map {plane + 1} ({name}), line {(i / Samples) + 1}, sample {(i % Samples) + 1}: {value:R}; "
                            + $"{least:R} to {greatest:R} is possible");
                    return null;
                }

                planes[used][i] = name == "theta" ? Math.Tan(double.DegreesToRadians(value)) : value;
            }
        }

        return planes;
    }
}
