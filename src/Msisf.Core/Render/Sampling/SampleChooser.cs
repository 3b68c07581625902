using Msisf.Core.Render.Shading;
using Msisf.Core.Render.Visibility;

namespace Msisf.Core.Render.Sampling;

/// <summary>
/// Decides from the image with one sample a pixel how many further samples each pixel gets: in proportion to the contrast of the 3 x 3
/// pixels around it, as few as the error allows. One object serves many frames.
/// </summary>
internal sealed class SampleChooser
{
    /// <summary>px: columns of a block; its rows are those of a band.</summary>
    private const int BlockColumns = 16;

    /// <summary>
    /// Contrast that is assumed where facets are smaller than pixels and all centres around are equally bright, but there is contrast in a
    /// block nearby. Measured (docs/native-renderer.md).
    /// </summary>
    private const byte UnseenContrast = 4;

    /// <summary>
    /// Vectors of samples from which each sample near a dark facet gets light of its own: with fewer, the border of a shadow that lies
    /// between the centres is not what the error comes from.
    /// </summary>
    private const int ManyVectors = 4;

    private readonly List<ContrastWindow> _windows = [];
    private readonly int[] _histogram = new int[ContrastWindow.Contrasts];
    private ushort[] _levels = [];
    private byte[] _light = [];
    private byte[] _contrasts = [];
    private byte[] _isBlockMixed = [];

    /// <summary>The choice.</summary>
    public SampledPixels Pixels { get; } = new();

    /// <summary>Chooses.</summary>
    /// <param name="visible">What the pixels' centres show.</param>
    /// <param name="radianceFactors">I/F of each pixel's centre.</param>
    /// <param name="sunlight">The light there.</param>
    /// <param name="sampling">Error and grey levels.</param>
    /// <param name="threads">Maximum number of threads.</param>
    /// <param name="cancellation">Cancels the work.</param>
    public void Choose(
        VisibleSurface visible, double[] radianceFactors, PixelSunlight sunlight, AdaptiveSampling sampling, int threads,
        CancellationToken cancellation)
    {
        (int width, int height) = (visible.Width, visible.Height);
        int bands = Begin(width, height, threads);
        (int First, int End) RowsOf(int band) => (band * SampledPixels.BandRows, Math.Min((band + 1) * SampledPixels.BandRows, height));
        WorkerTeam.Run(threads, bands, (_, band) =>
        {
            (int first, int end) = RowsOf(band);
            Range pixels = (first * width)..(end * width);
            sampling.Grey.Convert(radianceFactors.AsSpan(pixels), _levels.AsSpan(pixels));
            FindLight(sunlight, first * width, _light.AsSpan(pixels));
        }, cancellation);
        WorkerTeam.Run(threads, bands, (worker, band) => Look(_windows[worker], visible, RowsOf(band), band), cancellation);
        WorkerTeam.Run(threads, bands, (_, band) => Count(width, bands, RowsOf(band), band), cancellation);
        byte[] vectors = SampleBudget.VectorsOf(_histogram, sampling.Error);
        WorkerTeam.Run(threads, bands, (_, band) =>
        {
            (int first, int end) = RowsOf(band);
            int sum = 0;
            for (int pixel = first * width; pixel < end * width; pixel++)
            {
                byte chosen = vectors[_contrasts[pixel]];
                byte code = Pixels.Codes[pixel];
                bool isSplit = (code & SampledPixels.HasBorder) != 0 || (chosen >= ManyVectors && (code & ContrastWindow.Away) != 0);
                Pixels.Codes[pixel] = chosen == 0 ? (byte)0 : isSplit ? (byte)(chosen | SampledPixels.HasBorder) : chosen;
                sum += chosen;
            }

            Pixels.VectorsOfBand[band] = sum;
        }, cancellation);
    }

