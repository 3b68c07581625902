using Msisf.Core.Render.Photometry;
using Msisf.Core.Render.Shading;
using Msisf.Core.Render.Visibility;

namespace Msisf.Core.Render.Sampling;

/// <summary>
/// Decides from the image with one sample a pixel how many further samples each pixel gets: in proportion to the contrast of the 3 x 3
/// pixels around it, as few as the error allows. One object serves many frames.
/// </summary>
internal sealed class SampleChooser
{
    /// <summary>Levels of 65535 in a level of 255.</summary>
    private const int Fine = 257;

    private const int Contrasts = 256;

    private ushort[] _levels = [];
    private byte[] _contrasts = [];
    private int[] _histogram = [];

    /// <summary>The choice.</summary>
    public SampledPixels Pixels { get; } = new();

    /// <summary>Chooses.</summary>
    /// <param name="width">px.</param>
    /// <param name="height">px.</param>
    /// <param name="radianceFactors">I/F of each pixel's centre.</param>
    /// <param name="sunlight">The light there.</param>
    /// <param name="sampling">Error and grey levels.</param>
    /// <param name="threads">Maximum number of threads.</param>
    /// <param name="cancellation">Cancels the work.</param>
    public void Choose(
        int width, int height, double[] radianceFactors, PixelSunlight sunlight, AdaptiveSampling sampling, int threads,
        CancellationToken cancellation)
    {
        Pixels.Prepare(width, height);
        if (_levels.Length < width * height)
        {
            _levels = new ushort[width * height];
            _contrasts = new byte[width * height];
        }

        int[] histogram = new int[Contrasts];
        int bands = Pixels.VectorsOfBand.Length;
        WorkerTeam.Run(threads, bands, (_, band) =>
        {
            int first = band * SampledPixels.BandRows * width;
            int count = Math.Min((band + 1) * SampledPixels.BandRows, height) * width - first;
            sampling.Grey.Convert(radianceFactors.AsSpan(first, count), _levels.AsSpan(first, count));
        }, cancellation);
        WorkerTeam.Run(threads, bands, (_, band) =>
        {
            int[] ofBand = new int[Contrasts];
            for (int row = band * SampledPixels.BandRows; row < Math.Min((band + 1) * SampledPixels.BandRows, height); row++)
            {
                FindContrasts(width, height, row, sunlight, ofBand);
            }

            lock (histogram)
            {
                for (int contrast = 0; contrast < Contrasts; contrast++)
                {
                    histogram[contrast] += ofBand[contrast]; // whole numbers: the order has no influence
                }
            }
        }, cancellation);
        byte[] vectors = SampleBudget.VectorsOf(histogram, sampling.Error);
        WorkerTeam.Run(threads, bands, (_, band) =>
        {
            int sum = 0;
            for (int i = band * SampledPixels.BandRows * width; i < Math.Min((band + 1) * SampledPixels.BandRows, height) * width; i++)
            {
                byte chosen = vectors[_contrasts[i]];
                Pixels.Codes[i] = chosen == 0 ? (byte)0 : (byte)(chosen | Pixels.Codes[i]);
                sum += chosen;
            }

            Pixels.VectorsOfBand[band] = sum;
        }, cancellation);
    }

    private void FindContrasts(int width, int height, int row, PixelSunlight sunlight, int[] histogram)
    {
        int above = Math.Max(row - 1, 0) * width;
        int here = row * width;
        int below = Math.Min(row + 1, height - 1) * width;
        for (int column = 0; column < width; column++)
        {
            int min = int.MaxValue;
            int max = int.MinValue;
            bool isAnyLit = false;
            bool isAnyHidden = false;
            int end = Math.Min(column + 1, width - 1);
            for (int x = Math.Max(column - 1, 0); x <= end; x++)
            {
                min = Math.Min(min, Math.Min(_levels[above + x], Math.Min(_levels[here + x], _levels[below + x])));
                max = Math.Max(max, Math.Max(_levels[above + x], Math.Max(_levels[here + x], _levels[below + x])));
            }

            int contrast = Math.Min(Contrasts - 1, (max - min + Fine - 1) / Fine);
            _contrasts[here + column] = (byte)contrast;
            histogram[contrast]++;
            bool hasBorder = false;
            if (contrast > 0)
            {
                for (int x = Math.Max(column - 1, 0); x <= end; x++)
                {
                    Look(sunlight, above + x, ref isAnyLit, ref isAnyHidden);
                    Look(sunlight, here + x, ref isAnyLit, ref isAnyHidden);
                    Look(sunlight, below + x, ref isAnyLit, ref isAnyHidden);
                }

                hasBorder = isAnyLit && isAnyHidden;
            }

            Pixels.Codes[here + column] = hasBorder ? SampledPixels.HasBorder : (byte)0;
        }
    }

    private static void Look(PixelSunlight sunlight, int pixel, ref bool isAnyLit, ref bool isAnyHidden)
    {
        if (sunlight.VisibleFractions.Length > 0)
        {
            double fraction = sunlight.VisibleFractions[pixel];
            isAnyLit |= fraction > 0.0;
            isAnyHidden |= sunlight.CosIncidence[pixel] > 0.0 && fraction < 1.0;
        }
        else if (sunlight.CosIncidence[pixel] > 0.0)
        {
            isAnyLit |= sunlight.Hidden[pixel] == 0;
            isAnyHidden |= sunlight.Hidden[pixel] != 0;
        }
    }
}
