using Msisf.Core.Scene;

namespace Msisf.Adapters.Scene;

/// <summary>
/// Writes a scene in POV-Ray's language (thesis section 5.3): kilometres, body-fixed, round-trip numbers; of blocks in other axes
/// (<see cref="SceneAxes"/>), which it declares for their patterns. Patterns are included by file name only and found through POV-Ray's
/// library path, so that the scene holds no path of the machine that made it.
/// </summary>
public static class PovSceneWriter
{
    /// <summary>
    /// m. POV-Ray 3.7 draws nothing beyond 1e7 of its units (MAX_DISTANCE), which are kilometres here; an image from farther away is black.
    /// </summary>
    public const double MaxDistance = 1e10;

    private const string EvenGrey = "    pigment { color rgb<0.8, 0.8, 0.8> }\n";

    private const double EvenDiffuse = 0.8;

    private const string Settings =
        """
        global_settings
        {
            charset utf8
            assumed_gamma 1.0
        }
        """;

    /// <summary>km.</summary>
    private const double SunRadius = 1000.0;

    /// <summary>The Sun as in the thesis: a glowing ball of 1000 km radius, seen only by a ray straight into it.</summary>
    private const string SunLooksLike =
        """
            looks_like
            {
                sphere
                {
                    0, RADIUS
                    pigment { rgbt 1 }
                    hollow
                    interior
                    {
                        media
                        {
                            emission 1
                            density
                            {
                                spherical
                                density_map
                                {
                                    [0 rgb 0]
                                    [60 Orange]
                                    [80 Red]
                                    [100 Yellow]
                                }
                                scale RADIUS
                            }
                        }
                    }
                }
            }
        """;

    /// <summary>Writes one scene.</summary>
    /// <param name="writer">Where to; LF line ends are written whatever its setting.</param>
    /// <param name="scene">What.</param>
    public static void Write(TextWriter writer, RenderScene scene)
    {
        writer.Write(Invariant(
            $"// povray +W{scene.Camera.Width} +H{scene.Camera.Height} +L<pattern-repository>/{scene.PatternFolder} <this file>\n"));
        writer.Write("#version 3.7;\n\n");
        if (scene.Light.IsSun)
        {
            writer.Write("#declare Orange = rgb <1,0.5,0>;\n#declare Red = rgb <1,0,0>;\n#declare Yellow = rgb <1,1,0>;\n");
        }

        bool isMoved = scene.Axes != SceneAxes.MoonKilometres;
        if (isMoved)
        {
            writer.Write($"// km, MOON_ME: the origin of this scene\n#declare Origin = {Vector(scene.Axes.OriginBodyFixed / 1000.0)};\n");
            writer.Write(Invariant($"#declare UnitsPerKilometre = {scene.Axes.UnitsPerKilometre:R};\n"));
        }

        WriteTexture(writer, scene.Albedo, isMoved);
        WriteLines(writer, Settings);
        writer.Write("\ncamera\n{\n    perspective\n");
        writer.Write($"    location {Vector(scene.Axes.At(scene.Camera.PositionBodyFixed))}\n");
        writer.Write($"    right {Vector(scene.Camera.Right)}\n");
        writer.Write($"    up {Vector(scene.Camera.Up)}\n");
        writer.Write($"    direction {Vector(scene.Camera.Direction)}\n}}\n\n");
        writer.Write($"light_source\n{{\n    {Vector(scene.Axes.At(scene.Light.PositionBodyFixed))}\n    color rgb<1, 1, 1>\n");
        if (scene.Light.IsSun)
        {
            string radius = (SunRadius * scene.Axes.UnitsPerKilometre).ToString("R", CultureInfo.InvariantCulture);
            WriteLines(writer, SunLooksLike.Replace("RADIUS", radius, StringComparison.Ordinal));
        }

        writer.Write("}\n");
        foreach (string pattern in scene.Patterns)
        {
            writer.Write($"\n#include \"{pattern}\"");
        }

        writer.Write("\n");
    }

    /// <summary>
    /// The surface's colour. POV-Ray's spherical warp has its pole on the y axis and begins on the x axis; exchanging y and z puts
    /// longitude 0 at the image's left edge. The image has a row more over each pole, so it is a little higher than the warp's square.
    /// </summary>
    private static void WriteTexture(TextWriter writer, SceneAlbedo? albedo, bool isMoved)
    {
        writer.Write("#declare moon = texture\n{\n");
        writer.Write(albedo is null ? EvenGrey : Invariant(
            $"    pigment\n    {{\n        image_map {{ png \"{albedo.ImageName}\" gamma 1.0 map_type 0 interpolate 2 }}\n"
                + $"        scale <1, {(albedo.Rows + 2.0) / albedo.Rows:R}, 1>\n        translate <0, {-1.0 / albedo.Rows:R}, 0>\n"
                + $"        warp {{ spherical }}\n"
                + $"        matrix <1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0>\n        rotate <0, 0, {albedo.WestDegrees:R}>\n"
                + $"{(isMoved ? "        translate -Origin\n        scale UnitsPerKilometre\n" : string.Empty)}    }}\n"));
        writer.Write(Invariant(
            $"    finish\n    {{\n        ambient 0.0\n        diffuse {albedo?.Diffuse ?? EvenDiffuse:R}\n    }}\n}}\n\n"));
    }

    private static void WriteLines(TextWriter writer, string block) =>
        writer.Write(block.ReplaceLineEndings("\n") + "\n");

    private static string Vector(Vector3D v) =>
        Invariant($"<{v.X:R}, {v.Y:R}, {v.Z:R}>");
}
