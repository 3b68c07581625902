using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Camera;
using Msisf.Core.Time;

namespace Msisf.Core.Detector.Noise;

/// <summary>
/// Random numbers of a frame that belong to a pixel and a kind: they depend on nothing else, so not on threads, on other frames or on the
/// order of the work. Immutable.
/// </summary>
internal readonly struct NoiseSource
{
    /// <summary>Number of lanes of a vector.</summary>
    public const int Lanes = 8;

    /// <summary>Maximum number of pixels whose deviates are computed in one call: what they need stays in the processor's cache.</summary>
    public const int MaxRun = 512;

    private const int UniformBits = 52;

    private const ulong One = 0x3FF0_0000_0000_0000; // bits of 1.0
    private const double HalfStepBelowOne = 1.0 - (0.5 / (1UL << UniformBits));
    private const int PixelsOfFour = 8; // that four indices of the generator serve
    private const int PixelsAtOnce = 2 * Lanes;

    private readonly ulong _seed;
    private readonly ulong _frame;

    private NoiseSource(ulong seed, ulong frame)
    {
        _seed = seed;
        _frame = frame;
    }

    /// <summary>Numbers that change from frame to frame.</summary>
    /// <param name="frame">Number of the frame: <see cref="FrameNumber"/>, or its step.</param>
    public static NoiseSource OfFrame(ulong seed, ulong frame) => new(seed, frame);

    /// <summary>Numbers that stay the same in all frames: the fixed pattern of a detector.</summary>
    public static NoiseSource OfDetector(ulong seed) => new(seed, 0);

    /// <summary>Two independent numbers, uniform between 0 and 1, without both ends; odd multiples of 2^-53.</summary>
    public (double First, double Second) Uniforms(NoiseKind kind, uint index)
    {
        (uint w0, uint w1, uint w2, uint w3) = Philox4x32.Block(
            (index, SecondWord(kind), (uint)_frame, (uint)(_frame >> 32)), _seed);
        return (Uniform(w0, w1), Uniform(w2, w3));
    }

    /// <summary>One number of each pixel of a part of a row, uniform between 0 and 1, without both ends.</summary>
    /// <param name="first">Index of the first pixel.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would otherwise be drawn with unoptimised vectors
    public void Fill(NoiseKind kind, uint first, Span<double> uniforms)
    {
        // An index of the generator gives two numbers: pixels 8 k to 8 k + 3 take the first ones of the indices 4 k to 4 k + 3, the next
        // four pixels the second ones.
        int before = (int)(first % PixelsOfFour);
        uint index = (first - (uint)before) / 2;
        Span<double> part = stackalloc double[PixelsAtOnce];
        for (int start = -before; start < uniforms.Length; start += PixelsAtOnce)
        {
            Vector512<ulong> w0 = Vector512.Create((ulong)index) + Vector512.Create(0UL, 1, 2, 3, 4, 5, 6, 7);
            Vector512<ulong> w1 = Vector512.Create((ulong)SecondWord(kind));
            Vector512<ulong> w2 = Vector512.Create(_frame);
            Vector512<ulong> w3 = Vector512.Create(_frame >> 32);
            Philox4x32.Blocks(ref w0, ref w1, ref w2, ref w3, _seed);
            Vector512<double> firsts = Uniform(w0, w1);
            Vector512<double> seconds = Uniform(w2, w3);
            bool isWhole = start >= 0 && uniforms.Length - start >= PixelsAtOnce;
            Span<double> target = isWhole ? uniforms.Slice(start, PixelsAtOnce) : part;
            Vector512.Create(firsts.GetLower(), seconds.GetLower()).CopyTo(target);
            Vector512.Create(firsts.GetUpper(), seconds.GetUpper()).CopyTo(target[Lanes..]);
            if (!isWhole)
            {
                int from = Math.Max(0, -start);
                part[from..Math.Min(PixelsAtOnce, uniforms.Length - start)].CopyTo(uniforms[(start + from)..]);
            }

            index += Lanes;
        }
    }

    /// <summary>The counter's second word.</summary>
    private static uint SecondWord(NoiseKind kind) => (uint)kind;

    /// <summary>(n + 1/2) 2^-52 for the upper 52 of 64 bits.</summary>
    private static double Uniform(uint upper, uint lower) =>
        BitConverter.UInt64BitsToDouble(One | ((ulong)upper << 20) | (lower >> 12)) - HalfStepBelowOne;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> Uniform(Vector512<ulong> upper, Vector512<ulong> lower)
    {
        // Shifts that cut off the upper halves of the lanes, which are undefined, and the lower 12 bits of the second word.
        Vector512<ulong> bits = ((upper << 32) >>> 12) | ((lower << 32) >>> 44) | Vector512.Create(One);
        return bits.AsDouble() - Vector512.Create(HalfStepBelowOne);
    }
}

/// <summary>What random numbers are for. The number of a kind is part of the generator's counter and never changes.</summary>
internal enum NoiseKind : byte
{
    /// <summary>Number of electrons that the mean signal of a pixel gives.</summary>
    Shot = 1,

    /// <summary>Read noise of a pixel.</summary>
    Read = 2,

    /// <summary>Number of cosmic rays in a frame.</summary>
    RayCount = 3,

    /// <summary>Where a cosmic ray enters the detector.</summary>
    RayPosition = 4,

    /// <summary>Direction of a cosmic ray.</summary>
    RayDirection = 5,

    /// <summary>Response of a pixel (PRNU); the same in all frames.</summary>
    Response = 6,

    /// <summary>Dark current of a pixel (DSNU); the same in all frames.</summary>
    DarkCurrent = 7,

    /// <summary>Offset of a column; the same in all frames.</summary>
    ColumnOffset = 8,

    /// <summary>Whether a pixel is hot or dead; the same in all frames.</summary>
    Defect = 9,
}
