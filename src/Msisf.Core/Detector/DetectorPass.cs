using System.Buffers;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Camera;
using Msisf.Core.Detector.Noise;
using Msisf.Core.Detector.Psf;
using Msisf.Core.Parallel;

namespace Msisf.Core.Detector;

/// <summary>
/// Turns the light of a frame into digital numbers: optics, PSF, exposure, noise, full well, conversion (docs/detector.md). The result does
/// not depend on the number of threads.
/// </summary>
internal sealed class DetectorPass(DetectorSettings settings, FixedPattern pattern)
{
    private const int SmearColumns = 128; // columns that a thread sums at once: four lines of the cache each row

    private readonly Converter _converter = new(settings);

    /// <summary>Adds the electrons of one drawn instant to <see cref="DetectorImage.Electrons"/>.</summary>
    /// <param name="light">
    /// Radiance factor of each pixel of the frame, wider and higher than the detector by the PSF's radius on each side.
    /// </param>
    /// <param name="throughput">Throughput of each pixel of the detector, steradians.</param>
    /// <param name="perSteradianOfRow">
    /// Electrons that a pixel of a row, from 0, collects at a radiance factor of 1, for each steradian.
    /// </param>
    /// <param name="weightOfRow">Part of the exposure of a row, from 0, that the instant stands for.</param>
    /// <param name="rows">The detector's rows on which the light falls.</param>
    public void Expose(
        ReadOnlyMemory<double> light, ReadOnlyMemory<double> throughput, Func<int, double> perSteradianOfRow, Func<int, double> weightOfRow,
        PixelRows rows, DetectorImage image, int threads, CancellationToken cancellation)
    {
        int width = image.Width;
        int margin = settings.PointSpread?.Radius ?? 0;
        WorkerTeam.Run(threads, rows.End - rows.First, (_, drawnRow) =>
        {
            int row = rows.First + drawnRow;
            double weight = weightOfRow(row);
            if (weight == 0.0)
            {
                return;
            }

            double perSteradian = perSteradianOfRow(row);
            double[] memory = ArrayPool<double>.Shared.Rent(width);
            Span<double> spread = memory.AsSpan(0, width);
            if (settings.PointSpread is PointSpreadKernel kernel)
            {
                KernelConvolution.Row(light.Span, width + (2 * margin), kernel, drawnRow, spread);
            }
            else
            {
                light.Span.Slice(drawnRow * width, width).CopyTo(spread);
            }

            Span<double> target = image.Electrons.AsSpan(row * width, width);
            ReadOnlySpan<double> factors = throughput.Span.Slice(row * width, width);
            for (int column = 0; column < width; column++)
            {
                target[column] += spread[column] * (perSteradian * factors[column]) * weight;
            }

            ArrayPool<double>.Shared.Return(memory);
        }, cancellation);
    }

    /// <summary>The response of each pixel to light, 1 on average.</summary>
    public ReadOnlySpan<float> Response => pattern.Response;

    /// <summary>
    /// The variance of the electrons that a pixel is read out with: shot noise of light and dark current, read noise, and that of rounding
    /// to whole numbers.
    /// </summary>
    /// <param name="electrons">Mean number of electrons that light frees in the pixel.</param>
    /// <param name="pixel">By rows from the top.</param>
    public double VarianceOf(double electrons, int pixel) =>
        (electrons * pattern.Response[pixel]) + pattern.DarkElectrons[pixel] + (settings.ReadNoise * settings.ReadNoise)
            + (settings.Gain * settings.Gain / 12.0);

    /// <summary>Computes the digital numbers and the saturation from <see cref="DetectorImage.Electrons"/>.</summary>
    /// <param name="noise">Random numbers of the frame; null for an image without noise.</param>
    public void Read(DetectorImage image, NoiseSource? noise, int threads, CancellationToken cancellation)
    {
        if (settings.Smear is not null)
        {
            int stripes = (image.Width + SmearColumns - 1) / SmearColumns;
            WorkerTeam.Run(threads, stripes, (_, stripe) =>
            {
                Range columns = (stripe * SmearColumns)..Math.Min(image.Width, (stripe + 1) * SmearColumns);
                SmearSum.Fill(image.Electrons, image.Width, columns, settings, image.Charge);
            }, cancellation);
        }

        int overflows = 0;
        WorkerTeam.Run(threads, image.Height, (_, row) =>
        {
            if (CollectRow(image, row, noise))
            {
                Volatile.Write(ref overflows, 1);
            }
        }, cancellation);
        if (noise is { } source && settings.CosmicRays is not null)
        {
            RayTracks.Add(image.Charge, image.Width, settings, source);
            overflows = double.IsFinite(settings.FullWell) ? 1 : 0;
        }

        if (overflows != 0)
        {
            if (settings.IsBlooming)
            {
                Blooming.Spread(image.Charge, image.Width, settings.FullWell);
            }
            else
            {
                Blooming.Drain(image.Charge, settings.FullWell);
            }
        }

        WorkerTeam.Run(threads, image.Height, (_, row) => ConvertRow(image, row, noise), cancellation);
    }

