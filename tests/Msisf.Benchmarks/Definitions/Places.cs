using Msisf.Core.Attitude;
using Msisf.Core.Numerics;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;
using Msisf.Core.Time;
using Msisf.TestSupport;

namespace Msisf.Benchmarks.Definitions;

/// <summary>
/// Where the scenes' cameras are and how they look. The Sun is the ephemeris's at the time given; the times are those at which it stands as
/// wanted (tests/reference/benchmark_scenes.py, CSPICE N0067).
/// </summary>
internal static class Places
{
    /// <summary>Low Sun over 10 N 20 E: 9.97 degrees up, in the east.</summary>
    private const double LowSun = 55306.67;

    /// <summary>Off nadir, degrees: the horizon is in the image from 500 m as from 100 km.</summary>
    private const double LandingTilt = 75.0;

    /// <summary>
    /// The thesis's example place, 1 091 km over 0 N 45 E, straight down: the terminator runs through the image (Sun 0.88 degrees up).
    /// </summary>
    public static SpacecraftState Far { get; } = Nadir(55289.0, new Vector3D(2e6, 2e6, 0.0));

    /// <summary>Twice as far in the same direction: the whole disc, half of it lit.</summary>
    public static SpacecraftState Disc { get; } = Nadir(55289.0, new Vector3D(4e6, 4e6, 0.0));

    /// <summary>100 km over 10 N 20 E, straight down; Sun 9.97 degrees up, in the east.</summary>
    public static SpacecraftState LowNadir { get; } = Nadir(LowSun, Above(10.0, 20.0, 100e3));

    /// <summary>
    /// 20 km over 10 N 20 E, 60 degrees off nadir to the north; Sun 3.01 degrees up, in the east, where the image's middle is.
    /// </summary>
    public static SpacecraftState Oblique { get; } = Tilted(Nadir(55306.09, Above(10.0, 20.0, 20e3)), 60.0);

    /// <summary>100 km over the north pole, straight down; Sun 1.56 degrees up, as high as it comes in 2010.</summary>
    public static SpacecraftState NorthPole { get; } = Nadir(55295.0, Above(90.0, 0.0, 100e3));

    /// <summary>100 km over the south pole, straight down; Sun 1.58 degrees up, as high as it comes in 2010.</summary>
    public static SpacecraftState SouthPole { get; } = Nadir(55463.0, Above(-90.0, 0.0, 100e3));

    /// <summary>
    /// 5 km over the south pole, which is higher than all ground there, 60 degrees off nadir; Sun as for <see cref="SouthPole"/>.
    /// </summary>
    public static SpacecraftState LowOverSouthPole { get; } = Tilted(Nadir(55463.0, Above(-90.0, 0.0, 5e3)), 60.0);

    /// <summary>100 km over 0 N 0 E, straight down; Sun 9.99 degrees up, in the east.</summary>
    public static SpacecraftState PrimeMeridian { get; } = Nadir(55308.32, Above(0.0, 0.0, 100e3));

    /// <summary>On the way down to 10 N 20 E, looking ahead to the north over the horizon; Sun as for <see cref="LowNadir"/>.</summary>
    /// <param name="altitude">m over the mean radius.</param>
    public static SpacecraftState Landing(double altitude) => Tilted(Nadir(LowSun, Above(10.0, 20.0, altitude)), LandingTilt);

    private static SpacecraftState Nadir(double mjd, Vector3D positionBodyFixed) =>
        new(Moments.OfMjd(mjd), positionBodyFixed, NadirPointing.MoonFromCamera(positionBodyFixed));

    /// <summary>Turned about the image's right, so that what lies above its middle comes into it.</summary>
    private static SpacecraftState Tilted(SpacecraftState state, double degrees) => state with
    {
        MoonFromCamera = state.MoonFromCamera * UnitQuaternion.FromAxisAngle(Vector3D.UnitY, double.DegreesToRadians(degrees)),
    };

    /// <summary>m, MOON_ME; the altitude is over the mean radius.</summary>
    private static Vector3D Above(double latitudeDegrees, double longitudeDegrees, double altitude)
    {
        double radius = MoonConstants.MeanRadius + altitude;
        if (Math.Abs(latitudeDegrees) == 90.0)
        {
            return Math.Sign(latitudeDegrees) * radius * Vector3D.UnitZ; // the cosine of a right angle is not 0 in doubles
        }

        (double sinLatitude, double cosLatitude) = Math.SinCos(double.DegreesToRadians(latitudeDegrees));
        (double sinLongitude, double cosLongitude) = Math.SinCos(double.DegreesToRadians(longitudeDegrees));
        return radius * new Vector3D(cosLatitude * cosLongitude, cosLatitude * sinLongitude, sinLatitude);
    }
}
