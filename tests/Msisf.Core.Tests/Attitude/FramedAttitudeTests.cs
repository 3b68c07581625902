using Msisf.Core.Attitude;
using Msisf.Core.Ephemeris;
using Msisf.Core.Numerics;
using Msisf.Core.Time;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Attitude;

public class FramedAttitudeTests
{
    /// <summary>1: the components of a unit vector after some rotations.</summary>
    private const double UnitVector = 2e-15;

    private static readonly Instant Epoch = Moments.OfMjd(55289.0);
    private static readonly Vector3D Position = new(0.0, 1.9e6, 0.0);
    private static readonly QuarterTurnMoon Moon = new();

    // A day after the epoch the Moon below has turned by 90 degrees about z: what rests in space moves the other way in its axes.
    [Theory]
    [InlineData(AttitudeFrame.MoonMe, "-1,0,0", "0,0,1")]
    [InlineData(AttitudeFrame.MoonMeEpoch, "0,1,0", "0,0,1")] // -x of the epoch
    [InlineData(AttitudeFrame.J2000, "1,0,0", "0,0,1")] // at the epoch the Moon's x is already J2000's y
    [InlineData(AttitudeFrame.Lvlh, "1,0,0", "0,-1,0")] // backward; up in the image is down
    public void MoonFromCamera_NoRotation_LooksAlongMinusXOfTheFrame(AttitudeFrame frame, string forward, string up)
    {
        FramedAttitude attitude = new(new AttitudeTransition(UnitQuaternion.Identity, default), frame, Epoch, Moon);

        UnitQuaternion found = attitude.MoonFromCamera(Moments.OfMjd(55290.0), Position, _ => 5.0 * Vector3D.UnitZ);

        AssertClose(Parse(forward), found * -Vector3D.UnitX);
        AssertClose(Parse(up), found * Vector3D.UnitZ);
    }

    [Theory]
    [InlineData(AttitudeFrame.MoonMe)]
    [InlineData(AttitudeFrame.MoonMeEpoch)]
    public void MoonFromCamera_AtTheEpoch_IsTheGivenQuaternion(AttitudeFrame frame)
    {
        UnitQuaternion given = UnitQuaternion.FromComponents(0.1, 0.2, 0.3, 0.9273618495495703);
        FramedAttitude attitude = new(new AttitudeTransition(given, default), frame, Epoch, Moon);

        UnitQuaternion found = attitude.MoonFromCamera(Epoch, Position, _ => Vector3D.UnitZ);

        AssertClose(given * Vector3D.UnitX, found * Vector3D.UnitX);
        AssertClose(given * Vector3D.UnitZ, found * Vector3D.UnitZ);
    }

    [Fact]
    public void MoonFromCamera_MoonMe_KeepsTheBitsOfTheTransition()
    {
        AttitudeTransition transition = new(
            UnitQuaternion.FromComponents(0.1, 0.2, 0.3, 0.9273618495495703), new Vector3D(1e-3, 2e-3, 0.0));
        FramedAttitude attitude = new(transition, AttitudeFrame.MoonMe, Epoch, ephemeris: null);

        Assert.Equal(transition.At(43200.0), attitude.MoonFromCamera(Moments.OfMjd(55289.5), Position, _ => Vector3D.UnitZ));
    }

    [Fact]
    public void MoonFromCamera_LvlhWithRate_TurnsAboutTheCamerasAxes()
    {
        // A quarter turn about the camera's own x in 10 s: its right (against the angular momentum) becomes its up.
        AttitudeTransition transition = new(UnitQuaternion.Identity, new Vector3D(Math.PI / 20.0, 0.0, 0.0));
        FramedAttitude attitude = new(transition, AttitudeFrame.Lvlh, Moments.OfMjd(0.0), ephemeris: null);

        UnitQuaternion found = attitude.MoonFromCamera(Moments.OfMjd(10.0 / 86400.0), Position, _ => Vector3D.UnitZ);

        AssertClose(Vector3D.UnitX, found * -Vector3D.UnitX);
        Assert.InRange(((found * Vector3D.UnitY) - new Vector3D(0.0, -1.0, 0.0)).Length, 0.0, Rounding.OfChains);
        Assert.InRange(((found * Vector3D.UnitZ) - new Vector3D(0.0, 0.0, 1.0)).Length, 0.0, Rounding.OfChains);
    }

    [Theory]
    [InlineData(AttitudeFrame.MoonMeEpoch)]
    [InlineData(AttitudeFrame.J2000)]
    public void Constructor_FrameAtRestWithoutEphemeris_Refused(AttitudeFrame frame) => Assert.Throws<ArgumentNullException>(
        () => new FramedAttitude(new AttitudeTransition(UnitQuaternion.Identity, default), frame, Epoch, ephemeris: null));

    private static Vector3D Parse(string components)
    {
        double[] numbers = [.. components.Split(',').Select(text => double.Parse(text, System.Globalization.CultureInfo.InvariantCulture))];
        return new Vector3D(numbers[0], numbers[1], numbers[2]);
    }

    private static void AssertClose(Vector3D expected, Vector3D actual) => Assert.InRange((actual - expected).Length, 0.0, UnitVector);

    /// <summary>A Moon whose x axis is J2000's y at the epoch, and which turns by 90 degrees a day about z.</summary>
    private sealed class QuarterTurnMoon : IEphemeris
    {
        public string EngineName => "quarter turn Moon";

        public TimeScale TimeScale => throw new NotSupportedException();

        public Vector3D SunPositionBodyFixed(Instant time, Aberration aberration = Aberration.None) =>
            throw new NotSupportedException();

        public RotationMatrix BodyFromJ2000(TdbTime time) =>
            RotationMatrix.FrameAboutZ(Math.PI / 2.0 * (1.0 + Moments.OfTdb(time).Mjd - 55289.0));

        public Vector3D BodyRateJ2000(TdbTime time) => Math.PI / 2.0 / 86_400.0 * Vector3D.UnitZ;

        public StateVector StateOf(int naifNumber, TdbTime time) => throw new NotSupportedException();
    }
}
