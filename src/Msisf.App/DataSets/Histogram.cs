using System.Text;

namespace Msisf.App.DataSets;

/// <summary>How often a number lies in each of some intervals of the same width.</summary>
/// <param name="Unit">Its unit; empty for a ratio.</param>
/// <param name="Asked">The distribution that was asked for; null for a number that follows from others.</param>
/// <param name="Min">Smallest number.</param>
/// <param name="Max">Greatest number.</param>
/// <param name="From">Where the first interval begins.</param>
/// <param name="Width">Width of an interval; 0 if all numbers are the same.</param>
/// <param name="Counts">How many numbers lie in each; the last has its end, too.</param>
internal sealed record Histogram(
    string Name, string Unit, Distribution? Asked, double Min, double Mean, double Max, double From, double Width,
    IReadOnlyList<int> Counts)
{
    private const int Bins = 20;

    /// <summary>Counts numbers, over all of the distribution that was asked for, or from the smallest to the greatest.</summary>
    public static Histogram Of(string name, string unit, Distribution? asked, IReadOnlyList<double> numbers)
    {
        (double min, double max) = (numbers.Min(), numbers.Max());
        (double from, double to) = (Math.Min(min, asked?.Min ?? min), Math.Max(max, asked?.Max ?? max));
        double width = (to - from) / Bins;
        int[] counts = new int[width > 0.0 ? Bins : 1];
        foreach (double number in numbers)
        {
            counts[width > 0.0 ? Math.Clamp((int)((number - from) / width), 0, Bins - 1) : 0]++;
        }

        return new Histogram(name, unit, asked, min, numbers.Average(), max, from, width, counts);
    }

    /// <summary>How many numbers the asked distribution would have in each interval; empty if none was asked for.</summary>
    public IReadOnlyList<double> Expected => Asked is null || Width == 0.0 ? [] :
    [
        .. Counts.Select((_, index) => Counts.Sum()
            * (Asked.PartBelow(From + ((index + 1) * Width)) - Asked.PartBelow(From + (index * Width)))),
    ];

    /// <summary>The histograms of a data set; of a pair its first image counts.</summary>
    public static IReadOnlyList<Histogram> Of(DataSetSpec spec, IReadOnlyList<DrawnState> states)
    {
        List<Histogram> all =
        [
            Of("latitude", "degrees", null, [.. states.Select(state => double.RadiansToDegrees(state.Place.Latitude))]),
            Of("longitude", "degrees", null, [.. states.Select(state => double.RadiansToDegrees(state.Place.Longitude))]),
        ];
        all.AddRange(spec.Distributions
            .Where(entry => entry.Key != Quantity.SunElevation && entry.Key != Quantity.SunAzimuth)
            .OrderBy(entry => entry.Key.Coordinate)
            .Select(entry => Of(entry.Key.Key, entry.Key.Unit, entry.Value, [.. states.Select(state => state.Drawn[entry.Key])])));
        all.Add(Of(
            Quantity.SunElevation.Key, "degrees", spec.Distributions.GetValueOrDefault(Quantity.SunElevation),
            [.. states.Select(state => double.RadiansToDegrees(state.Sun.Elevation))]));
        all.Add(Of("ground", string.Empty, null, [.. states.Select(state => state.Ground)]));
        all.Add(Of("lit", string.Empty, null, [.. states.Select(state => state.Lit)]));
        return all;
    }
}

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
