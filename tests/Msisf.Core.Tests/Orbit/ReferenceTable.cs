using System.Globalization;
using Msisf.Core.Ephemeris;
using Msisf.Core.Numerics;
using Msisf.Core.Orbit;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Orbit;

/// <summary>The tables of tests/golden/orbit, which tests/golden/README.md describes: rows of doubles under a header.</summary>
internal static class ReferenceTable
{
    public static double[][] Rows(string fileName)
    {
        double[][] rows = [.. File.ReadLines(Path.Combine(TestParts.RepositoryRoot, "tests", "golden", "orbit", fileName))
            .Skip(1)
            .Select(line => line.Split(',').Select(cell => double.Parse(cell, CultureInfo.InvariantCulture)).ToArray())];
        Assert.NotEmpty(rows);
        return rows;
    }

    public static KeplerElements Elements(double[] row) => new(row[0], row[1], row[2], row[3], row[4], row[5]);

    public static StateVector State(double[] row, int first) => new(
        new Vector3D(row[first], row[first + 1], row[first + 2]),
        new Vector3D(row[first + 3], row[first + 4], row[first + 5]));
}
