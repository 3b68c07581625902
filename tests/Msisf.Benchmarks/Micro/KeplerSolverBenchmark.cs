using BenchmarkDotNet.Attributes;
using Msisf.Core.Orbit;

namespace Msisf.Benchmarks.Micro;

/// <summary>Kepler's equation for a circle, an ellipse and nearly a parabola; each call has another mean anomaly.</summary>
public class KeplerSolverBenchmark
{
    private const double Step = 0.618; // rad: never the same place again

    private double _meanAnomaly;

    [Params(0.0, 0.3, 0.999999)]
    public double Eccentricity { get; set; }

    [Benchmark]
    public EccentricAnomaly Solve() => KeplerSolver.Solve(_meanAnomaly += Step, Eccentricity);
}
