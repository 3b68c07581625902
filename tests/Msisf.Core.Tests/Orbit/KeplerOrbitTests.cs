using Msisf.Core.Ephemeris;
using Msisf.Core.Numerics;
using Msisf.Core.Orbit;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Orbit;

public class KeplerOrbitTests
{
    [Fact]
    public void PositionAt_ThesisYRow_HasTheSignOfConics()
    {
        // tests/reference/conics.py, CSPICE N0067 conics_c: y = -1435599.050 m; the printed eq. 6.8 gives -1086210.450 m (deviations row
        // 1).
        KeplerOrbit orbit = new(new KeplerElements(1.9e6, 0.05, 0.7, 1.1, 0.9, 2.0));
        Vector3D position = orbit.PositionAt(0.0);

        // m: 40 ulps of a coordinate.
        const double allowed = 1e-8;
        Assert.Equal(-1199385.6007221646, position.X, allowed);
        Assert.Equal(-1435599.050061632, position.Y, allowed);
        Assert.Equal(526392.1739901546, position.Z, allowed);
    }

    [Fact]
    public void StateAt_ReferenceTable_AgreesWithConics()
    {
        // tests/reference/conics.py: circular, equatorial, polar, retrograde, nearly parabolic and 400 drawn orbits. 1, of the vector:
        // conics_c propagates from the periapsis, whose rounding moves the period by that over 1 - e. Where it is 7e-11 off, mpmath agrees
        // with this code.
        const double agreement = 3e-13;
        Assert.All(ReferenceTable.Rows("conics.csv"), row =>
        {
            double allowed = agreement / (1.0 - row[1]);
            StateVector expected = ReferenceTable.State(row, 7);
            StateVector actual = new KeplerOrbit(ReferenceTable.Elements(row)).StateAt(row[6]);
            Assert.InRange((actual.Position - expected.Position).Length / expected.Position.Length, 0.0, allowed);
            Assert.InRange((actual.Velocity - expected.Velocity).Length / expected.Velocity.Length, 0.0, allowed);
        });
    }

    [Fact]
    public void PositionAt_AnyTime_IsThatOfTheState()
    {
        KeplerOrbit orbit = new(new KeplerElements(2.1e6, 0.1, 1.0, 2.0, 1.5, 3.0));
        Assert.Equal(orbit.StateAt(-4321.5).Position, orbit.PositionAt(-4321.5));
    }

    [Fact]
    public void PositionAt_MeanAnomalyTwoPi_IsThePeriapsis()
    {
        // By hand: omega = Omega = i = 0, so the periapsis is (a (1 - e), 0, 0).
        KeplerOrbit orbit = new(new KeplerElements(2e6, 0.1, 0.0, 0.0, 0.0, 2.0 * Math.PI));
        Assert.InRange((orbit.PositionAt(0.0) - new Vector3D(1.8e6, 0.0, 0.0)).Length, 0.0, Rounding.OfPlaces);
    }

    [Theory]
    [InlineData(1e-16, 0.0)]
    [InlineData(0.0, 1e-16)]
    [InlineData(1e-16, 1e-16)]
    public void PositionAt_NextToCircularOrEquatorial_IsContinuous(double e, double i)
    {
        // Deviations row 3. m: 4 ulps at 2e6 m.
        Vector3D singular = new KeplerOrbit(new KeplerElements(2e6, 0.0, 1.0, 2.0, 0.0, 3.0)).PositionAt(0.0);
        Vector3D neighbour = new KeplerOrbit(new KeplerElements(2e6, e, 1.0, 2.0, i, 3.0)).PositionAt(0.0);
        Assert.InRange((neighbour - singular).Length, 0.0, Rounding.OfPlaces);
    }

    [Theory]
    [InlineData(0.0, 1.0)]
    [InlineData(Math.PI, -1.0)]
    public void StateAt_CircularEquatorial_RunsEastOrWest(double inclination, double sense)
    {
        // By hand: omega = Omega = 0, a quarter turn after the x axis; v = sqrt(mu / a) = 1565.6949057846487 m/s.
        StateVector state = new KeplerOrbit(new KeplerElements(2e6, 0.0, 0.0, 0.0, inclination, Math.PI / 2.0)).StateAt(0.0);
        Assert.InRange((state.Position - new Vector3D(0.0, sense * 2e6, 0.0)).Length, 0.0, Rounding.OfPlaces);
        Assert.InRange((state.Velocity - new Vector3D(-1565.6949057846487, 0.0, 0.0)).Length, 0.0, Rounding.OfChains);
    }

    [Fact]
    public void Constructor_DefaultElements_Refused() =>
        Assert.Throws<ArgumentException>(() => new KeplerOrbit(default));
}
