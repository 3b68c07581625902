using System.Diagnostics;
using Msisf.Benchmarks.Programs;
using Msisf.Benchmarks.Reports;
using Msisf.Stress;

namespace Msisf.Benchmarks.Measures;

/// <summary>Runs stress tests, one after the other: each uses all cores by itself.</summary>
internal static class StressRun
{
    /// <summary>Runs them.</summary>
    /// <param name="length">Of each.</param>
    /// <param name="tests">In the order of the report.</param>
    /// <param name="output">Gets a line for each figure as soon as it is known.</param>
    public static StressResult Measure(StressLength length, IReadOnlyList<IStressTest> tests, TextWriter output)
    {
        List<StressTestResult> results = [];
        foreach (IStressTest test in tests)
        {
            StressTestResult result = Measure(test, length);
            results.Add(result);
            foreach (StressVerdict verdict in StressVerdict.Of(result))
            {
                output.WriteLine($"{test.Name}: {verdict.Line}");
            }
        }

        return new StressResult(Machine.Describe(), results);
    }

    private static StressTestResult Measure(IStressTest test, StressLength length)
    {
        if (test.MissingPart is not null)
        {
            return new StressTestResult(test, null, 0.0);
        }

        Stopwatch watch = Stopwatch.StartNew();
        return new StressTestResult(test, test.Run(length, StressTests.Seed), watch.Elapsed.TotalSeconds);
    }
}
