using Msisf.Adapters.Ephemeris;
using Msisf.Core.Numerics;
using Msisf.Core.Orbit;
using Msisf.Core.Time;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Orbit;

/// <summary>Orbits in frames that turn, with the real kernels.</summary>
public sealed class OrbitFrameTests
{
    /// <summary>m: the rotation of the frame is the same to 1e-12 in both engines, and the mean anomaly after a month to 1e-13.</summary>
    private const double PositionTolerance = 1e-5;

    private static readonly KeplerElements Elements = new(1.9e6, 0.05, 0.7, 1.1, 0.9, 2.0);
    private static readonly ModifiedJulianDate Epoch = new(55289.0);

    /// <summary>tests/reference/orbit_frames.py, CSPICE N0067.</summary>
    [Theory]
    [InlineData(OrbitFrame.MoonMe, 7200.0, -1298942.1504211377, -1190926.0397576098, 778056.1768316632)]
    [InlineData(OrbitFrame.J2000, 7200.0, -1371791.406981371, 715231.7808621353, 1147849.6382349855)]
    [InlineData(OrbitFrame.MoonMeEpoch, 7200.0, -1321526.8737499549, -1165810.510252468, 778061.393953514)]
    [InlineData(OrbitFrame.MoonMe, 2592000.0, -807222.9713299418, 852986.2367247599, 1394131.0586919927)]
    [InlineData(OrbitFrame.J2000, 2592000.0, 1366041.1249149928, 772602.018045957, 927261.3553074228)]
    [InlineData(OrbitFrame.MoonMeEpoch, 2592000.0, -165176.42658108234, 1163063.1016265575, 1393842.4674370407)]
    public void PositionMoonMe_EachFrame_AgreesWithCSpice(OrbitFrame frame, double seconds, double x, double y, double z)
    {
        using OpenedEphemeris ephemeris = EphemerisFactory.Open(new EphemerisRequest(
            EphemerisChoice.BuiltIn, [Path.Combine(TestParts.Kernels, "msisf.tm")], TestParts.RepositoryRoot, CSpicePath: null));
        OrbitPropagator orbit = new(Elements, Epoch, frame, ephemeris.Engine);

        Vector3D position = orbit.PositionMoonMe(new ModifiedJulianDate(55289.0 + (seconds / 86400.0)));

        Assert.InRange((position - new Vector3D(x, y, z)).Length, 0.0, PositionTolerance);
    }
}