    /// <summary>Collects the electrons of a row.</summary>
    /// <returns>Whether a pixel has more than its full well.</returns>
    private bool CollectRow(DetectorImage image, int row, NoiseSource? noise)
    {
        int start = row * image.Width;
        ReadOnlySpan<double> electrons = image.Electrons.AsSpan(start, image.Width);
        ReadOnlySpan<float> response = pattern.Response.AsSpan(start, image.Width);
        ReadOnlySpan<float> dark = pattern.DarkElectrons.AsSpan(start, image.Width);
        Span<double> charge = image.Charge.AsSpan(start, image.Width);
        if (settings.Smear is null)
        {
            charge.Clear();
        }

        Mean(electrons, response, dark, charge);
        if (noise is { } source)
        {
            Span<double> uniforms = stackalloc double[NoiseSource.MaxRun];
            for (int first = 0; first < charge.Length; first += NoiseSource.MaxRun)
            {
                Span<double> run = charge.Slice(first, Math.Min(NoiseSource.MaxRun, charge.Length - first));
                source.Fill(NoiseKind.Shot, (uint)(start + first), uniforms[..run.Length]);
                PoissonDeviate.Replace(run, uniforms[..run.Length]);
            }
        }

        return IsAnyAbove(charge, settings.FullWell);
    }

    /// <summary>Adds the electrons to the smear, in proportion to the pixels' responses, and adds the dark electrons.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would otherwise be collected with unoptimised vectors
    private static void Mean(ReadOnlySpan<double> electrons, ReadOnlySpan<float> response, ReadOnlySpan<float> dark, Span<double> charge)
    {
        int column = 0;
        for (; column <= charge.Length - Vector128<float>.Count; column += Vector128<float>.Count)
        {
            Vector256<double> responses = ToDouble(Vector128.Create(response.Slice(column, Vector128<float>.Count)));
            Vector256<double> darks = ToDouble(Vector128.Create(dark.Slice(column, Vector128<float>.Count)));
            Span<double> four = charge.Slice(column, Vector256<double>.Count);
            Vector256<double> light = Vector256.Create(electrons.Slice(column, Vector256<double>.Count)) + Vector256.Create<double>(four);
            ((light * responses) + darks).CopyTo(four);
        }

        for (; column < charge.Length; column++)
        {
            charge[column] = ((electrons[column] + charge[column]) * response[column]) + dark[column];
        }
    }

    private static Vector256<double> ToDouble(Vector128<float> four)
    {
        (Vector128<double> lower, Vector128<double> upper) = Vector128.Widen(four);
        return Vector256.Create(lower, upper);
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private static bool IsAnyAbove(ReadOnlySpan<double> values, double limit)
    {
        int i = 0;
        Vector256<double> isAbove = Vector256<double>.Zero;
        for (; i <= values.Length - Vector256<double>.Count; i += Vector256<double>.Count)
        {
            isAbove |= Vector256.GreaterThan(Vector256.Create(values.Slice(i, Vector256<double>.Count)), Vector256.Create(limit));
        }

        bool isAny = isAbove.ExtractMostSignificantBits() != 0;
        for (; i < values.Length; i++)
        {
            isAny |= values[i] > limit;
        }

        return isAny;
    }

    private void ConvertRow(DetectorImage image, int row, NoiseSource? noise)
    {
        int start = row * image.Width;
        ReadOnlySpan<double> charge = image.Charge.AsSpan(start, image.Width);
        Span<ushort> numbers = image.Numbers.AsSpan(start, image.Width);
        Span<byte> saturated = image.Saturated.AsSpan(start, image.Width);
        Span<double> deviates = stackalloc double[NoiseSource.MaxRun];
        for (int first = 0; first < charge.Length; first += NoiseSource.MaxRun)
        {
            Span<double> chunk = deviates[..Math.Min(NoiseSource.MaxRun, charge.Length - first)];
            chunk.Clear();
            if (noise is { } source && settings.ReadNoise > 0.0)
            {
                NormalDeviate.Fill(source, NoiseKind.Read, (uint)(start + first), chunk);
            }

            _converter.Convert(
                charge.Slice(first, chunk.Length), chunk, pattern.ColumnOffsets.AsSpan(first, chunk.Length),
                numbers.Slice(first, chunk.Length), saturated.Slice(first, chunk.Length));
        }
    }
}
