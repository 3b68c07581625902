using System.Globalization;
using Msisf.Adapters.IO;
using Msisf.Benchmarks.Measures;

namespace Msisf.Benchmarks.Reports;

/// <summary>The files of a run, which benchmark.sh takes into docs/.</summary>
internal static class ResultFiles
{
    public static void Write(string folder, BenchmarkResult result)
    {
        Directory.CreateDirectory(folder);
        AtomicFile.WriteText(Path.Combine(folder, "tables.md"), writer => writer.Write(MarkdownReport.Write(result)));
        AtomicFile.WriteText(Path.Combine(folder, "figures.csv"), writer => writer.Write(FigureList.ToTable(result).ToCsv()));
        AtomicFile.WriteText(Path.Combine(folder, "front.csv"), writer => writer.Write(FrontFigures.ToTable(result.Fronts).ToCsv()));
        AtomicFile.WriteText(Path.Combine(folder, "targets.csv"), writer => writer.Write(Targets(result).ToCsv()));
    }

    private static Table Targets(BenchmarkResult result)
    {
        Table table = new("scene", "figure", "unit", "bound", "target", "measured", "best", "verdict");
        foreach (Verdict verdict in Verdicts.Of(result))
        {
            table.Add(
                verdict.Scene,
                verdict.Quantity,
                verdict.Unit.Name,
                verdict.IsUpperLimit ? "at most" : "at least",
                Number(verdict.Limit * verdict.Unit.PerSi),
                Number(verdict.Measured * verdict.Unit.PerSi),
                Number(verdict.Best * verdict.Unit.PerSi),
                verdict.Word);
        }

        return table;
    }

    private static string Number(double value) => value.ToString("G6", CultureInfo.InvariantCulture);
}
