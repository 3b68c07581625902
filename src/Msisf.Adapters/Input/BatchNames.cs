using Msisf.Core.Camera;

namespace Msisf.Adapters.Input;

/// <summary>Names of the columns of a batch file, in the groups that go together.</summary>
internal static class BatchNames
{
    public const string Time = "time";
    public const string Seconds = "seconds";
    public const string Height = "height";
    public const string HeightKilometres = "height_km";
    public const string Altitude = "alt";
    public const string LookHeight = "look_height";
    public const string OffNadir = "off_nadir";
    public const string Azimuth = "azimuth";
    public const string Roll = "roll";
    public const string Up = "up";
    public const string Noise = "noise_seed";
    public const string Exposure = "exposure_factor";

    private static readonly Dictionary<string, string> OtherNames = new(StringComparer.OrdinalIgnoreCase)
    {
        ["MJD"] = Time,
        ["rx"] = "x",
        ["ry"] = "y",
        ["rz"] = "z",
        ["q0"] = "qw",
        ["q1"] = "qx",
        ["q2"] = "qy",
        ["q3"] = "qz",
    };

    /// <summary>Latitude and longitude of the camera; one of <see cref="Heights"/> goes with them.</summary>
    public static string[] Place { get; } = ["lat", "lon"];

    /// <summary>Ways to give the camera's height.</summary>
    public static string[] Heights { get; } = [Height, HeightKilometres, Altitude];

    public static string[] Position { get; } = ["x", "y", "z"];

    public static string[] PositionKilometres { get; } = ["x_km", "y_km", "z_km"];

    public static string[] Quaternion { get; } = ["qx", "qy", "qz", "qw"];

    public static string[] Matrix { get; } = ["r11", "r12", "r13", "r21", "r22", "r23", "r31", "r32", "r33"];

    public static string[] Euler { get; } = ["euler1", "euler2", "euler3"];

    public static string[] Target { get; } = ["look_lat", "look_lon"];

    public static string[] Motion { get; } = [.. CameraMotion.NumberNames];

    public static string[] Sun { get; } = ["sun_x", "sun_y", "sun_z"];

    /// <summary>All names, in the order in which messages list them.</summary>
    public static string[] All { get; } =
    [
        Time, Seconds, .. Place, .. Heights, .. Position, .. PositionKilometres, .. Quaternion, .. Matrix, .. Euler, .. Target, LookHeight,
        OffNadir, Azimuth, Roll, Up, .. Motion, .. Sun, Noise, Exposure,
    ];

    /// <summary>The name of a column, whatever its case, or whichever of its names is written; null if there is no such column.</summary>
    public static string? Known(string written)
    {
        string name = OtherNames.GetValueOrDefault(written, written);
        return Array.Find(All, known => known.Equals(name, StringComparison.OrdinalIgnoreCase));
    }
}
