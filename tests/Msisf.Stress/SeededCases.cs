namespace Msisf.Stress;

/// <summary>Shares the cases of a test among the cores. How they are cut does not depend on the machine, nor does the result.</summary>
public static class SeededCases
{
    /// <summary>Enough for many cores, few enough that merging costs nothing. Each has random numbers of its own.</summary>
    private const int Parts = 64;

    /// <summary>Tries all cases.</summary>
    /// <param name="cases">How many.</param>
    /// <param name="seed">Of the random numbers; different for each measure of a test.</param>
    /// <param name="make">Makes an empty measure.</param>
    /// <returns>What all cases showed, merged in their order.</returns>
    public static TMeasure Run<TMeasure>(int cases, int seed, Func<TMeasure> make)
        where TMeasure : IMeasure<TMeasure>
    {
        TMeasure[] measures = new TMeasure[Parts];
        Parallel.For(0, Parts, part =>
        {
            CaseRandom random = new(seed, part);
            TMeasure measure = make();
            int end = Start(part + 1, cases);
            for (int number = Start(part, cases); number < end; number++)
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

    private static int Start(int part, int cases) => (int)((long)cases * part / Parts);
}
