using System.Globalization;
using Msisf.TestSupport;

namespace Msisf.Stress.Reference;

/// <summary>The tables of tests/golden/stress, which tests/golden/README.md describes: rows of doubles under a header.</summary>
internal static class StressTable
{
    public static double[][] Rows(string fileName) =>
    [
        .. File.ReadLines(Path.Combine(TestParts.RepositoryRoot, "tests", "golden", "stress", fileName))
            .Skip(1)
            .Select(line => line.Split(',').Select(cell => double.Parse(cell, CultureInfo.InvariantCulture)).ToArray()),
    ];

    /// <summary>The number that a column and the next one hold.</summary>
    public static DoubleWord Number(double[] row, int column) => new(row[column], row[column + 1]);
}
