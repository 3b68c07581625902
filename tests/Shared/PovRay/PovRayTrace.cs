using System.Globalization;
using System.Text;
using System.Text.RegularExpressions;
using Msisf.Core.Numerics;

namespace Msisf.TestSupport;

/// <summary>Rays that POV-Ray's own <c>trace()</c> is asked about, and what it answers with all its digits.</summary>
internal sealed partial class PovRayTrace
{
    private readonly string _folder;
    private readonly StringBuilder _scene = new(
        "#version 3.7;\n#declare moon = texture { pigment { color rgb 1 } }\ncamera { location 0 look_at z }\n#declare N = <0,0,0>;\n");

    /// <param name="folder">Takes the scene; patterns are named relative to it.</param>
    public PovRayTrace(string folder) => _folder = folder;

    /// <summary>Declares an object.</summary>
    /// <param name="name">As POV-Ray wants it.</param>
    /// <param name="paths">Its pattern files.</param>
    public void Declare(string name, IEnumerable<string> paths)
    {
        _scene.Append(CultureInfo.InvariantCulture, $"#declare {name} = union {{\n");
        foreach (string path in paths)
        {
            _scene.Append(CultureInfo.InvariantCulture, $"#include \"{Path.GetRelativePath(_folder, path)}\"\n");
        }

        _scene.Append("}\n");
    }

    /// <summary>Adds a ray.</summary>
    /// <param name="name">The object.</param>
    /// <param name="startKm">km, as POV-Ray gets it.</param>
    /// <param name="direction">Any length.</param>
    public void Add(string name, Vector3D startKm, Vector3D direction) => _scene.Append(
        CultureInfo.InvariantCulture,
        $"#declare H = trace({name}, {Text(startKm)}, {Text(direction)}, "
            + $"N);\n#debug concat(\"HIT \",vstr(3,H,\",\",0,12),\"\\n\")\n#debug concat(\"NORMAL \",vstr(3,N,\",\",0,15),\"\\n\")\n");

    /// <summary>
    /// The answers to all rays in their order: the point in km and the normal; a normal of length 0 says that nothing was hit.
    /// </summary>
    /// <exception cref="InvalidOperationException">POV-Ray failed.</exception>
    public (Vector3D PointKm, Vector3D Normal)[] Run()
    {
        File.WriteAllText(Path.Combine(_folder, "trace.pov"), _scene.ToString());
        string log = ChildRun.Of(TestParts.Program("povray")!, ["+Itrace.pov", "-D", "-F", "+W1", "+H1"], _folder).Succeeded().Error;
        IEnumerable<Vector3D> points = HitLine().Matches(log).Select(Vector);
        IEnumerable<Vector3D> normals = NormalLine().Matches(log).Select(Vector);
        return [.. points.Zip(normals)];
    }

    private static string Text(Vector3D v) => string.Create(CultureInfo.InvariantCulture, $"<{v.X:R},{v.Y:R},{v.Z:R}>");

    private static Vector3D Vector(Match match) => new(Number(match, 1), Number(match, 2), Number(match, 3));

    private static double Number(Match match, int group) => double.Parse(match.Groups[group].Value, CultureInfo.InvariantCulture);

    [GeneratedRegex("^HIT ([-0-9.]+),([-0-9.]+),([-0-9.]+)$", RegexOptions.Multiline)]
    private static partial Regex HitLine();

    [GeneratedRegex("^NORMAL ([-0-9.]+),([-0-9.]+),([-0-9.]+)$", RegexOptions.Multiline)]
    private static partial Regex NormalLine();
}
