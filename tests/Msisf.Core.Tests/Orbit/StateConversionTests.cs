using FsCheck;
using FsCheck.Fluent;
using Msisf.Core.Ephemeris;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Orbit;
using Msisf.Core.Terrain;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Orbit;

public class StateConversionTests
{
    /// <summary>1, of the vector: the project's bound for the way to elements and back.</summary>
    private const double RoundTrip = 1e-12;

    [Fact]
    public void ToElements_ReferenceTable_AgreesWithOscelt()
    {
        // tests/reference/conics.py, CSPICE N0067 oscelt_c. rad and 1: a state's rounding, some ten of them on each side; what is
        // divided by says how badly the state defines the element. For e = 0.99992 oscelt_c's M is 4e-13 off: mpmath agrees with this code.
        const double allowed = 2e-14;
        Assert.All(ReferenceTable.Rows("oscelt.csv").Where(row => row[7] > 1e-3), row =>
        {
            KeplerElements elements = StateConversion.ToElements(ReferenceTable.State(row, 0));
            Assert.InRange(Math.Abs(elements.PeriapsisRadius - row[6]) / row[6], 0.0, allowed / (1.0 - row[7]));
            Assert.InRange(Math.Abs(elements.Eccentricity - row[7]), 0.0, allowed);
            Assert.InRange(AngleBetween(elements.ArgumentOfPeriapsis, row[8]), 0.0, allowed / row[7] / (1.0 - row[7]));
            Assert.InRange(AngleBetween(elements.LongitudeOfAscendingNode, row[9]), 0.0, allowed / Math.Max(Math.Sin(row[10]), 1e-3));
            Assert.InRange(Math.Abs(elements.Inclination - row[10]), 0.0, allowed);
            Assert.InRange(AngleBetween(elements.MeanAnomalyAtEpoch, row[11]), 0.0, allowed / row[7] / (1.0 - row[7]));
        });
    }

    [Fact]
    public void ToElements_ThenStateAt_AgreesWithProp2b()
    {
        // tests/reference/conics.py, CSPICE N0067 prop2b_c: universal variables, no elements. 1, of the vector: up to 100 rad swept, and
        // a state's rounding changes the period.
        const double allowed = 1e-11;
        Assert.All(ReferenceTable.Rows("prop2b.csv"), row =>
        {
            KeplerOrbit orbit = new(StateConversion.ToElements(ReferenceTable.State(row, 0)));
            AssertClose(ReferenceTable.State(row, 7), orbit.StateAt(row[6]), allowed);
        });
    }

    [Fact]
    public void ToElements_ThenStateAt_ReturnsTheState() =>
        Assert.All(ReferenceTable.Rows("oscelt.csv"), row =>
        {
            StateVector state = ReferenceTable.State(row, 0);
            AssertClose(state, new KeplerOrbit(StateConversion.ToElements(state)).StateAt(0.0), RoundTrip);
        });

    [Fact]
    public void ToElements_MeanAnomalyFive_KeepsTheHalfPlane()
    {
        // Deviations row 2: the thesis's arccos gives 2 pi - 5. The state is conics_c's, from the elements themselves.
        double[] row = ReferenceTable.Rows("conics.csv").First(candidate => candidate[6] == 0.0 && candidate[5] == 6.0);
        KeplerElements elements = StateConversion.ToElements(ReferenceTable.State(row, 7));
        Assert.Equal(6.0 - (2.0 * Math.PI), elements.MeanAnomalyAtEpoch, 1e-11);
    }

    [Theory]
    [InlineData(1.0, 0.0)]
    [InlineData(-1.0, Math.PI)]
    public void ToElements_Equatorial_NodeIsTheXAxis(double sense, double inclination)
    {
        // By hand: at (0, r, 0) with less than the circular speed, so at the apoapsis; the periapsis is at (0, -1, 0).
        StateVector state = new(new Vector3D(0.0, 2e6, 0.0), new Vector3D(-sense * 1400.0, 0.0, 0.0));
        KeplerElements elements = StateConversion.ToElements(state);

        Assert.Equal(inclination, elements.Inclination);
        Assert.Equal(0.0, elements.LongitudeOfAscendingNode);
        Assert.Equal(-sense * Math.PI / 2.0, elements.ArgumentOfPeriapsis, Rounding.OfUnits);
        Assert.Equal(Math.PI, Math.Abs(elements.MeanAnomalyAtEpoch), Rounding.OfUnits);
    }

    [Fact]
    public void ToElements_Circular_PeriapsisIsTheNode()
    {
        // mu / r = v^2 without rounding: r = 1225700.269 m, v = 2000 m/s. A third of the way round a polar orbit with its node on y.
        double third = 2.0 * Math.PI / 3.0;
        KeplerElements elements = StateConversion.ToElements(CircularPolar(third));

        Assert.InRange(elements.Eccentricity, 0.0, 4e-16);
        Assert.Equal(third, AngleReduction.ToFullTurn(elements.ArgumentOfPeriapsis + elements.MeanAnomalyAtEpoch), Rounding.OfUnits);
        Assert.Equal(Math.PI / 2.0, elements.LongitudeOfAscendingNode, Rounding.OfUnits);
    }

