using BenchmarkDotNet.Attributes;
using Msisf.Benchmarks.Measures;
using Msisf.Core.Detector.Psf;

namespace Msisf.Benchmarks.Micro;

/// <summary>The detector's steps, see <see cref="DetectorChain"/>.</summary>
public class DetectorBenchmark
{
    private DetectorChain _chain = null!;

    /// <summary>Electrons of the brightest pixel.</summary>
    [Params(20.0, 20000.0)]
    public double Electrons { get; set; }

    [GlobalSetup]
    public void Prepare() => _chain = new DetectorChain(new AirySpread(1.3), Electrons);

    [Benchmark]
    public void Psf() => _chain.Spread();

    [Benchmark]
    public void Noise() => _chain.Read();
}
