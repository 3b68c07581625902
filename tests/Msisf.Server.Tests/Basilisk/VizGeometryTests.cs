using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Scene;
using Msisf.Core.Time;
using Msisf.Server.Basilisk;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Server.Tests.Basilisk;

/// <summary>States of small messages, whose turns of 90 degrees are done by hand.</summary>
public sealed class VizGeometryTests
{
    /// <summary>Modified Rodrigues parameters of 90 degrees: tan(22.5 degrees).</summary>
    private const double QuarterTurn = 0.41421356237309503;

    private static readonly VizBody Moon = new("moon", new Vector3D(1e8, 0.0, 0.0), [0, 1, 0, -1, 0, 0, 0, 0, 1]);
    private static readonly VizBody Sun = new("sun_planet_data", new Vector3D(1e8, 1.5e11, 0.0), [1, 0, 0, 0, 1, 0, 0, 0, 1]);
    private static readonly Instant Time = Moments.OfMjd(60000.0);

    /// <summary>
    /// The Moon's x axis lies along y of N. The craft is 2,000 km from it along x of N, which is -y of the Moon's axes. It is turned by 90
    /// degrees about z, so that its own x is y of N, and its camera sits 3 m along that: x of the Moon's axes.
    /// </summary>
    [Fact]
    public void StateOf_TurnedCraftAndMoon_IsThatByHand()
    {
        VizSpacecraft craft = new("sat", new Vector3D(1.02e8, 0.0, 0.0), new Vector3D(0.0, 0.0, QuarterTurn));
        VizCamera camera = new(1, "sat", 20.0, 64, 48, new Vector3D(3.0, 0.0, 0.0), default, 0);

        SpacecraftState state = VizGeometry.StateOf(camera, craft, Moon, Sun, VizGeometry.MoonFromInertial(Moon), Time);

        AssertNear(new Vector3D(3.0, -2e6, 0.0), state.PositionBodyFixed);
        AssertNear(new Vector3D(1.5e11, 0.0, 0.0) / 1e5, state.SunPositionBodyFixed!.Value / 1e5);
        AssertNear(Vector3D.UnitX, state.MoonFromCamera * Vector3D.UnitX); // the camera's x is the craft's
        AssertNear(Vector3D.UnitY, state.MoonFromCamera * Vector3D.UnitY);
    }

    [Fact]
    public void MoonFromInertial_NoRotation_IsRefused()
    {
        Assert.Contains("has 8 numbers; 9 are needed", Refused([0, 1, 0, -1, 0, 0, 0, 0]), StringComparison.Ordinal);
        Assert.Contains("is none: its rows are", Refused([0, 1, 0, 1, 0, 0, 0, 0, 1]), StringComparison.Ordinal); // left-handed
        Assert.Contains("is none: its rows are", Refused([0, 2, 0, -2, 0, 0, 0, 0, 2]), StringComparison.Ordinal);

        static string Refused(double[] numbers) => Assert.Throws<BadInputException>(
            () => VizGeometry.MoonFromInertial(new VizBody("moon", default, numbers))).Message;
    }

    [Fact]
    public void StateOf_NumberThatIsNotFinite_IsRefused()
    {
        VizSpacecraft craft = new("sat", new Vector3D(1.02e8, 0.0, 0.0), new Vector3D(0.0, double.NaN, 0.0));
        VizCamera camera = new(1, "sat", 20.0, 64, 48, default, default, 0);

        BadInputException error = Assert.Throws<BadInputException>(
            () => VizGeometry.StateOf(camera, craft, Moon, Sun, UnitQuaternion.Identity, Time));

        Assert.StartsWith("the attitude of 'sat' is ", error.Message, StringComparison.Ordinal);
    }

    /// <summary>0.01 degrees are 1.745e-4 rad.</summary>
    [Fact]
    public void Checked_TurnOfAHundredthOfADegree_IsTheBorder()
    {
        UnitQuaternion near = UnitQuaternion.FromComponents(0.0, 0.0, 0.85e-4, 1.0);
        UnitQuaternion far = UnitQuaternion.FromComponents(0.0, 0.0, -0.9e-4, 1.0);

        Assert.Equal(near, VizGeometry.Checked(UnitQuaternion.Identity, near, Time));
        Assert.Contains(
            "is turned by 0.010 degrees against MOON_ME",
            Assert.Throws<BadInputException>(() => VizGeometry.Checked(UnitQuaternion.Identity, far, Time)).Message,
            StringComparison.Ordinal);
    }

    private static void AssertNear(Vector3D expected, Vector3D actual) =>
        Assert.InRange((actual - expected).Length, 0.0, Rounding.OfConvertedPlaces);
}