    [Fact]
    public void ToElements_EccentricityExactlyZero_OmegaIsZero()
    {
        // distance * speed^2 = mu without rounding.
        StateVector state = new(new Vector3D(0.0, 1225700.269, 0.0), new Vector3D(0.0, 0.0, 2000.0));
        KeplerElements elements = StateConversion.ToElements(state);

        Assert.Equal(0.0, elements.Eccentricity);
        Assert.Equal(0.0, elements.ArgumentOfPeriapsis);
        Assert.Equal(0.0, elements.MeanAnomalyAtEpoch);
        Assert.Equal(Math.PI / 2.0, elements.LongitudeOfAscendingNode);
    }

    [Theory]
    [InlineData(1e-300)]
    [InlineData(1e-17)]
    [InlineData(1e-12)]
    [InlineData(1e-8)]
    public void ToElements_NextToTheSingularOrbits_PositionDoesNotJump(double tilt)
    {
        // Nearly circular and nearly equatorial, prograde and retrograde: the angles may be anything, the position is the one given.
        const double allowed = 2e-9; // m: 8 ulps at 2e6 m, for the roundings of five angles; a jump would be of the order of a e
        double speed = Math.Sqrt(MoonConstants.GravitationalParameter / 2e6);
        StateVector[] states =
        [
            new(new Vector3D(2e6, 0.0, 0.0), new Vector3D(0.0, speed * (1.0 + tilt), speed * tilt)),
            new(new Vector3D(0.0, -2e6, 0.0), new Vector3D(-speed, tilt, -speed * tilt)),
            new(new Vector3D(0.0, 2e6, 2e6 * tilt), new Vector3D(speed, 0.0, 0.0)),
        ];
        Assert.All(states, state =>
            Assert.InRange(
                (new KeplerOrbit(StateConversion.ToElements(state)).PositionAt(0.0) - state.Position).Length,
                0.0,
                allowed));
    }

    [Fact]
    public void ToElements_AnyEllipse_RoundTrips()
    {
        Gen<double> signedUnit = Gen.Choose(-1_000_000, 1_000_000).Select(n => n / 1e6);
        Gen<Vector3D> directions =
            from x in signedUnit
            from y in signedUnit
            from z in signedUnit
            where (x * x) + (y * y) + (z * z) > 0.01
            select new Vector3D(x, y, z).Normalized();
        Gen<StateVector> states =
            from up in directions
            from along in directions
            where Vector3D.AngleBetween(up, along) is > 0.3 and < 2.8
            from radius in Gen.Choose(1_750_000, 100_000_000)
            from speed in Gen.Choose(400, 1_200)
            select new StateVector(radius * up, speed / 1000.0 * Math.Sqrt(MoonConstants.GravitationalParameter / radius) * along);

        Prop.ForAll(Arb.From(states), state =>
        {
            StateVector back = new KeplerOrbit(StateConversion.ToElements(state)).StateAt(0.0);
            return (back.Position - state.Position).Length <= RoundTrip * state.Position.Length
                && (back.Velocity - state.Velocity).Length <= RoundTrip * state.Velocity.Length;
        }).Check(Config.QuickThrowOnFailure.WithMaxTest(1000).WithReplay(20120222UL, 1UL));
    }

    [Theory]
    [InlineData(2e6, 0, 0, 0, 2214.3, 0, "escape speed")]
    [InlineData(2e6, 0, 0, 0, 1e200, 0, "escape speed")]
    [InlineData(2e6, 0, 0, 0, 1.6e6, 0, "Velocities are in m/s: is 1600000 mm/s, or km/s multiplied twice? Then write 1600.")]
    [InlineData(0, 0, 0, 0, 1500, 0, "The position (m) is zero")]
    [InlineData(2e6, 0, 0, 0, 0, 0, "The velocity (m/s) is zero")]
    [InlineData(2e6, 1e6, 0, 200, 100, 0, "are parallel")]
    [InlineData(1.75e6, 0, 0, -2000, 1e-7, 0, "is 1 to the last digit")]
    [InlineData(2e6, 1e6, 0.1, -200.1, -100.05, -1.0005e-5, "are parallel")]
    [InlineData(double.NaN, 0, 0, 0, 1500, 0, "The position (m) is not finite")]
    [InlineData(2e6, 0, 0, 0, double.PositiveInfinity, 0, "The velocity (m/s) is not finite")]
    public void ToElements_NoEllipse_RefusedWithTheReason(double x, double y, double z, double dx, double dy, double dz, string reason)
    {
        StateVector state = new(new Vector3D(x, y, z), new Vector3D(dx, dy, dz));
        Assert.Contains(
            reason, Assert.Throws<BadInputException>(() => StateConversion.ToElements(state)).Message, StringComparison.Ordinal);
    }

    private static StateVector CircularPolar(double angle)
    {
        (double sin, double cos) = Math.SinCos(angle);
        return new StateVector(1225700.269 * new Vector3D(0.0, cos, sin), 2000.0 * new Vector3D(0.0, -sin, cos));
    }

    private static double AngleBetween(double a, double b) => Math.Abs(AngleReduction.ToHalfTurn(a - b));

    private static void AssertClose(StateVector expected, StateVector actual, double allowed)
    {
        Assert.InRange((actual.Position - expected.Position).Length / expected.Position.Length, 0.0, allowed);
        Assert.InRange((actual.Velocity - expected.Velocity).Length / expected.Velocity.Length, 0.0, allowed);
    }
}
