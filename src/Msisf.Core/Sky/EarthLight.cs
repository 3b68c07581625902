using Msisf.Core.Camera;
using Msisf.Core.Ephemeris;
using Msisf.Core.Render.Options;
using Msisf.Core.Scene;
using Msisf.Core.Time;

namespace Msisf.Core.Sky;

/// <summary>The light of the Earth on the ground.</summary>
public static class EarthLight
{
    /// <summary>
    /// The light at a time: a disc of the Earth's size in the middle of its own light, which a phase moves off its centre. So facets that
    /// see all of it get just its light; what a horizon cuts off is taken from an even disc. Its strength is that below the camera.
    /// </summary>
    /// <param name="camera">Its ground is where the camera is nearest to it.</param>
    /// <param name="radius">Radius of the sphere that stands for the ground, m.</param>
    public static SecondLight At(Instant time, in CameraState camera, IEphemeris ephemeris, double radius)
    {
        TdbTime tdb = time.Tdb;
        Vector3D ofGround = radius * camera.PositionBodyFixed.Normalized();
        CameraState ground = new(ofGround, UnitQuaternion.Identity);
        BodyPlace place = SkyAxes.At(time, ground, Still, ephemeris, radius, [SkyBody.Earth]).Bodies[0];
        RotationMatrix axes = ephemeris.BodyFromJ2000(tdb);
        Vector3D toEarth = axes * place.ApparentJ2000;
        Vector3D toSun = axes * place.ToSunJ2000;
        Vector3D aside = toSun - (Vector3D.Dot(toSun, toEarth) * toEarth);
        double offset = place.Body.EquatorialRadius
            * LambertSphere.Of(place.Phase, place.Body.EquatorialRadius / place.Distance).Offset;
        Vector3D centre = ofGround + (place.Distance * toEarth) + (aside.Length > 0.0 ? offset * aside.Normalized() : default);
        return new SecondLight(
            new SceneLight(centre, IsSun: true) { Radius = place.Body.EquatorialRadius }, place.OverSunlight);
    }

    /// <summary>Seen without the motion of an observer: light has its time, and the ground is at rest.</summary>
    private static SkyObserver Still { get; } = new(Aberration.LightTime, static _ => default);
}
