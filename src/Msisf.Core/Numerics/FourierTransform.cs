using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Numerics;

/// <summary>
/// Discrete Fourier transforms of a power of two, several at once: the value of each at one index lie side by side, so that vectors hold
/// them. Safe for several threads.
/// </summary>
/// <remarks>
/// Stockham's form with a radix of 4, which needs no reordering (C. Van Loan, Computational frameworks for the FFT, 1992).
/// </remarks>
internal sealed class FourierTransform
{
    private readonly double[] _cosines; // of 2 pi i / length
    private readonly double[] _sines;

    /// <param name="length">A power of two, at least 2.</param>
    public FourierTransform(int length)
    {
        Length = length;
        (_cosines, _sines) = (new double[length], new double[length]);
        for (int i = 0; i < length; i++)
        {
            (_sines[i], _cosines[i]) = Trigonometry.SinCos(2.0 * Math.PI * i / length);
        }
    }

    /// <summary>Number of values of each sequence.</summary>
    public int Length { get; }

    /// <summary>
    /// Replaces sequences by their transforms, sum of x exp(-2 pi i j k / n). With real and imaginary parts interchanged in the call, it is
    /// the inverse without the factor 1 / n.
    /// </summary>
    /// <param name="real">[index, sequence].</param>
    /// <param name="imaginary">[index, sequence].</param>
    /// <param name="lanes">Number of sequences: a multiple of 4.</param>
    /// <param name="scratchReal">As long as the parts; its content is lost.</param>
    /// <param name="scratchImaginary">As long as the parts; its content is lost.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public void Run(Span<double> real, Span<double> imaginary, int lanes, Span<double> scratchReal, Span<double> scratchImaginary)
    {
        (int length, int stride) = (Length, lanes);
        bool isInScratch = false;
        while (length > 1)
        {
            Span<double> fromReal = isInScratch ? scratchReal : real;
            Span<double> fromImaginary = isInScratch ? scratchImaginary : imaginary;
            Span<double> toReal = isInScratch ? real : scratchReal;
            Span<double> toImaginary = isInScratch ? imaginary : scratchImaginary;
            if (length == 2)
            {
                Halves(fromReal, toReal, stride);
                Halves(fromImaginary, toImaginary, stride);
                length = 1;
            }
            else
            {
                for (int p = 0; p < length / 4; p++)
                {
                    Quarters(fromReal, fromImaginary, toReal, toImaginary, length, stride, p);
                }

                (length, stride) = (length / 4, stride * 4);
            }

            isInScratch = !isInScratch;
        }

        if (isInScratch)
        {
            scratchReal[..real.Length].CopyTo(real);
            scratchImaginary[..imaginary.Length].CopyTo(imaginary);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private static void Halves(ReadOnlySpan<double> from, Span<double> to, int stride)
    {
        for (int q = 0; q < stride; q += Vector256<double>.Count)
        {
            Vector256<double> a = Vector256.Create(from[q..]);
            Vector256<double> b = Vector256.Create(from[(q + stride)..]);
            (a + b).CopyTo(to[q..]);
            (a - b).CopyTo(to[(q + stride)..]);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private void Quarters(
        ReadOnlySpan<double> fromReal, ReadOnlySpan<double> fromImaginary, Span<double> toReal, Span<double> toImaginary, int length,
        int stride, int p)
    {
        int step = Length / length * p;
        Vector256<double> cos1 = Vector256.Create(_cosines[step]);
        Vector256<double> sin1 = Vector256.Create(-_sines[step]);
        Vector256<double> cos2 = Vector256.Create(_cosines[2 * step]);
        Vector256<double> sin2 = Vector256.Create(-_sines[2 * step]);
        Vector256<double> cos3 = Vector256.Create(_cosines[3 * step]);
        Vector256<double> sin3 = Vector256.Create(-_sines[3 * step]);
        int quarter = stride * (length / 4);
        int first = stride * p;
        int target = 4 * first;
        for (int q = 0; q < stride; q += Vector256<double>.Count)
        {
            int at = first + q;
            Vector256<double> ar = Vector256.Create(fromReal[at..]);
            Vector256<double> ai = Vector256.Create(fromImaginary[at..]);
            Vector256<double> br = Vector256.Create(fromReal[(at + quarter)..]);
            Vector256<double> bi = Vector256.Create(fromImaginary[(at + quarter)..]);
            Vector256<double> cr = Vector256.Create(fromReal[(at + (2 * quarter))..]);
            Vector256<double> ci = Vector256.Create(fromImaginary[(at + (2 * quarter))..]);
            Vector256<double> dr = Vector256.Create(fromReal[(at + (3 * quarter))..]);
            Vector256<double> di = Vector256.Create(fromImaginary[(at + (3 * quarter))..]);
            (Vector256<double> sumR, Vector256<double> sumI) = (ar + cr, ai + ci);
            (Vector256<double> differenceR, Vector256<double> differenceI) = (ar - cr, ai - ci);
            (Vector256<double> othersR, Vector256<double> othersI) = (br + dr, bi + di);
            (Vector256<double> turnedR, Vector256<double> turnedI) = (di - bi, br - dr); // i (b - d)
            int to = target + q;
            (sumR + othersR).CopyTo(toReal[to..]);
            (sumI + othersI).CopyTo(toImaginary[to..]);
            Store(differenceR - turnedR, differenceI - turnedI, cos1, sin1, toReal[(to + stride)..], toImaginary[(to + stride)..]);
            Store(sumR - othersR, sumI - othersI, cos2, sin2, toReal[(to + (2 * stride))..], toImaginary[(to + (2 * stride))..]);
            Store(
                differenceR + turnedR, differenceI + turnedI, cos3, sin3, toReal[(to + (3 * stride))..],
                toImaginary[(to + (3 * stride))..]);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Store(
        Vector256<double> real, Vector256<double> imaginary, Vector256<double> cosine, Vector256<double> sine, Span<double> toReal,
        Span<double> toImaginary)
    {
        ((real * cosine) - (imaginary * sine)).CopyTo(toReal);
        ((real * sine) + (imaginary * cosine)).CopyTo(toImaginary);
    }
}
