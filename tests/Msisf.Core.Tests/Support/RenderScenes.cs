using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Surface;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;

namespace Msisf.Core.Tests.Support;

/// <summary>
/// Cameras and Suns in which a renderer may go wrong, for any model; all angles in degrees, heights in m over the ground.
/// </summary>
internal static class RenderScenes
{
    /// <summary>m: a length on the way to the Sun.</summary>
    private const double SunDistance = 1.496e11;

    public static IReadOnlyList<RenderSceneCase> All { get; } =
    [
        //                  name                  lat     lon  height  tilt azimuth    fov    Sun's elevation, azimuth at the place below
        new RenderSceneCase("far",                0.0,   45.0, 1.091e6, 0.0,   0.0,   40.0,   0.9, 272.0),
        new RenderSceneCase("nadir-100km",       10.0,   20.0,   100e3, 0.0,   0.0,   40.0,  10.0,  90.0),
        new RenderSceneCase("oblique-20km",     -35.0,  110.0,    20e3, 60.0,  0.0,   45.0,   3.0,  90.0),
        new RenderSceneCase("north-pole",        89.9,  120.0,   100e3, 0.0,   0.0,   40.0,   1.5, 200.0),
        new RenderSceneCase("north-pole-axis",   90.0,    0.0,    50e3, 0.0,   0.0,   30.0,   1.0,  45.0),
        new RenderSceneCase("south-pole",       -89.5,  300.0,    30e3, 40.0, 170.0,  50.0,   1.5,  20.0),
        new RenderSceneCase("across-pole",      -88.0,  222.0,     2e3, 82.0, 180.0,  30.0,   4.0, 100.0),
        new RenderSceneCase("seam",               5.0,    0.0,    60e3, 0.0,   0.0,   50.0,  12.0, 250.0),
        new RenderSceneCase("seam-oblique",     -20.0,    2.0,     8e3, 75.0, 270.0,  60.0,   8.0, 280.0),
        new RenderSceneCase("limb",              40.0,  260.0,   100e3, 70.0, 135.0,  12.0,  20.0, 120.0),
        new RenderSceneCase("limb-backlit",     -10.0,  150.0,   300e3, 58.5,  90.0,   4.0, -18.0,  90.0),
        new RenderSceneCase("grazing-sun",       55.0,   75.0,    60e3, 10.0, 200.0,  45.0,   0.2,  90.0),
        new RenderSceneCase("inside-crater",    -70.4,  187.4,    50.0, 88.0,  30.0,  60.0,   8.0,  10.0),
        new RenderSceneCase("one-metre",         22.3,  333.3,     1.0, 84.0,  75.0,  70.0,   6.0,  80.0),
        new RenderSceneCase("half-sky",          -5.0,   60.0,     3e3, 92.0, 225.0,  80.0,   5.0, 230.0),
        new RenderSceneCase("along-parallel",    60.0,  200.0,    15e3, 80.0,  90.0,  40.0,   4.0,  90.0),
        new RenderSceneCase("wide-angle",        30.0,  280.0,   200e3, 20.0, 300.0, 120.0,  15.0, 100.0),
        new RenderSceneCase("whole-disc",       -15.0,  130.0,   4.1e6, 0.0,   0.0,   40.0,  35.0, 280.0),
        new RenderSceneCase("disc-1e9",          20.0,   10.0,     1e9, 0.0,   0.0,    0.21, 25.0,  95.0),
        new RenderSceneCase("limb-1e9",          20.0,   10.0,     1e9, 0.0995, 60.0,  0.01, 25.0,  95.0),
    ];

    /// <summary>Names, for theories.</summary>
    public static IEnumerable<string> Names => All.Select(scene => scene.Name);

    /// <summary>The scene of a name.</summary>
    public static RenderSceneCase Named(string name) => All.Single(scene => scene.Name == name);

    /// <summary>A scene: a camera over a place on the ground, and the Sun as that place sees it.</summary>
    /// <param name="Name">For messages.</param>
    /// <param name="Latitude">Degrees.</param>
    /// <param name="Longitude">Degrees, east.</param>
    /// <param name="Height">m over the ground.</param>
    /// <param name="Tilt">Degrees between straight down and the viewing direction.</param>
    /// <param name="Azimuth">Degrees from north over east in which the camera is tilted; its right is horizontal.</param>
    /// <param name="FieldOfView">Degrees.</param>
    /// <param name="SunElevation">Degrees over the horizontal plane.</param>
    /// <param name="SunAzimuth">Degrees from north over east.</param>
    public sealed record RenderSceneCase(
        string Name, double Latitude, double Longitude, double Height, double Tilt, double Azimuth, double FieldOfView, double SunElevation,
        double SunAzimuth)
    {
        /// <summary>m, MOON_ME.</summary>
        public Vector3D Sun => SunDistance * Towards(SunElevation, SunAzimuth);

        private Vector3D Up => Math.Abs(Latitude) == 90.0
            ? new Vector3D(0.0, 0.0, Math.Sign(Latitude))
            : new SelenographicPoint(Radians(Latitude), Radians(Longitude)).ToDirectionBodyFixed();

        private Vector3D East => new(-Math.Sin(Radians(Longitude)), Math.Cos(Radians(Longitude)), 0.0);

        /// <summary>The camera over the ground of a model.</summary>
        public PinholeCamera Camera(ITerrain grid, int width, int height)
        {
            Vector3D position = (TerrainHeight.RadiusBelow(grid, Up) + Height) * Up;
            return new PinholeCamera(
                position,
                CameraCases.Attitude(Towards(Tilt - 90.0, Azimuth), Towards(0.0, Azimuth + 90.0)),
                Radians(FieldOfView),
                width,
                height);
        }

        private static double Radians(double degrees) => degrees * Math.PI / 180.0;

        private Vector3D Towards(double elevation, double azimuth)
        {
            Vector3D north = Vector3D.Cross(Up, East);
            Vector3D along = (Math.Cos(Radians(azimuth)) * north) + (Math.Sin(Radians(azimuth)) * East);
            return (Math.Sin(Radians(elevation)) * Up) + (Math.Cos(Radians(elevation)) * along);
        }
    }
}
