using Msisf.Stress.Counts;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Stress.Tests.Counts;

/// <summary>
/// The counts of tests/golden/work_counts.tsv: a greater one is work that a change has added, a lesser one work that it has saved. Either
/// is noted there by hand.
/// </summary>
public sealed class WorkCountsTests
{
    private static readonly string[] Golden = File.ReadAllLines(
        Path.Combine(TestParts.RepositoryRoot, "tests", "golden", "work_counts.tsv"));

    [RequiresFact(Part.Ldem4)]
    public void OfLdem4_AreTheNotedOnes() => Assert.Equal(Noted("LDEM_4"), WorkCounts.OfLdem4());

    [Fact]
    public void OfRuggedMoon_AreTheNotedOnes() => Assert.Equal(Noted("RUGGED_16"), WorkCounts.OfRuggedMoon());

    private static IEnumerable<string> Noted(string model) => Golden.Where(line => line.StartsWith(model + "\t", StringComparison.Ordinal));
}
