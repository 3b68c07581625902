using System.Globalization;
using System.Text;
using Msisf.Benchmarks.Measures;
using Msisf.Stress;

namespace Msisf.Benchmarks.Reports;

/// <summary>The tables and plots for results/accuracy-tables.md.</summary>
internal static class StressMarkdown
{
    public static string Write(StressResult result)
    {
        StringBuilder text = new();
        text.Append(result.Machine).Append("\n\n").Append(Overview(result).ToMarkdown());
        foreach (StressTestResult test in result.Tests)
        {
            Append(text, test);
        }

        return text.ToString();
    }

    /// <summary>The name of the plot of a series, as tests/Msisf.Benchmarks/plots/accuracy.py writes it.</summary>
    private static string PlotOf(string test, int number) => string.Create(CultureInfo.InvariantCulture, $"stress_{test}_{number}.svg");

    private static Table Overview(StressResult result)
    {
        Table table = new("test", "cases", "s", "limits met", "missed", "stated without a limit");
        foreach (StressTestResult test in result.Tests)
        {
            string[] words = [.. StressVerdict.Of(test).Select(verdict => verdict.Word)];
            table.Add(
                test.Test.Name,
                test.Report is StressReport report ? Number(report.Cases) : "not run",
                test.Report is null ? "-" : Number((long)Math.Ceiling(test.Seconds)),
                Number(words.Count(word => word == "met")),
                Number(words.Count(word => word == "missed")),
                Number(words.Count(word => word == "stated")));
        }

        return table;
    }

    private static void Append(StringBuilder text, StressTestResult result)
    {
        text.Append("\n### ").Append(result.Test.Name).Append("\n\n").Append(result.Test.Subject).Append("\n\n");
        if (result.Report is not StressReport report)
        {
            text.Append("Not run, missing: ").Append(result.Test.MissingPart).Append(".\n");
            return;
        }

        Table table = new("quantity", "limit", "worst", "", "input that shows it");
        foreach (StressVerdict verdict in StressVerdict.Of(result))
        {
            StressFigure figure = verdict.Figure!;
            table.Add(
                figure.Quantity, StressVerdict.LimitOf(figure), StressVerdict.WorstOf(figure), verdict.Word,
                $"`{Escaped(figure.WorstInput)}`");
        }

        text.Append(table.ToMarkdown());
        for (int index = 0; index < report.Series.Count; index++)
        {
            StressSeries series = report.Series[index];
            text.Append("\n![").Append(report.Name).Append(": ").Append(
                series.Quantity).Append(" over ").Append(series.Input).Append("](")
                .Append(PlotOf(report.Name, index + 1)).Append(")\n");
        }
    }

    private static string Escaped(string cell) => cell.Replace("|", "\\|", StringComparison.Ordinal);

    private static string Number(long value) => value.ToString(CultureInfo.InvariantCulture);
}
