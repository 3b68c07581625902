using BenchmarkDotNet.Attributes;
using Msisf.Core.Detector;
using Msisf.Core.Detector.Psf;

namespace Msisf.Benchmarks.Micro;

/// <summary>The detector's steps on 1024 x 1024 px with all kinds of noise, on two threads. Asked: PSF 20 ms, noise 15 ms.</summary>
public class DetectorBenchmark
{
    private const int Side = 1024;
    private const int Threads = 2;
    private const int PrimeStep = 7919; // neighbouring pixels have other levels

    private static readonly DetectorSettings Settings = new()
    {
        ApertureArea = 1e-4,
        Band = new Band(500.0, 650.0, new SpectralCurve(0.8), new SpectralCurve(0.45)),
        ExposureTime = 0.01,
        PointSpread = PointSpreadKernel.Of(new AirySpread(1.3), 7.0),
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
    private double[] _light = [];
    private DetectorPass _pass = null!;
    private ulong _frame;

    /// <summary>Electrons of the brightest pixel.</summary>
    [Params(20.0, 20000.0)]
    public double Electrons { get; set; }

    [GlobalSetup]
    public void Prepare()
    {
        int wide = Side + (2 * Settings.PointSpread!.Radius);
        _light = [.. Enumerable.Range(0, wide * wide).Select(i => Electrons * ((long)i * PrimeStep % 1000) / 1000.0)];
        Array.Fill(_throughput, 1.0);
        _pass = new DetectorPass(Settings, new FixedPattern(Settings, Side, Side, Threads));
        Psf();
    }

    [Benchmark]
    public void Psf() => _pass.Expose(_light, _throughput, perSteradian: 1.0, _ => 1.0, _image, Threads, CancellationToken.None);

    [Benchmark]
    public void Noise() => _pass.Read(_image, _frame++, Threads, CancellationToken.None);
}
