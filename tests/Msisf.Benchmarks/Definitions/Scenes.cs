using Msisf.Core.Attitude;
using Msisf.Core.Numerics;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;
using Msisf.Core.Time;

namespace Msisf.Benchmarks.Definitions;

/// <summary>
/// The measured scenes. The Sun is the ephemeris's at the time given; the times are those at which it stands as wanted
/// (tests/reference/benchmark_scenes.py, CSPICE N0067).
/// </summary>
internal static class Scenes
{
    /// <summary>The name of the sequence, which is chosen like a scene.</summary>
    public const string Sequence = "sequence";

    private const double Megabyte = 1e6;


    /// <summary>The thesis's example place, 1 091 km over 0 N 45 E, straight down: the terminator runs through the picture (Sun 0.88 degrees up).</summary>
    private static readonly SpacecraftState Far = Nadir(55289.0, new Vector3D(2e6, 2e6, 0.0));

    /// <summary>100 km over 10 N 20 E, straight down; Sun 9.97 degrees up, in the east.</summary>
    private static readonly SpacecraftState LowNadir = Nadir(55306.67, Above(10.0, 20.0, 100e3));

    /// <summary>20 km over 10 N 20 E, 60 degrees off nadir to the north; Sun 3.01 degrees up, in the east, where the picture's middle is.</summary>
    private static readonly SpacecraftState Oblique = Tilted(Nadir(55306.09, Above(10.0, 20.0, 20e3)), 60.0);

    /// <summary>100 km over the north pole, straight down; Sun 1.56 degrees up, as high as it comes in 2010.</summary>
    private static readonly SpacecraftState Pole = Nadir(55295.0, Above(90.0, 0.0, 100e3));

    /// <summary>What a quick run measures.</summary>
    public static IReadOnlyList<string> QuickNames { get; } = ["far-4", Sequence];

    /// <summary>All, with the targets of the project's plan.</summary>
    public static IReadOnlyList<Scene> All { get; } =
    [
        new()
        {
            Name = "far-4", About = "far, LDEM_4", PixelsPerDegree = 4, State = Far, PovRay = PovRayUse.Repeatedly,
            Targets = new SceneTargets(0.12, 0.012, 100 * Megabyte, TimesFasterThanPovRay: 200.0),
        },
        new()
        {
            Name = "nadir-64", About = "100 km, nadir, LDEM_64", PixelsPerDegree = 64, State = LowNadir, PovRay = PovRayUse.Repeatedly,
            Targets = new SceneTargets(0.2, 0.020, 150 * Megabyte),
        },
        new()
        {
            Name = "oblique-64", About = "20 km, oblique, LDEM_64", PixelsPerDegree = 64, State = Oblique, PovRay = PovRayUse.Once,
            Targets = new SceneTargets(0.2, 0.020, 150 * Megabyte),
        },
        new()
        {
            Name = "far-64", About = "far, LDEM_64, exact", PixelsPerDegree = 64, State = Far, IsExact = true, PovRay = PovRayUse.Once,
            Targets = new SceneTargets(0.35, 0.060, 250 * Megabyte),
        },
        new()
        {
            Name = "far-512", About = "far, LDEM_512, levels of detail", PixelsPerDegree = 512, State = Far, PovRay = PovRayUse.No,
            Targets = new SceneTargets(1.0, 0.060, 1000 * Megabyte),
        },
        new()
        {
            Name = "oblique-512", About = "20 km, oblique, LDEM_512, levels of detail", PixelsPerDegree = 512, State = Oblique, PovRay = PovRayUse.No,
            Targets = new SceneTargets(1.0, 0.060, 1000 * Megabyte),
        },
        new()
        {
            Name = "pole-64", About = "100 km over the north pole, LDEM_64", PixelsPerDegree = 64, State = Pole, PovRay = PovRayUse.Once,
            Targets = new SceneTargets(0.4, 0.100, 250 * Megabyte),
        },
    ];

    /// <summary>A scene by its name.</summary>
    /// <exception cref="BenchmarkException">There is none; the message has the names.</exception>
    public static Scene Named(string name) => All.FirstOrDefault(scene => scene.Name == name)
        ?? throw new BenchmarkException($"there is no scene {name}; there are {string.Join(", ", All.Select(scene => scene.Name))} and {Sequence}.");

    private static SpacecraftState Nadir(double mjd, Vector3D positionMoonMe) =>
        new(new ModifiedJulianDate(mjd), positionMoonMe, NadirPointing.MoonFromCamera(positionMoonMe));

    /// <summary>Turned about the picture's right, so that what lies above its middle comes into it.</summary>
    private static SpacecraftState Tilted(SpacecraftState state, double degrees) => state with
    {
        MoonFromCamera = state.MoonFromCamera * UnitQuaternion.FromAxisAngle(Vector3D.UnitY, double.DegreesToRadians(degrees)),
    };

    /// <summary>m, MOON_ME; the altitude is over the mean radius.</summary>
    private static Vector3D Above(double latitudeDegrees, double longitudeDegrees, double altitude)
    {
        double radius = MoonConstants.MeanRadius + altitude;
        if (latitudeDegrees == 90.0)
        {
            return radius * Vector3D.UnitZ; // the cosine of a right angle is not 0 in doubles
        }

        (double sinLatitude, double cosLatitude) = Math.SinCos(double.DegreesToRadians(latitudeDegrees));
        (double sinLongitude, double cosLongitude) = Math.SinCos(double.DegreesToRadians(longitudeDegrees));
        return radius * new Vector3D(cosLatitude * cosLongitude, cosLatitude * sinLongitude, sinLatitude);
    }
}
