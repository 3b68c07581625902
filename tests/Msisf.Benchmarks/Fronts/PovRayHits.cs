using System.Globalization;
using System.Text;
using Msisf.Benchmarks.Programs;
using Msisf.Core.Camera;
using Msisf.Core.Numerics;

namespace Msisf.Benchmarks.Fronts;

/// <summary>The points that POV-Ray itself finds on the surface of a scene, by its trace().</summary>
internal static class PovRayHits
{
    private const string SceneName = "trace.pov";
    private const string Include = "#include ";
    private const string Mark = "HIT ";

    /// <summary>Traces.</summary>
    /// <param name="scenePath">The scene, whose patterns are taken.</param>
    /// <param name="patternRoot">Folder that holds them, or whose folders do.</param>
    /// <param name="rays">MOON_ME, m.</param>
    /// <param name="folder">Existing folder for the scene of this measure.</param>
    /// <returns>m, MOON_ME, a point for each ray; null where nothing is met.</returns>
    public static IReadOnlyList<Vector3D?> Trace(string scenePath, string patternRoot, IEnumerable<Ray> rays, string folder)
    {
        StringBuilder scene = new(
            "#version 3.7;\nglobal_settings { assumed_gamma 1.0 }\n#declare moon = texture { pigment { rgb 1 } }\n#declare N = <0, 0, "
                + "0>;\n#declare All = union {\n");
        scene.AppendJoin(
            '\n', File.ReadLines(scenePath).Where(line => line.TrimStart().StartsWith(Include, StringComparison.Ordinal))).Append("\n}\n");
        foreach (Ray ray in rays)
        {
            scene.Append(
                CultureInfo.InvariantCulture, $"#declare H = trace(All, {Text(ray.Origin / 1000.0)}, {Text(ray.Direction)}, N);\n");
            scene.Append(
                CultureInfo.InvariantCulture,
                $"#debug concat(\"{Mark}\", vstr(3, H, \" \", 0, 12), \" \", str(vlength(N), 0, 3), \"\\n\")\n");
        }

        File.WriteAllText(Path.Combine(folder, SceneName), scene.ToString());
        string[] libraries = [patternRoot, .. Directory.GetDirectories(patternRoot, "*", SearchOption.AllDirectories)];
        ProgramRun run = new ChildProgram("povray", folder).Run(
            [$"+I{SceneName}", "-D", "-F", "+W1", "+H1", .. libraries.Select(library => $"+L{library}")]);
        return [.. run.Errors.Where(line => line.StartsWith(Mark, StringComparison.Ordinal)).Select(Point)];
    }

    private static Vector3D? Point(string line)
    {
        double[] numbers = [.. line[Mark.Length..].Split(' ').Select(number => double.Parse(number, CultureInfo.InvariantCulture))];
        bool isMet = numbers[3] > 0.0; // the length of the normal
        return isMet ? 1000.0 * new Vector3D(numbers[0], numbers[1], numbers[2]) : null;
    }

    private static string Text(Vector3D v) => string.Create(CultureInfo.InvariantCulture, $"<{v.X:R}, {v.Y:R}, {v.Z:R}>");
}
