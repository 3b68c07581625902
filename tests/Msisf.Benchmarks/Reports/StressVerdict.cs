using System.Globalization;
using Msisf.Benchmarks.Measures;
using Msisf.Stress;

namespace Msisf.Benchmarks.Reports;

/// <summary>A figure of a stress test in words, or why there is none.</summary>
/// <param name="Figure">The figure; null if the test was not run.</param>
/// <param name="Word">met, missed, stated (without a limit), or not run.</param>
/// <param name="Line">All of it in a line.</param>
internal sealed record StressVerdict(StressFigure? Figure, string Word, string Line)
{
    private const string NotRun = "not run";

    /// <summary>One for each figure; for a test that was not run a single one that says so.</summary>
    public static IEnumerable<StressVerdict> Of(StressTestResult result) => result.Report is StressReport report
        ? report.Figures.Select(Of)
        : [new StressVerdict(null, NotRun, $"{NotRun}, missing: {result.Test.MissingPart}")];

    /// <summary>The worst with its unit, three digits.</summary>
    public static string WorstOf(StressFigure figure) => WithUnit(figure.Worst, figure.Unit);

    /// <summary>The limit with its unit; "-" for none.</summary>
    public static string LimitOf(StressFigure figure) => figure.Limit is double limit ? $"at most {WithUnit(limit, figure.Unit)}" : "-";

    private static StressVerdict Of(StressFigure figure)
    {
        string word = figure.Limit is null ? "stated" : figure.IsKept ? "met" : "missed";
        string found = figure is { Unit: "1", Limit: 1.0 } ? $"{Text(figure.Worst)} of the allowed"
            : figure.Limit is null ? WorstOf(figure)
            : $"{WorstOf(figure)}, {LimitOf(figure)}";
        return new StressVerdict(figure, word, $"{figure.Quantity}: {found}: {word} (worst input: {figure.WorstInput})");
    }

    /// <summary>A number alone has the unit "1", which nobody writes.</summary>
    private static string WithUnit(double value, string unit) => unit is "" or "1" ? Text(value) : $"{Text(value)} {unit}";

    private static string Text(double value) =>
        value.ToString("G3", CultureInfo.InvariantCulture).Replace("E", "e", StringComparison.Ordinal);
}
