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
    private static readonly Instant Epoch = Moments.OfMjd(55289.0);

    /// <summary>tests/reference/orbit_frames.py, CSPICE N0067; times that an MJD holds exactly.</summary>
    [Theory]
    [InlineData(OrbitFrame.MoonMe, 10800.0, 1352916.3598718392, 735902.7835975757, -1098765.1790939362)]
    [InlineData(OrbitFrame.J2000, 10800.0, 928478.31993717, -1058428.7550338241, -1263676.0195671422)]
    [InlineData(OrbitFrame.MoonMeEpoch, 10800.0, 1373512.1839652637, 696701.7082965658, -1098768.1796723432)]
    [InlineData(OrbitFrame.MoonMe, 2592000.0, -807222.9713299418, 852986.2367247599, 1394131.0586919927)]
    [InlineData(OrbitFrame.J2000, 2592000.0, 1366041.1249149928, 772602.018045957, 927261.3553074228)]
    [InlineData(OrbitFrame.MoonMeEpoch, 2592000.0, -165176.42658108234, 1163063.1016265575, 1393842.4674370407)]
    public void PositionMoonMe_EachFrame_AgreesWithCSpice(OrbitFrame frame, double seconds, double x, double y, double z)
    {
        using OpenedEphemeris ephemeris = EphemerisFactory.Open(new EphemerisRequest(
            EphemerisChoice.BuiltIn, [Path.Combine(TestParts.Kernels, "msisf.tm")], TestParts.RepositoryRoot, CSpicePath: null));
        OrbitPropagator orbit = new(Elements, Epoch, frame, ephemeris.Engine);

        Vector3D position = orbit.PositionBodyFixed(Moments.OfMjd(55289.0 + (seconds / 86400.0)));

        Assert.InRange((position - new Vector3D(x, y, z)).Length, 0.0, PositionTolerance);
    }
}
