using Msisf.Core.Camera;
using Msisf.Core.Detector;
using Msisf.Core.Detector.Noise;
using Msisf.Core.Detector.Psf;

namespace Msisf.Benchmarks.Measures;

/// <summary>The detector on 1024 x 1024 px with all kinds of noise, on two threads.</summary>
internal sealed class DetectorChain
{
    private const int Side = 1024;
    private const int Threads = 2;
    private const int PrimeStep = 7919; // neighbouring pixels have other levels

    private static readonly DetectorSettings WithoutSpread = new()
    {
        ApertureArea = 1e-4,
        Response = new SpectralResponse(500.0, 650.0, new SpectralCurve(0.8), new SpectralCurve(0.45)),
        ExposureTime = 0.01,
        ResponseNonuniformity = 0.01,
        Dark = new DarkCurrent { Rate = 100.0, Nonuniformity = 0.2 },
        Gain = 10.0,
        ReadNoise = 12.0,
        Bias = 64.0,
        ColumnOffset = 1.0,
        FullWell = 40000.0,
        IsBlooming = true,
        ConverterBits = 12,
        Seed = 1,
    };

    private readonly double[] _throughput = new double[Side * Side];
    private readonly DetectorImage _image = new(Side, Side);
    private readonly double[] _light;
    private readonly DetectorPass _pass;
    private ulong _frame;

    /// <summary>Prepares a detector and exposes it once.</summary>
    /// <param name="spread">The point spread function; it ends at 7 px, in a kernel of 15 x 15 px.</param>
    /// <param name="electrons">Electrons of the brightest pixel.</param>
    public DetectorChain(IRadialSpread spread, double electrons)
    {
        DetectorSettings settings = WithoutSpread with { PointSpread = PointSpreadKernel.Of(spread, 7.0) };
        int wide = Side + (2 * settings.PointSpread.Radius);
        _light = [.. Enumerable.Range(0, wide * wide).Select(i => electrons * ((long)i * PrimeStep % 1000) / 1000.0)];
        Array.Fill(_throughput, 1.0);
        _pass = new DetectorPass(settings, new FixedPattern(settings, Side, Side, Threads));
        Spread();
    }

    /// <summary>Applies the point spread function to a frame.</summary>
    public void Spread()
    {
        Array.Clear(_image.Electrons);
        _pass.Expose(_light, _throughput, _ => 1.0, _ => 1.0, new PixelRows(0, Side), _image, Threads, CancellationToken.None);
    }

    /// <summary>Adds all noise and converts to numbers.</summary>
    public void Read() => _pass.Read(_image, NoiseSource.OfFrame(1, _frame++), Threads, CancellationToken.None);
}
