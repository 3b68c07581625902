using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Surface;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;

namespace Msisf.Core.Tests.Support;

/// <summary>Cameras and Suns of all kinds, the same for the same number.</summary>
internal static class CameraCases
{
    /// <summary>Kinds of camera that <see cref="Make"/> goes through.</summary>
    public const int Kinds = 12;

    /// <param name="number">Of the case.</param>
    /// <param name="grid">The cameras stand above its surface.</param>
    /// <param name="pixels">Pixels of the image, about.</param>
    public static (PinholeCamera Camera, Vector3D Sun, string Kind) Make(int number, IGlobalGrid grid, int pixels)
    {
        Random random = new(20120222 + number);
        double Between(double low, double high) => low + ((high - low) * random.NextDouble());
        double Log(double low, double high) => low * Math.Pow(high / low, random.NextDouble());
        Vector3D Direction()
        {
            double z = Between(-1.0, 1.0);
            double longitude = Between(0.0, 2.0 * Math.PI);
            double across = Math.Sqrt((1.0 - z) * (1.0 + z));
            return new Vector3D(across * Math.Cos(longitude), across * Math.Sin(longitude), z);
        }

        int kind = number % Kinds;
        Vector3D up = Direction();
        up = kind switch
        {
            7 => new Vector3D(0.0, 0.0, random.Next(2) == 0 ? 1.0 : -1.0),
            8 => new Vector3D(Between(-0.05, 0.05), Between(-0.05, 0.05), random.Next(2) == 0 ? 1.0 : -1.0).Normalized(),
            9 => new Vector3D(1.0, Between(-0.02, 0.02), Between(-1.0, 1.0)).Normalized(),
            _ => up,
        };
        double surface = TerrainHeight.RadiusBelow(grid, up);
        double altitude = kind switch
        {
            0 => 1e9,
            1 => Between(1.7e6, 4e6),
            2 => 100e3,
            3 => 20e3,
            4 => Between(1e3, 5e3),
            5 => Log(50.0, 3e3),
            6 => Log(1e3, 1e8),
            7 or 8 => Log(3e3, 5e6),
            9 => Log(5e3, 3e6),
            10 => Log(2e4, 1e7),
            _ => Log(1e3, 1e6),
        };
        double distance = surface + altitude;
        Vector3D position = distance * up;
        double limb = Math.Atan2(1_737_400.0, Math.Sqrt(Math.Max(0.0, (distance - 1_737_400.0) * (distance + 1_737_400.0))));
        (double tilt, double fov) = kind switch
        {
            0 => (0.0, 2.2 * limb),
            1 => (0.0, Between(0.5, 2.4) * limb),
            2 => (0.0, Between(0.2, 1.2)),
            3 => (limb - Between(0.0, 0.3), Between(0.3, 1.0)),
            4 => (limb - Between(-0.1, 0.3), Between(0.3, 1.2)),
            5 => (Between(0.5, 1.7), Between(0.3, 2.0)),
            6 => (Between(0.0, 1.3) * limb, Log(1e-3, 175.0) * Math.PI / 180.0),
            7 or 8 => (random.Next(2) == 0 ? 0.0 : Between(0.0, 1.1) * limb, Between(0.1, 1.5)),
            9 => (Between(0.0, 1.0) * limb, Between(0.1, 1.5)),
            10 => (limb * Between(0.98, 1.02), Log(1e-3, 3.0) * Math.PI / 180.0),
            _ => (Between(0.0, 2.5), Between(0.1, 3.0)),
        };
        fov = Math.Clamp(fov, 1e-3 * Math.PI / 180.0, 175.0 * Math.PI / 180.0);
        double aspect = kind is 6 or 11 ? Log(0.02, 50.0) : Between(0.6, 1.8);
        int width = Math.Max(1, (int)Math.Sqrt(pixels * aspect));
        int height = Math.Max(1, (int)Math.Sqrt(pixels / aspect));
        Vector3D side = Vector3D.Cross(up, Direction()).Normalized();
        Vector3D forward = (Math.Cos(tilt) * -up) + (Math.Sin(tilt) * side);
        Vector3D right = Vector3D.Cross(forward, kind < 6 ? up + (1e-3 * Direction()) : Direction()).Normalized();
        PinholeCamera camera = new(position, Attitude(forward, right), fov, width, height);
        Vector3D sun = random.Next(3) == 0
            ? ((Between(-0.25, 0.25) * up) + Vector3D.Cross(up, Direction()).Normalized()).Normalized() // low over what is seen
            : Direction();
        return (camera, 1.496e11 * sun, Names[kind]);
    }

    public static IReadOnlyList<string> Names { get; } =
    [
        "far", "disc", "nadir-100km", "oblique-20km", "low-1-5km", "crawling", "any", "on-polar-axis", "over-pole", "prime-meridian",
        "limb-zoom", "off-pointing",
    ];

    /// <summary>The attitude that looks along <paramref name="forward"/> with <paramref name="right"/> to the right.</summary>
    public static UnitQuaternion Attitude(Vector3D forward, Vector3D right)
    {
        Vector3D up = Vector3D.Cross(right, forward);
        Vector3D back = -forward;
        return UnitQuaternion.FromMatrix(new RotationMatrix(
            new Vector3D(back.X, right.X, up.X), new Vector3D(back.Y, right.Y, up.Y), new Vector3D(back.Z, right.Z, up.Z)));
    }
}
