using Msisf.Core.Parallel;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Shading;
using Msisf.Core.Render.Visibility;

namespace Msisf.Core.Render.Sampling;

/// <summary>
/// Puts the pixels of an image with one sample a pixel into classes, by what the 3 x 3 pixels around show, and gives all pixels of a class
/// the same number of further samples. One object serves many frames.
/// </summary>
internal sealed class SampleChooser
{
    /// <summary>Rows that a thread looks at together.</summary>
    private const int BandRows = 32;

    /// <summary>Pixels of a class that are tried with all samples; with fewer the error of the error grows.</summary>
    private const double TrialsOfClass = 80.0;

    /// <summary>The same for classes that matter little for the error that is asked for.</summary>
    private const double TrialsOfMinorClass = 16.0;

    /// <summary>Part of the squared error below which a class matters little.</summary>
    private const double Minor = 0.03;

    /// <summary>The same for classes without contrast: what they hide is rare.</summary>
    private const double TrialsWithoutContrast = 1000.0;

    private readonly List<(ContrastWindow Contrasts, FacetAreas Areas)> _windows = [];
    private readonly int[] _histogram = new int[PixelClass.Count];
    private ushort[] _levels = [];
    private byte[] _light = [];
    private byte[] _classes = [];
    private double[] _means = [];
    private int _width;
    private int _height;

    /// <summary>The choice.</summary>
    public SampledPixels Pixels { get; } = new();

    /// <summary>Number of pixels of each class.</summary>
    public ReadOnlySpan<int> Histogram => _histogram;

    /// <summary>Finds the classes.</summary>
    /// <param name="visible">What the pixels' centres show.</param>
    /// <param name="radianceFactors">I/F of each pixel's centre.</param>
    /// <param name="sunlight">The light there.</param>
    /// <param name="sampling">Error and grey levels.</param>
    public void Classify(
        VisibleSurface visible, double[] radianceFactors, PixelSunlight sunlight, AdaptiveSampling sampling, int threads,
        CancellationToken cancellation)
    {
        Begin(visible.Width, visible.Height, threads);
        int bands = BandCount;
        int minContrast = SampleBudget.MinContrast(sampling.Error);
        WorkerTeam.Run(threads, bands, (_, band) =>
        {
            Range pixels = PixelsOf(band);
            sampling.Grey.Convert(radianceFactors.AsSpan(pixels), _levels.AsSpan(pixels));
            FindLight(sunlight, pixels, _light.AsSpan(pixels));
        }, cancellation);
        WorkerTeam.Run(threads, bands, (worker, band) => Look(_windows[worker], visible, radianceFactors, minContrast, band), cancellation);
    }

    /// <summary>Chooses the pixels that are tried with all samples, and returns them in their order.</summary>
    /// <param name="error">Rms error that is asked for, levels of 255.</param>
    public List<int> ChooseTrials(double error, int threads, CancellationToken cancellation)
    {
        double allowed = Minor * error * error * _width * _height;
        uint[] limits = new uint[PixelClass.Count];
        for (int i = 0; i < limits.Length; i++)
        {
            double wanted = PixelClass.ContrastOf(i) == 0.0 ? TrialsWithoutContrast
                : _histogram[i] * SampleBudget.ExpectedSquare(i) < allowed ? TrialsOfMinorClass
                : TrialsOfClass;
            limits[i] = (uint)(uint.MaxValue * Math.Min(1.0, wanted / Math.Max(_histogram[i], 1)));
        }

        List<int>[] ofBands = new List<int>[BandCount];
        WorkerTeam.Run(threads, ofBands.Length, (_, band) => ofBands[band] = ChosenIn(PixelsOf(band), limits), cancellation);
        return [.. ofBands.SelectMany(pixels => pixels)];
    }

    public byte ClassOf(int pixel) => _classes[pixel];

    /// <summary>I/F of each pixel by the areas of its facets, where its class offers it.</summary>
    public ReadOnlySpan<double> Means => _means;

    /// <summary>Gives some pixels all samples, each with light of its own, and the others none.</summary>
    public void Try(List<int> trials)
    {
        Array.Clear(Pixels.Codes, 0, _width * _height);
        Array.Clear(Pixels.VectorsOfRow);
        foreach (int pixel in trials)
        {
            Pixels.Codes[pixel] = SamplePattern.StratifiedVectors | SampledPixels.HasBorder;
            Pixels.VectorsOfRow[pixel / _width] += SamplePattern.StratifiedVectors;
        }

        Pixels.Cut();
    }

    /// <summary>
    /// Gives each pixel the samples of its class, or the brightness by the areas of its facets; those that were tried have theirs already.
    /// </summary>
    /// <param name="trials">The pixels that were tried.</param>
    /// <param name="radianceFactors">I/F of the pixels.</param>
    public void Spread(
        ReadOnlyMemory<byte> codes, List<int> trials, double[] radianceFactors, int threads, CancellationToken cancellation)
    {
        foreach (int pixel in trials)
        {
            _classes[pixel] = PixelClass.Count;
        }

        WorkerTeam.Run(threads, BandCount, (_, band) =>
        {
            Span<byte> all = stackalloc byte[PixelClass.Count + 1];
            codes.Span.CopyTo(all);
            all[PixelClass.Count] = 0;
            for (int row = band * BandRows; row < Math.Min((band + 1) * BandRows, _height); row++)
            {
                Pixels.VectorsOfRow[row] = Spread(all, row * _width, radianceFactors);
            }
        }, cancellation);
        Pixels.Cut();
    }

