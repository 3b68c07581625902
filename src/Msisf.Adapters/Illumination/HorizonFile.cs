using System.Runtime.InteropServices;
using Msisf.Adapters.IO;
using Msisf.Core.Illumination;

namespace Msisf.Adapters.Illumination;

/// <summary>Keeps horizons of places in files, for other dates and after a kill: what is there is whole (docs/illumination.md).</summary>
public static class HorizonFile
{
    private static ReadOnlySpan<byte> Magic => "MSISHOR1"u8;

    /// <summary>Writes horizons.</summary>
    /// <exception cref="ExternalPartException">The disk is full, or refuses.</exception>
    public static void Write(string path, PlaceHorizons horizons) => AtomicFile.Write(path, stream =>
    {
        stream.Write(Magic);
        stream.Write(MemoryMarshal.AsBytes([horizons.Radii.Length, horizons.Corners.Length]));
        stream.Write(MemoryMarshal.AsBytes(horizons.Radii.AsSpan()));
        stream.Write(MemoryMarshal.AsBytes(horizons.Slopes.AsSpan()));
        stream.Write(MemoryMarshal.AsBytes(horizons.Ends.AsSpan()));
        stream.Write(MemoryMarshal.AsBytes(horizons.Corners.AsSpan()));
    });

    /// <summary>Reads horizons; null if there is no such file.</summary>
    /// <param name="places">How many places it must have.</param>
    /// <exception cref="BadInputException">It is another file.</exception>
    public static PlaceHorizons? Read(string path, int places) => !File.Exists(path) ? null : FileErrors.ToBadInput(
        $"{path}: can't be read", () =>
        {
            using FileStream stream = File.OpenRead(path);
            byte[] magic = new byte[Magic.Length];
            int[] counts = new int[2];
            stream.ReadExactly(magic);
            stream.ReadExactly(MemoryMarshal.AsBytes(counts.AsSpan()));
            long expected = Magic.Length + sizeof(long) + ((sizeof(double) + sizeof(float) + sizeof(int)) * (long)places)
                + (sizeof(uint) * (long)counts[1]);
            if (!magic.AsSpan().SequenceEqual(Magic) || counts[0] != places || stream.Length != expected)
            {
                throw NoHorizons(path, places);
            }

            PlaceHorizons horizons = new(new double[places], new float[places], new int[places], new uint[counts[1]]);
            stream.ReadExactly(MemoryMarshal.AsBytes(horizons.Radii.AsSpan()));
            stream.ReadExactly(MemoryMarshal.AsBytes(horizons.Slopes.AsSpan()));
            stream.ReadExactly(MemoryMarshal.AsBytes(horizons.Ends.AsSpan()));
            stream.ReadExactly(MemoryMarshal.AsBytes(horizons.Corners.AsSpan()));
            return horizons.IsSound ? horizons : throw NoHorizons(path, places);
        });

    private static BadInputException NoHorizons(string path, int places) =>
        new($"{path}: no horizons of {places} places. Remove the file; it is made again.");
}
