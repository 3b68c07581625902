using FsCheck;
using FsCheck.Fluent;
using Msisf.Core.Orbit;
using Xunit;

namespace Msisf.Core.Tests.Orbit;

public class KeplerSolverTests
{
    [Fact]
    public void Solve_ReferenceTable_MeetsFiftyDigitsToOneUlp()
    {
        // Units in the last place of E, between two doubles.
        const double allowedUlps = 1.0;

        // tests/reference/kepler.py, mpmath at 80 digits: e = 0 to the last double below 1, M from 1e-300 to -1e300.
        Assert.All(ReferenceTable.Rows("kepler.csv"), row =>
            Assert.InRange(Ulps.Between(row[2], KeplerSolver.Solve(row[0], row[1]).Angle), 0.0, allowedUlps));
    }

    [Fact]
    public void Solve_ReferenceTable_PositionKeepsItsDigits()
    {
        // 1, of the distance r/a: some five roundings, 2e-9 m in a low orbit. cos E - e and 1 - e cos E would lose all digits for e near 1.
        const double allowed = 1.2e-15;
        Assert.All(ReferenceTable.Rows("kepler.csv"), row =>
        {
            EccentricAnomaly anomaly = KeplerSolver.Solve(row[0], row[1]);
            Assert.InRange(Math.Abs(anomaly.X - row[3]) / row[5], 0.0, allowed);
            Assert.InRange(Math.Abs(anomaly.Y - row[4]) / row[5], 0.0, allowed);
            Assert.InRange(Math.Abs(anomaly.Radius - row[5]) / row[5], 0.0, allowed);
        });
    }

    [Fact]
    public void Solve_AnyOrbit_LeavesAResidualOfOneUlp()
    {
        // Residual of Kepler's equation over its slope, in units in the last place of E: half for the rounding of E itself, half for the
        // roundings of the residual in the last Newton step.
        const decimal allowedUlps = 1.0m;

        Gen<double> unit = Gen.Choose(0, int.MaxValue).Select(n => n / (double)int.MaxValue);
        Gen<(double M, double E)> orbits =
            from m in unit
            from isNearOne in Gen.Elements(false, true)
            from e in unit
            select ((m + 1e-6) * 3.1415, isNearOne ? 1.0 - Math.Pow(10.0, (-15.0 * e) - 0.3) : 0.999999 * e);

        Prop.ForAll(Arb.From(orbits), orbit =>
        {
            // Exact to 28 digits, so independent of the double arithmetic under test.
            double angle = KeplerSolver.Solve(orbit.M, orbit.E).Angle;
            decimal e = ExactDecimal.From(orbit.E);
            decimal residual = ExactDecimal.From(angle) - (e * ExactDecimal.Sin(angle)) - ExactDecimal.From(orbit.M);
            decimal slope = 1m - (e * ExactDecimal.Cos(angle));
            return Math.Abs(residual) <= allowedUlps * ExactDecimal.From(Ulps.Of(angle)) * slope;
        }).Check(Config.QuickThrowOnFailure.WithMaxTest(2000).WithReplay(20120222UL, 1UL));
    }

    [Theory]
    [InlineData(1.182804847879424E-07, 0.9999999999186667)]
    [InlineData(1.7804089866007152E-09, 0.9999999999760435)]
    public void Solve_NextToAParabola_LeavesTheResidualOfRoundingTheAngle(double m, double e)
    {
        // Units in the last place of M: half a one of E is up to 3 of M here. Residuals summed in doubles left 4.6 and 3.9.
        const decimal allowedUlps = 3m;
        double angle = KeplerSolver.Solve(m, e).Angle;
        decimal residual = ExactDecimal.From(angle) - (ExactDecimal.From(e) * ExactDecimal.Sin(angle)) - ExactDecimal.From(m);
        Assert.InRange(Math.Abs(residual) / ExactDecimal.From(Ulps.Of(m)), 0m, allowedUlps);
    }

    [Theory]
    [InlineData(0.0, 0.0)]
    [InlineData(0.5, 0.0)]
    [InlineData(0.999999999999, 0.0)]
    [InlineData(0.0, Math.PI)]
    [InlineData(0.5, Math.PI)]
    [InlineData(0.999999999999, Math.PI)]
    [InlineData(0.5, -Math.PI)]
    public void Solve_AtTheApsides_EccentricIsMeanAnomaly(double e, double m) =>
        Assert.Equal(m, KeplerSolver.Solve(m, e).Angle);

    [Fact]
    public void Solve_FullTurn_IsThePeriapsisButForTheRoundingOfTwoPi()
    {
        // mpmath: 2 pi - 6.283185307179586 = 2.4492935982947064e-16; e = 0.5 doubles it.
        Assert.Equal(-4.898587196589413e-16, KeplerSolver.Solve(2.0 * Math.PI, 0.5).Angle, 1e-30);
    }

    [Fact]
    public void Solve_NegativeMeanAnomaly_MirrorsThePositive() =>
        Assert.Equal(-KeplerSolver.Solve(1.234, 0.7).Angle, KeplerSolver.Solve(-1.234, 0.7).Angle);

    [Theory]
    [InlineData(double.NaN, 0.1)]
    [InlineData(double.PositiveInfinity, 0.1)]
    [InlineData(1.0, double.NaN)]
    [InlineData(1.0, -1e-300)]
    [InlineData(1.0, 1.0)]
    public void Solve_NoEllipseOrAngle_Refused(double m, double e) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => KeplerSolver.Solve(m, e));
}
