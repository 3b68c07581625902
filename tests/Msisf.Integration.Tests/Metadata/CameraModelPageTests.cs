using System.Globalization;
using System.Text.RegularExpressions;
using Msisf.Core.Attitude;
using Msisf.Core.Numerics;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Metadata;

/// <summary>The lines of NumPy of docs/camera-model.md, as they stand there, project the points of a meta file to its pixels.</summary>
public sealed partial class CameraModelPageTests : IDisposable
{
    /// <summary>px: positions have 16 digits, and a pixel is some 100 m wide.</summary>
    private const double PixelTolerance = 1e-6;

    private const int Width = 320;
    private const int Height = 200;

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [RequiresTheory(Part.Ldem4, Part.Python, Part.Numpy)]
    [InlineData("--position -55,-12,terrain+60000 --look-at -58.6,-14.5 --roll 25 --fov 57 --time 2010-04-06T20:24:00Z")]
    [InlineData("--position 40,200,2.5E6 --off-nadir 12,77 --up north --fov 20 --time 55289")]
    [InlineData(
        "--fixed-state {55289,2E6,2E6,0,-2.391176183943345E-1,9.904576054128762E-2,3.696438106143861E-1,8.923991008325228E-1} --fov 40")]
    public void Page_ItsLines_ProjectThePointsOfAMetaFileToItsPixels(string camera)
    {
        CommandLineRun run = CommandLineRun.Of(
            [
                .. camera.Split(' '), "--width", $"{Width}", "--height", $"{Height}", "--grid", "10", "--surface", "terrain",
                "--renderer", "native", "--ephemeris", "builtin", "--ldem", TestParts.Ldem4Label!, "--output-dir", _folder.Path,
                "--output-name", "view",
            ]);
        Assert.True(run.ExitCode == 0, run.Error);

        string script = _folder["project.py"];
        File.WriteAllText(script, LinesOfPage() + Reader);
        string[] found = ChildRun.Of(
            TestParts.Python!, [script, _folder["view.xml"], $"{Width}", $"{Height}"], _folder.Path).Succeeded().Output.Split();

        Assert.InRange(int.Parse(found[0], CultureInfo.InvariantCulture), 100, 32 * 20);
        Assert.InRange(double.Parse(found[1], CultureInfo.InvariantCulture), 0.0, PixelTolerance);
    }

    [RequiresFact(Part.Python, Part.Numpy)]
    public void Page_ItsLinesBack_AreTheQuaternionsOfThePointing()
    {
        Vector3D position = new(1.2e6, -0.9e6, 1.3e6);
        Vector3D[] targets = [new(1.1e6, -0.8e6, 1.0e6), new(-2e6, 1e5, 3e6), new(1.3e6, -0.9e6, 1.3e6), new(1.2e6, 9e6, 1.3e6)];
        string vectors = string.Join(", ", targets.Select(target => $"{target - position}".Replace('(', '[').Replace(')', ']')));
        string script = _folder["back.py"];
        File.WriteAllText(
            script,
            LinesOfPage() + $$"""

            for forward in [{{vectors}}]:
                given = quaternion_looking(np.array(forward), [1.2e6, -0.9e6, 1.3e6])
                R = camera(np.zeros(3), given, 40, 8, 8)[1]
                again = quaternion_of_opencv(R)
                print(*map(repr, map(float, given)), *map(repr, map(float, again)))
            """);
        string[] lines = ChildRun.Of(TestParts.Python!, [script], _folder.Path).Succeeded().Output.TrimEnd().Split('\n');

        Assert.Equal(targets.Length, lines.Length);
        foreach ((string line, Vector3D target) in lines.Zip(targets))
        {
            double[] q = [.. line.Split().Select(number => double.Parse(number, CultureInfo.InvariantCulture))];
            UnitQuaternion expected = Boresight.MoonFromCamera(position, Boresight.Towards(position, target), position, roll: 0.0);
            AssertSame(expected, UnitQuaternion.FromComponents(q[0], q[1], q[2], q[3]));
            AssertSame(expected, UnitQuaternion.FromComponents(q[4], q[5], q[6], q[7]));
        }

        static void AssertSame(UnitQuaternion expected, UnitQuaternion found)
        {
            UnitQuaternion turn = expected.Conjugate * found;
            Assert.InRange(new Vector3D(turn.X, turn.Y, turn.Z).Length, 0.0, Rounding.OfTurns);
        }
    }

    // Prints the number of pixels and the greatest distance in px.
    private const string Reader =
        """

        import sys
        import xml.etree.ElementTree as tree
        general, pixels = tree.parse(sys.argv[1]).getroot()
        vector = lambda element: np.array([float(element.find("Vector3D").get(name)) for name in "xyz"])
        quaternion = [float(general.find("CameraOrientation/Quaternion").get(name)) for name in "xyzr"]
        width, height = int(sys.argv[2]), int(sys.argv[3])
        K, R, t = camera(vector(general.find("CameraPosition")), quaternion, float(general.find("FOV").text), width, height)
        misses = [np.hypot(*(np.array(pixel(vector(p.find("Position")), K, R, t)) - [int(p.get("h")), int(p.get("v"))])) for p in pixels]
        print(len(misses), max(misses))
        """;

    private static string LinesOfPage()
    {
        string page = File.ReadAllText(Path.Combine(TestParts.RepositoryRoot, "docs", "camera-model.md"));
        return string.Concat(PythonBlock().Matches(page).Select(block => block.Groups[1].Value));
    }

    [GeneratedRegex("```python\n(.*?)```", RegexOptions.Singleline)]
    private static partial Regex PythonBlock();
}
