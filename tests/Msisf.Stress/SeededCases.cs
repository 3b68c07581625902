namespace Msisf.Stress;

/// <summary>Spreads cases over threads so that neither their inputs nor the result depend on how many there are.</summary>
public static class SeededCases
{
    /// <summary>Parts with random numbers of their own.</summary>
    private const int Parts = 256;

    /// <summary>Tries cases.</summary>
    /// <param name="cases">How many.</param>
    /// <param name="seed">Of the random numbers; different for each kind of measure.</param>
    /// <param name="make">Makes an empty measure.</param>
    /// <returns>What all cases showed.</returns>
    public static TMeasure Run<TMeasure>(int cases, int seed, Func<TMeasure> make)
        where TMeasure : IMeasure<TMeasure>
    {
        TMeasure[] measures = new TMeasure[Parts];
        Parallel.For(0, Parts, part =>
        {
            Random random = new(unchecked((seed * 1_000_003) + part));
            TMeasure measure = make();
            for (int number = part; number < cases; number += Parts)
            {
                measure.Try(number, random);
            }

            measures[part] = measure;
        });

        TMeasure all = make();
        foreach (TMeasure measure in measures)
        {
            all.Add(measure);
        }

        return all;
    }
}
