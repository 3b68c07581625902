using Msisf.Core.Navigation;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Catalogues;

/// <summary>
/// Reads catalogues of craters in CSV: those of Head et al. (2010) and Povilaitis et al. (2018) as DeepMoon has them, Robbins (2018), and
/// the IAU's list of names, and lists like them. Columns are known by their names; diameters are in km, or in m where the name says it.
/// </summary>
public static class CraterCatalogueReader
{
    /// <summary>Craters that are kept of a catalogue to look at, the largest: more than a picture can show.</summary>
    public const int MostCraters = 50_000;

    /// <summary>Craters that a run can have: about 0.3 kB of memory each. Robbins's catalogue has 1.3 million.</summary>
    public const int MostCratersOfRun = 2_000_000;

    private const string Needed = "A catalogue of craters";

    /// <summary>Reads a catalogue to look at.</summary>
    /// <returns>The largest craters, at most <see cref="MostCraters"/>, the largest first.</returns>
    /// <exception cref="BadInputException">It can't be read, or a value is wrong; the message names file and line.</exception>
    public static IReadOnlyList<Crater> ReadLargest(string path) =>
        ListTable.Read(path, Needed, reader => ReadLargest(reader, path));

    /// <summary>Reads a catalogue to look at.</summary>
    /// <param name="fileName">For messages.</param>
    /// <inheritdoc cref="ReadLargest(string)"/>
    public static IReadOnlyList<Crater> ReadLargest(TextReader reader, string fileName)
    {
        PriorityQueue<Crater, (double Diameter, int Order)> largest = new();
        foreach ((Crater crater, int line) in Lines(reader, fileName, 2.0 * MoonConstants.ReferenceRadius))
        {
            largest.Enqueue(crater, (crater.Diameter, -line)); // of two of one size the earlier line stays
            if (largest.Count > MostCraters)
            {
                largest.Dequeue();
            }
        }

        Crater[] craters = new Crater[largest.Count];
        for (int index = craters.Length - 1; index >= 0; index--)
        {
            craters[index] = largest.Dequeue();
        }

        return craters;
    }

    /// <summary>Reads all of a catalogue for a run.</summary>
    /// <param name="path">The file.</param>
    /// <param name="referenceRadius">m: radius of the body; no crater is wider than the body.</param>
    /// <param name="columns">Which columns the user names; null for none.</param>
    /// <returns>The craters, in the order of the lines; at least one.</returns>
    /// <exception cref="BadInputException">
    /// It can't be read, a value is wrong, an identity is there twice, or there are too many craters.
    /// </exception>
    public static IReadOnlyList<Crater> ReadAll(string path, double referenceRadius, ListColumns? columns = null) =>
        ListTable.Read(path, Needed, reader => ReadAll(reader, path, referenceRadius, columns));

    /// <summary>Reads all of a catalogue for a run.</summary>
    /// <param name="fileName">For messages.</param>
    /// <param name="referenceRadius">m: radius of the body.</param>
    /// <param name="columns">Which columns the user names; null for none.</param>
    /// <inheritdoc cref="ReadAll(string, double, ListColumns)"/>
    public static IReadOnlyList<Crater> ReadAll(
        TextReader reader, string fileName, double referenceRadius, ListColumns? columns = null)
    {
        List<Crater> craters = [];
        Dictionary<string, int> lines = new(StringComparer.Ordinal);
        foreach ((Crater crater, int line) in Lines(reader, fileName, 2.0 * referenceRadius, columns))
        {
            if (!lines.TryAdd(crater.Identity, line))
            {
                throw new BadInputException(Invariant(
                    $"{fileName}, line {line}: the crater '{crater.Identity}' is already in line {lines[crater.Identity]}. Remove one."));
            }

            craters.Add(crater);
            if (craters.Count > MostCratersOfRun)
            {
                throw new BadInputException(Invariant(
                    $"{fileName}: more than {MostCratersOfRun} craters, which would take more than {MostCratersOfRun / 1e6 * 0.3:F1} GB of "
                        + $"memory. Leave out small ones, or those of other regions."));
            }
        }

        return craters.Count > 0 ? craters : throw new BadInputException($"{fileName}: no craters below the heading. Give a catalogue.");
    }

    private static IEnumerable<(Crater Crater, int Line)> Lines(
        TextReader reader, string fileName, double maxDiameter, ListColumns? given = null)
    {
        ListTable table = ListTable.Open(reader, fileName, given, CraterColumns.AreIn);
        CraterColumns columns = new(table.Header, fileName);
        int number = 0;
        foreach (CsvRow row in table.Rows)
        {
            yield return (columns.Read(row, ++number, maxDiameter), row.Line);
        }
    }
}
