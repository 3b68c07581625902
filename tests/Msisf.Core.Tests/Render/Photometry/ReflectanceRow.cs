using System.Globalization;
using Msisf.TestSupport;

namespace Msisf.Core.Tests.Render.Photometry;

/// <summary>A line of tests/golden/reflectance.tsv: one geometry, and I/F of each law there (tests/golden/README.md).</summary>
internal sealed record ReflectanceRow(double CosIncidence, double CosEmission, double PhaseHaversine, double[] RadianceFactors)
{
    public const int LambertColumn = 0;
    public const int LommelSeeligerColumn = 1;
    public const int LunarLambertColumn = 2;
    public const int FirstHapkeColumn = 3;

    public static ReflectanceRow[] All { get; } =
    [
        .. File.ReadLines(Path.Combine(TestParts.RepositoryRoot, "tests", "golden", "reflectance.tsv"))
            .Skip(1)
            .Select(line => line.Split('\t').Select(cell => double.Parse(cell, CultureInfo.InvariantCulture)).ToArray())
            .Select(cells => new ReflectanceRow(cells[0], cells[1], cells[2], cells[3..])),
    ];
}