    /// <summary>Sets the codes of a row and returns their number of vectors.</summary>
    private int Spread(ReadOnlySpan<byte> codes, int first, double[] radianceFactors)
    {
        int vectors = 0;
        for (int pixel = first; pixel < first + _width; pixel++)
        {
            byte code = codes[_classes[pixel]];
            bool isByAreas = code == SampleBudget.Areas;
            radianceFactors[pixel] = isByAreas ? _means[pixel] : radianceFactors[pixel];
            Pixels.Codes[pixel] = isByAreas ? (byte)0 : code;
            vectors += code & SampledPixels.Vectors;
        }

        return vectors;
    }

    /// <summary>Pixels whose hash is at most the limit of their class.</summary>
    private List<int> ChosenIn(Range pixels, uint[] limits)
    {
        List<int> chosen = [];
        (int first, int count) = pixels.GetOffsetAndLength(_width * _height);
        for (int pixel = first; pixel < first + count; pixel++)
        {
            if (Hash((uint)pixel) <= limits[_classes[pixel]])
            {
                chosen.Add(pixel);
            }
        }

        return chosen;
    }

    private static void FindLight(PixelSunlight sunlight, Range pixels, Span<byte> light)
    {
        ReadOnlySpan<double> cosines = sunlight.CosIncidence.AsSpan(pixels);
        if (sunlight.VisibleFractions.Length > 0)
        {
            ReadOnlySpan<double> fractions = sunlight.VisibleFractions.AsSpan(pixels);
            for (int i = 0; i < light.Length; i++)
            {
                light[i] = (byte)((fractions[i] > 0.0 ? ContrastWindow.Lit : 0) | (fractions[i] < 1.0 ? ContrastWindow.Dark : 0));
            }

            return;
        }

        ReadOnlySpan<byte> hidden = sunlight.Hidden.AsSpan(pixels);
        for (int i = 0; i < light.Length; i++)
        {
            light[i] = cosines[i] > 0.0 && hidden[i] == 0 ? ContrastWindow.Lit : ContrastWindow.Dark;
        }
    }

    /// <summary>A number without relation to the pixel's place (the finaliser of MurmurHash3, by A. Appleby, public domain).</summary>
    private static uint Hash(uint pixel)
    {
        uint hash = pixel + 0x9e3779b9;
        hash = (hash ^ (hash >> 16)) * 0x85ebca6b;
        hash = (hash ^ (hash >> 13)) * 0xc2b2ae35;
        return hash ^ (hash >> 16);
    }

    private int BandCount => (_height + BandRows - 1) / BandRows;

    private Range PixelsOf(int band) => (band * BandRows * _width)..(Math.Min((band + 1) * BandRows, _height) * _width);

    private void Begin(int width, int height, int threads)
    {
        (_width, _height) = (width, height);
        Pixels.Prepare(SamplePattern.Stratified, width, height);
        if (_levels.Length < width * height)
        {
            _levels = new ushort[width * height];
            _light = new byte[width * height];
            _classes = new byte[width * height];
            _means = new double[width * height];
        }

        while (_windows.Count < threads)
        {
            _windows.Add((new ContrastWindow(), new FacetAreas()));
        }

        foreach ((ContrastWindow contrasts, _) in _windows)
        {
            contrasts.Begin(width);
        }

        Array.Clear(_histogram);
    }

    /// <summary>Finds the classes of a band's pixels.</summary>
    private void Look(
        (ContrastWindow Contrasts, FacetAreas Areas) windows, VisibleSurface visible, double[] factors, int minContrast, int band)
    {
        Span<int> histogram = stackalloc int[PixelClass.Count];
        histogram.Clear();
        int first = band * BandRows;
        for (int row = first; row < Math.Min(first + BandRows, _height); row++)
        {
            int here = row * _width;
            Span<byte> classes = _classes.AsSpan(here, _width);
            Span<byte> codes = Pixels.Codes.AsSpan(here, _width);
            windows.Contrasts.Look(
                _levels, _light, Math.Max(row - 1, 0) * _width, here, Math.Min(row + 1, _height - 1) * _width, classes, codes);
            windows.Areas.Look(visible, row, row == first, classes, minContrast, factors, _means.AsSpan(here, _width));
            ReadOnlySpan<FacetsAround> kinds = windows.Areas.Kinds[..classes.Length];
            for (int i = 0; i < classes.Length; i++)
            {
                classes[i] = PixelClass.Of(classes[i], codes[i] == ContrastWindow.Mixed, kinds[i]);
                histogram[classes[i]]++;
            }
        }

        lock (_histogram)
        {
            for (int i = 0; i < histogram.Length; i++)
            {
                _histogram[i] += histogram[i]; // whole numbers: their order has no influence
            }
        }
    }
}
