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