    private static void FindLight(PixelSunlight sunlight, int first, Span<byte> light)
    {
        ReadOnlySpan<double> cosines = sunlight.CosIncidence.AsSpan(first, light.Length);
        if (sunlight.VisibleFractions.Length > 0)
        {
            ReadOnlySpan<double> fractions = sunlight.VisibleFractions.AsSpan(first, light.Length);
            for (int i = 0; i < light.Length; i++)
            {
                light[i] = (byte)((fractions[i] > 0.0 ? ContrastWindow.Lit : 0)
                    | (fractions[i] < 1.0 ? (cosines[i] > 0.0 ? ContrastWindow.Hidden : ContrastWindow.Away) : 0));
            }

            return;
        }

        ReadOnlySpan<byte> hidden = sunlight.Hidden.AsSpan(first, light.Length);
        for (int i = 0; i < light.Length; i++)
        {
            light[i] = !(cosines[i] > 0.0) ? ContrastWindow.Away : hidden[i] == 0 ? ContrastWindow.Lit : ContrastWindow.Hidden;
        }
    }

    private static int BlocksAcross(int width) => (width + BlockColumns - 1) / BlockColumns;

    private int Begin(int width, int height, int threads)
    {
        Pixels.Prepare(width, height);
        if (_levels.Length < width * height)
        {
            _levels = new ushort[width * height];
            _light = new byte[width * height];
            _contrasts = new byte[width * height];
        }

        int bands = Pixels.VectorsOfBand.Length;
        if (_isBlockMixed.Length < bands * BlocksAcross(width))
        {
            _isBlockMixed = new byte[bands * BlocksAcross(width)];
        }

        while (_windows.Count < threads)
        {
            _windows.Add(new ContrastWindow());
        }

        foreach (ContrastWindow window in _windows)
        {
            window.Begin(width);
        }

        Array.Clear(_histogram);
        return bands;
    }

    /// <summary>Finds contrasts, facets and the borders of shadows around the pixels of a band.</summary>
    private void Look(ContrastWindow window, VisibleSurface visible, (int First, int End) rows, int band)
    {
        (int width, int height) = (visible.Width, visible.Height);
        Span<byte> isBlockMixed = _isBlockMixed.AsSpan(band * BlocksAcross(width), BlocksAcross(width));
        isBlockMixed.Clear();
        for (int row = rows.First; row < rows.End; row++)
        {
            int here = row * width;
            Span<byte> contrasts = _contrasts.AsSpan(here, width);
            window.Look(
                _levels, _light, Math.Max(row - 1, 0) * width, here, Math.Min(row + 1, height - 1) * width, contrasts,
                Pixels.Codes.AsSpan(here, width));
            window.LookAtFacets(visible, row, row == rows.First, Pixels.Codes.AsSpan(here, width));
            for (int block = 0; block < isBlockMixed.Length; block++)
            {
                int first = block * BlockColumns;
                isBlockMixed[block] |= contrasts[first..Math.Min(first + BlockColumns, width)].ContainsAnyExceptInRange((byte)0, (byte)1)
                    ? (byte)1
                    : (byte)0;
            }
        }
    }

    /// <summary>Counts the contrasts of a band, with those that may be hidden between the pixels' centres.</summary>
    private void Count(int width, int bands, (int First, int End) rows, int band)
    {
        Span<int> histogram = stackalloc int[ContrastWindow.Contrasts];
        histogram.Clear();
        int blocks = BlocksAcross(width);
        for (int block = 0; block < blocks; block++)
        {
            bool isNear = false;
            for (int other = Math.Max(band - 1, 0); other <= Math.Min(band + 1, bands - 1); other++)
            {
                int first = Math.Max(block - 1, 0);
                isNear |= _isBlockMixed.AsSpan((other * blocks) + first, Math.Min(block + 2, blocks) - first).Contains((byte)1);
            }

            for (int row = rows.First; row < rows.End; row++)
            {
                int end = (row * width) + Math.Min((block + 1) * BlockColumns, width);
                for (int pixel = (row * width) + (block * BlockColumns); pixel < end; pixel++)
                {
                    byte code = Pixels.Codes[pixel];
                    if (isNear && (code & ContrastWindow.IsAlone) != 0 && _contrasts[pixel] < UnseenContrast)
                    {
                        _contrasts[pixel] = UnseenContrast;
                    }

                    histogram[_contrasts[pixel]]++;
                }
            }
        }

        lock (_histogram)
        {
            for (int contrast = 0; contrast < histogram.Length; contrast++)
            {
                _histogram[contrast] += histogram[contrast]; // whole numbers: their order has no influence
            }
        }
    }
}
