using Msisf.Core.Orbit;
using Xunit;

namespace Msisf.Core.Tests.Orbit;

public class EccentricAnomalyTests
{
    [Fact]
    public void MeanAnomaly_ReferenceTable_KeepsItsDigitsForEccentricitiesNearOne()
    {
        // tests/reference/kepler.py. M of the rows that need no reduction; E there is rounded to a double, which moves M by at most half
        // an ulp times the condition (up to 3 near e = 1), and the formula rounds about twice.
        const double allowedUlps = 4.0;
        double[][] rows = [.. ReferenceTable.Rows("kepler.csv").Where(row => Math.Abs(row[0]) < 3.0)];

        Assert.All(rows, row =>
            Assert.InRange(Ulps.Between(row[0], new EccentricAnomaly(row[2], row[1]).MeanAnomaly), 0.0, allowedUlps));
    }

    [Fact]
    public void TrueAnomaly_ByTheThesisFormula_Agrees()
    {
        // mpmath: 2 atan2(sqrt(1.3) sin(2.5), sqrt(0.7) cos(2.5)) - 2 pi, thesis eq. 6.4 with E = 5, e = 0.3.
        Assert.Equal(-1.5886547364329431, new EccentricAnomaly(5.0 - (2.0 * Math.PI), 0.3).TrueAnomaly, 1e-15);
    }
}
