using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Settings;
using Msisf.App.Tests.Host;
using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;
using Msisf.Core.Time;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.App.Tests.Preparation;

public sealed class StateReaderTests
{
    private static readonly Vector3D Sun = new(-4e10, 1.3e11, 6e10);

    /// <summary>A camera that looks at the Sun, or has it above, means the Sun that gives the light; no ephemeris is asked.</summary>
    [Fact]
    public void Read_PlaceWithASunOfItsOwn_PointsToThatSun()
    {
        SpacecraftState state = Read(new CameraPointing { Kind = BoresightKind.Sun });
        Vector3D towards = Sun - state.PositionBodyFixed;
        Assert.Equal(Sun, state.SunPositionBodyFixed);
        Assert.InRange(Vector3D.AngleBetween(towards, state.MoonFromCamera * -Vector3D.UnitX), 0.0, Rounding.OfChains);

        state = Read(new CameraPointing { Up = UpDirection.Sun });
        Vector3D right = state.MoonFromCamera * Vector3D.UnitY;
        Vector3D up = state.MoonFromCamera * Vector3D.UnitZ;
        Assert.Equal(0.0, Vector3D.Dot(right, towards / towards.Length), Rounding.OfChains);
        Assert.True(Vector3D.Dot(up, towards) > 0.0);
    }

    private static SpacecraftState Read(CameraPointing pointing)
    {
        ProgramHost host = new(TimeProvider.System, static _ => null)
        {
            Results = TextWriter.Null,
            Log = new ListLog(),
            Progress = null!, // nothing is shown
            StandardInput = () => TextReader.Null,
        };
        RunGeometry scene = new(
            () => throw new InvalidOperationException("terrain"), () => throw new InvalidOperationException("ephemeris"),
            () => Moments.Naif0012, default);
        PlaceSettings place = new(new SurfacePlace(12.0, 34.0, 1e5, isOverTerrain: false), pointing, [CalendarTime.OfMjd(60328.5)])
        {
            SunPositionBodyFixed = Sun,
        };
        return Assert.Single(new StateReader(() => throw new InvalidOperationException("ephemeris"), scene, host).Read(place, default));
    }
}
