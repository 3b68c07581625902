using System.Globalization;
using Msisf.Adapters.IO;
using Msisf.Benchmarks.Measures;
using Msisf.Stress;

namespace Msisf.Benchmarks.Reports;

/// <summary>The files of a run of the stress tests, which benchmark.sh takes into docs/.</summary>
internal static class StressFiles
{
    public static void Write(string folder, StressResult result)
    {
        Directory.CreateDirectory(folder);
        AtomicFile.WriteText(Path.Combine(folder, "tables.md"), writer => writer.Write(StressMarkdown.Write(result)));
        AtomicFile.WriteText(
            Path.Combine(folder, "stress.csv"),
            writer => writer.Write(Figures(result.Tests.Where(test => !test.Test.IsOfThisMachine)).ToCsv()));
        AtomicFile.WriteText(
            Path.Combine(folder, "stress_machine.csv"),
            writer => writer.Write(Figures(result.Tests.Where(test => test.Test.IsOfThisMachine)).ToCsv()));
        AtomicFile.WriteText(Path.Combine(folder, "stress_series.csv"), writer => writer.Write(Series(result).ToCsv()));
    }

    private static Table Figures(IEnumerable<StressTestResult> tests)
    {
        Table table = new("test", "cases", "quantity", "unit", "limit", "worst", "verdict", "input");
        foreach (StressTestResult test in tests)
        {
            foreach (StressVerdict verdict in StressVerdict.Of(test))
            {
                table.Add(
                    test.Test.Name,
                    test.Report is StressReport report ? Number(report.Cases) : string.Empty,
                    verdict.Figure?.Quantity ?? string.Empty,
                    verdict.Figure?.Unit ?? string.Empty,
                    verdict.Figure?.Limit is double limit ? Number(limit) : string.Empty,
                    verdict.Figure is StressFigure figure ? Number(figure.Worst) : string.Empty,
                    verdict.Word,
                    verdict.Figure?.WorstInput ?? $"missing: {test.Test.MissingPart}");
            }
        }

        return table;
    }

    /// <summary>A line for each bin; "number" counts the series of a test from 1 and is in the name of its plot.</summary>
    private static Table Series(StressResult result)
    {
        Table table = new(
            "test", "number", "quantity", "unit", "input", "input_unit", "scale", "limit", "from", "to", "count", "mean", "worst");
        foreach (StressReport report in result.Tests.Select(test => test.Report).OfType<StressReport>())
        {
            for (int index = 0; index < report.Series.Count; index++)
            {
                StressSeries series = report.Series[index];
                foreach (StressBin bin in series.Bins)
                {
                    table.Add(
                        report.Name, Number(index + 1), series.Quantity, series.Unit, series.Input, series.InputUnit,
                        series.IsInputLogarithmic ? "log" : "linear",
                        series.Limit is double limit ? Number(limit) : string.Empty,
                        Number(bin.From), Number(bin.To), Number(bin.Count), Number(bin.Mean), Number(bin.Worst));
                }
            }
        }

        return table;
    }

    private static string Number(double value) => value.ToString("R", CultureInfo.InvariantCulture);
}
