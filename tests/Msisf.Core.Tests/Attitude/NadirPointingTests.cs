using FsCheck;
using FsCheck.Fluent;
using Msisf.Core.Attitude;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Xunit;

namespace Msisf.Core.Tests.Attitude;

public class NadirPointingTests
{
    /// <summary>1: the components of a unit vector after two half-angle rotations, some 4 ulps.</summary>
    private const double UnitVector = 1e-15;

    // By hand: looking direction, right = east, up = north.
    [Theory]
    [InlineData(2e6, 0, 0, "-1,0,0", "0,1,0", "0,0,1")] // prime meridian
    [InlineData(0, 2e6, 0, "0,-1,0", "-1,0,0", "0,0,1")] // 90 degrees east
    [InlineData(-2e6, 0, 0, "1,0,0", "0,-1,0", "0,0,1")] // far side
    [InlineData(-2e6, -0.0, 0, "1,0,0", "0,-1,0", "0,0,1")] // far side, from the other side of the cut
    [InlineData(0, 0, 2e6, "0,0,-1", "0,1,0", "-1,0,0")] // north pole: along the meridian 0
    [InlineData(-0.0, -0.0, 2e6, "0,0,-1", "0,1,0", "-1,0,0")] // the signs of zeros do not count
    [InlineData(0, 0, -2e6, "0,0,1", "0,1,0", "1,0,0")] // south pole
    [InlineData(0, 1e-300, 2e6, "0,0,-1", "-1,0,0", "0,-1,0")] // next to the pole: the limit along the meridian of 90 degrees
    public void MoonFromCamera_KnownPlace_LooksDownWithNorthUp(double x, double y, double z, string down, string east, string north)
    {
        UnitQuaternion moonFromCamera = NadirPointing.MoonFromCamera(new Vector3D(x, y, z));
        AssertClose(Parse(down), moonFromCamera * -Vector3D.UnitX);
        AssertClose(Parse(east), moonFromCamera * Vector3D.UnitY);
        AssertClose(Parse(north), moonFromCamera * Vector3D.UnitZ);
    }

    /// <summary>Over the equator it turns about the image's axes; on the pole the meridian's jump is left out.</summary>
    [Theory]
    [InlineData(2e6, 0, 0, 0, 2e6, 0, "0,0,1")] // eastwards
    [InlineData(2e6, 0, 0, 0, 0, 2e6, "0,-1,0")] // northwards
    [InlineData(2e6, 0, 0, 2e6, 0, 0, "0,0,0")] // upwards
    [InlineData(0, 0, 2e6, 2e6, 0, 0, "0,1,0")] // over the north pole, along the meridian 0
    public void RateOf_KnownMotion_IsThatOfTheLineToTheCentre(
        double x, double y, double z, double vx, double vy, double vz, string rate) =>
        AssertClose(Parse(rate), NadirPointing.RateOf(new Vector3D(x, y, z), new Vector3D(vx, vy, vz)));

    [Fact]
    public void MoonFromCamera_AnyPlace_LooksAtTheCentreWithEastRight()
    {
        Gen<double> coordinates = Gen.Choose(-2_000_000, 2_000_000).Select(metres => metres + 0.25);
        Gen<Vector3D> positions =
            from x in coordinates
            from y in coordinates
            from z in coordinates
            select new Vector3D(x, y, z);

        Prop.ForAll(Arb.From(positions), position =>
        {
            UnitQuaternion moonFromCamera = NadirPointing.MoonFromCamera(position);
            Vector3D east = Vector3D.Cross(Vector3D.UnitZ, position).Normalized();
            return ((moonFromCamera * -Vector3D.UnitX) + position.Normalized()).Length <= UnitVector
                && ((moonFromCamera * Vector3D.UnitY) - east).Length <= UnitVector
                && (moonFromCamera * Vector3D.UnitZ).Z >= 0.0;
        }).Check(Config.QuickThrowOnFailure.WithMaxTest(1000).WithReplay(20120222UL, 1UL));
    }

    [Fact]
    public void MoonFromCamera_MoonsCentre_Refused() =>
        Assert.Contains(
            "centre", Assert.Throws<BadInputException>(() => NadirPointing.MoonFromCamera(default)).Message, StringComparison.Ordinal);

    [Fact]
    public void MoonFromCamera_NotFinite_Refused() =>
        Assert.Throws<BadInputException>(() => NadirPointing.MoonFromCamera(new Vector3D(double.NaN, 0.0, 2e6)));

    private static Vector3D Parse(string components)
    {
        double[] numbers = [.. components.Split(',').Select(
            text => (double)int.Parse(text, System.Globalization.CultureInfo.InvariantCulture))];
        return new Vector3D(numbers[0], numbers[1], numbers[2]);
    }

    private static void AssertClose(Vector3D expected, Vector3D actual) =>
        Assert.InRange((actual - expected).Length, 0.0, UnitVector);
}
