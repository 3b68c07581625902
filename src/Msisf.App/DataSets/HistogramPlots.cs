using System.Text;

namespace Msisf.App.DataSets;

/// <summary>Draws histograms as SVG: bars of what was obtained, and a line of what was asked for.</summary>
internal static class HistogramPlots
{
    private const int Columns = 3;
    private const int PlotWidth = 300;
    private const int PlotHeight = 170;
    private const int Left = 20;
    private const int Top = 30;
    private const int BarsWidth = 260;
    private const int BarsHeight = 105;

    /// <summary>Writes all of them side by side.</summary>
    public static void Write(TextWriter writer, IReadOnlyList<Histogram> histograms)
    {
        int rows = (histograms.Count + Columns - 1) / Columns;
        writer.WriteLine(Invariant(
            $"<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{Columns * PlotWidth}\" height=\"{rows * PlotHeight}\" "
                + $"font-family=\"sans-serif\" font-size=\"12\">"));
        writer.WriteLine("<rect width=\"100%\" height=\"100%\" fill=\"white\"/>");
        for (int index = 0; index < histograms.Count; index++)
        {
            writer.WriteLine(Invariant(
                $"<g transform=\"translate({(index % Columns * PlotWidth) + Left},{(index / Columns * PlotHeight) + Top})\">"));
            writer.Write(Plot(histograms[index]));
            writer.WriteLine("</g>");
        }

        writer.WriteLine("</svg>");
    }

    private static string Plot(Histogram histogram)
    {
        StringBuilder text = new();
        string unit = histogram.Unit.Length > 0 ? $" ({histogram.Unit})" : string.Empty;
        Line($"<text y=\"-8\" font-weight=\"bold\">{histogram.Name}{unit}</text>");
        double highest = Math.Max(1.0, Math.Max(histogram.Counts.Max(), histogram.Expected.DefaultIfEmpty().Max()));
        double step = (double)BarsWidth / histogram.Counts.Count;
        for (int bin = 0; bin < histogram.Counts.Count; bin++)
        {
            double height = BarsHeight * histogram.Counts[bin] / highest;
            (double x, double y) = (bin * step, BarsHeight - height);
            Line($"<rect x=\"{x:0.##}\" y=\"{y:0.##}\" width=\"{step - 1.0:0.##}\" height=\"{height:0.##}\" fill=\"#8fa8c8\"/>");
        }

        if (histogram.Expected.Count > 0)
        {
            string points = string.Join(' ', histogram.Expected.Select((count, bin) => Invariant(
                $"{(bin + 0.5) * step:0.##},{BarsHeight * (1.0 - (count / highest)):0.##}")));
            Line($"<polyline points=\"{points}\" fill=\"none\" stroke=\"#c8501e\" stroke-width=\"2\"/>");
        }

        double to = histogram.From + (histogram.Counts.Count * histogram.Width);
        Line($"<text y=\"{BarsHeight + 16}\">{histogram.From:G6}</text>");
        Line($"<text x=\"{BarsWidth}\" y=\"{BarsHeight + 16}\" text-anchor=\"end\">{to:G6}</text>");
        return text.ToString();

        void Line(FormattableString line) => text.Append(line.ToString(CultureInfo.InvariantCulture)).Append('\n');
    }
}
