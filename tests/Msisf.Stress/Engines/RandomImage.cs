using System.Buffers.Binary;
using Msisf.TestSupport;

namespace Msisf.Stress.Engines;

/// <summary>
/// A model whose heights have nothing in common from sample to sample: within 10 km of the reference radius, in steps of 0.5 m.
/// </summary>
internal static class RandomImage
{
    private const double Step = 0.5; // m
    private const int Steps = 40_001;

    /// <summary>The model as a function.</summary>
    public static FunctionGrid Grid(int pixelsPerDegree, int seed) =>
        FunctionGrid.OfHeights(pixelsPerDegree, (line, sample) => Step * Value(line, sample, seed));

    /// <summary>The model as an image of little-endian 16-bit samples.</summary>
    public static void Write(string path, int pixelsPerDegree, int seed)
    {
        using FileStream image = File.Create(path);
        byte[] row = new byte[2 * 360 * pixelsPerDegree];
        for (int line = 0; line < 180 * pixelsPerDegree; line++)
        {
            for (int sample = 0; sample < 360 * pixelsPerDegree; sample++)
            {
                BinaryPrimitives.WriteInt16LittleEndian(row.AsSpan(2 * sample), Value(line, sample, seed));
            }

            image.Write(row);
        }
    }

    /// <summary>Two rounds of multiplication and shift, as in SplitMix64.</summary>
    private static short Value(int line, int sample, int seed)
    {
        ulong mixed = (((ulong)(uint)line << 32) ^ (uint)sample ^ ((ulong)(uint)seed << 20)) * 0x9E3779B97F4A7C15;
        mixed = (mixed ^ (mixed >> 29)) * 0xBF58476D1CE4E5B9;
        return (short)((int)((mixed >> 32) % Steps) - (Steps / 2));
    }
}
