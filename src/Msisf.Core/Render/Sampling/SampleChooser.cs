using Msisf.Core.Render.Shading;
using Msisf.Core.Render.Visibility;

namespace Msisf.Core.Render.Sampling;

/// <summary>
/// Puts the pixels of an image with one sample a pixel into classes, by what the 3 x 3 pixels around show, and gives all pixels of a class
/// the same number of further samples. One object serves many frames.
/// </summary>
internal sealed class SampleChooser
{
    /// <summary>Pixels of a class that are tried with all samples; with fewer the error of the error grows.</summary>
    private const double TrialsOfClass = 120.0;

    /// <summary>The same for classes that matter little for the error that is asked for.</summary>
    private const double TrialsOfMinorClass = 24.0;

    /// <summary>Part of the squared error below which a class matters little.</summary>
    private const double Minor = 0.03;

    /// <summary>The same for classes without contrast: what they hide is rare.</summary>
    private const double TrialsWithoutContrast = 1000.0;

    private readonly List<ContrastWindow> _windows = [];
    private readonly int[] _histogram = new int[PixelClass.Count];
    private ushort[] _levels = [];
    private byte[] _light = [];
    private byte[] _classes = [];
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
    /// <param name="threads">Maximum number of threads.</param>
    /// <param name="cancellation">Cancels the work.</param>
    public void Classify(
        VisibleSurface visible, double[] radianceFactors, PixelSunlight sunlight, AdaptiveSampling sampling, int threads,
        CancellationToken cancellation)
    {
        Begin(visible.Width, visible.Height, threads);
        int bands = Pixels.VectorsOfBand.Length;
        WorkerTeam.Run(threads, bands, (_, band) =>
        {
            Range pixels = PixelsOf(band);
            sampling.Grey.Convert(radianceFactors.AsSpan(pixels), _levels.AsSpan(pixels));
            FindLight(sunlight, pixels, _light.AsSpan(pixels));
        }, cancellation);
        WorkerTeam.Run(threads, bands, (worker, band) => Look(_windows[worker], visible, band), cancellation);
    }

    /// <summary>Chooses the pixels that are tried with all samples, and returns them in their order.</summary>
    /// <param name="error">Rms error that is asked for, levels of 255.</param>
    public List<int> ChooseTrials(double error)
    {
        double allowed = Minor * error * error * _width * _height;
        Span<uint> limits = stackalloc uint[PixelClass.Count];
        for (int i = 0; i < limits.Length; i++)
        {
            double wanted = PixelClass.ContrastOf(i) == 0.0 ? TrialsWithoutContrast
                : _histogram[i] * SampleBudget.ExpectedSquare(i) < allowed ? TrialsOfMinorClass
                : TrialsOfClass;
            limits[i] = (uint)(uint.MaxValue * Math.Min(1.0, wanted / Math.Max(_histogram[i], 1)));
        }

        List<int> trials = [];
        for (int pixel = 0; pixel < _width * _height; pixel++)
        {
            if (Hash((uint)pixel) <= limits[_classes[pixel]])
            {
                trials.Add(pixel);
            }
        }

        return trials;
    }

    /// <summary>The class of a pixel.</summary>
    public byte ClassOf(int pixel) => _classes[pixel];

    /// <summary>Gives some pixels all samples, each with light of its own, and the others none.</summary>
    /// <param name="trials">The pixels.</param>
    public void Try(List<int> trials)
    {
        Array.Clear(Pixels.Codes, 0, _width * _height);
        Array.Clear(Pixels.VectorsOfBand);
        foreach (int pixel in trials)
        {
            Pixels.Codes[pixel] = SamplePattern.MaxVectors | SampledPixels.HasBorder;
            Pixels.VectorsOfBand[pixel / (SampledPixels.BandRows * _width)] += SamplePattern.MaxVectors;
        }
    }

    /// <summary>Gives each pixel the samples of its class; those that were tried have theirs already.</summary>
    public void Spread(ReadOnlyMemory<byte> codes, List<int> trials, int threads, CancellationToken cancellation)
    {
        foreach (int pixel in trials)
        {
            _classes[pixel] = PixelClass.Count;
        }

        WorkerTeam.Run(threads, Pixels.VectorsOfBand.Length, (_, band) =>
        {
            Span<byte> all = stackalloc byte[PixelClass.Count + 1];
            codes.Span.CopyTo(all);
            all[PixelClass.Count] = 0;
            int sum = 0;
            (int first, int count) = PixelsOf(band).GetOffsetAndLength(_width * _height);
            for (int pixel = first; pixel < first + count; pixel++)
            {
                byte code = all[_classes[pixel]];
                Pixels.Codes[pixel] = code;
                sum += code & SampledPixels.Vectors;
            }

            Pixels.VectorsOfBand[band] = sum;
        }, cancellation);
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

    private Range PixelsOf(int band) =>
        (band * SampledPixels.BandRows * _width)..(Math.Min((band + 1) * SampledPixels.BandRows, _height) * _width);

    private void Begin(int width, int height, int threads)
    {
        (_width, _height) = (width, height);
        Pixels.Prepare(width, height);
        if (_levels.Length < width * height)
        {
            _levels = new ushort[width * height];
            _light = new byte[width * height];
            _classes = new byte[width * height];
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
    }

    /// <summary>Finds the classes of a band's pixels.</summary>
    private void Look(ContrastWindow window, VisibleSurface visible, int band)
    {
        Span<int> histogram = stackalloc int[PixelClass.Count];
        histogram.Clear();
        int first = band * SampledPixels.BandRows;
        for (int row = first; row < Math.Min(first + SampledPixels.BandRows, _height); row++)
        {
            int here = row * _width;
            Span<byte> classes = _classes.AsSpan(here, _width);
            Span<byte> codes = Pixels.Codes.AsSpan(here, _width);
            window.Look(_levels, _light, Math.Max(row - 1, 0) * _width, here, Math.Min(row + 1, _height - 1) * _width, classes, codes);
            window.LookAtFacets(visible, row, row == first, codes);
            for (int i = 0; i < classes.Length; i++)
            {
                byte code = codes[i];
                classes[i] = PixelClass.Of(
                    classes[i], (code & ContrastWindow.Mixed) == ContrastWindow.Mixed, (code & ContrastWindow.IsAlone) != 0);
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
