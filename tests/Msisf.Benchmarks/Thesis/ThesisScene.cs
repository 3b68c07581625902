using System.Globalization;
using Msisf.Core.Camera;
using Msisf.Core.Numerics;

namespace Msisf.Benchmarks.Thesis;

/// <summary>
/// The scene of thesis section 5.3, as the program of 2012 wrote it; the Sun's looks, which no image of the ground shows, are left out. It
/// is written here once more so that the base line of all ratios stays what it is, whatever becomes of the program's own scenes.
/// </summary>
internal static class ThesisScene
{
    private const string Surface =
        """
        #version 3.7;
        #declare moon = texture { pigment { color rgb<0.8, 0.8, 0.8> } finish { ambient 0.0 diffuse 0.8 } }
        global_settings { charset utf8 assumed_gamma 1.0 }

        """;

    /// <summary>POV-Ray's settings of 2012: its default antialiasing.</summary>
    public static IReadOnlyList<string> Options { get; } =
        ["+Q11", "Antialias=On", "Antialias_Depth=3", "Antialias_Threshold=0.3", "Jitter=On", "Jitter_Amount=0.5"];

    /// <summary>Writes the scene.</summary>
    /// <param name="writer">Where to.</param>
    /// <param name="camera">Camera.</param>
    /// <param name="sunPositionBodyFixed">m, MOON_ME.</param>
    /// <param name="patterns">Pattern files, on POV-Ray's library path or with it.</param>
    public static void Write(TextWriter writer, PinholeCamera camera, Vector3D sunPositionBodyFixed, IEnumerable<string> patterns)
    {
        writer.Write(Surface);
        writer.Write(string.Create(
            CultureInfo.InvariantCulture,
            $"camera {{ perspective location {Kilometres(camera.PositionBodyFixed)} right {Text(camera.Right)} up {Text(camera.Up)} "
                + $"direction {Text(camera.Direction)} }}\n"));
        writer.Write($"light_source {{ {Kilometres(sunPositionBodyFixed)} color rgb<1, 1, 1> }}\n");
        foreach (string pattern in patterns)
        {
            writer.Write($"#include \"{pattern}\"\n");
        }
    }

    private static string Kilometres(Vector3D positionMetres) => Text(positionMetres / 1000.0);

    private static string Text(Vector3D v) => string.Create(CultureInfo.InvariantCulture, $"<{v.X:R}, {v.Y:R}, {v.Z:R}>");
}
