using System.Globalization;
using System.Text.RegularExpressions;
using Msisf.Adapters.Ephemeris;
using Msisf.Adapters.Input;
using Msisf.App.Preparation;
using Msisf.Core.Ephemeris;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Orbit;
using Msisf.Core.Scene;
using Msisf.Core.Time;
using Msisf.Integration.Tests.Ephemeris;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Input;

/// <summary>
/// States in the habits of other programs are those that numpy and CSPICE say (tests/reference/states.py), and the recipes of
/// docs/missions.md, as they stand there, make them.
/// </summary>
public sealed partial class OtherProgramsTests : IDisposable
{
    /// <summary>m: the ground turns by 5 m/s, and an MJD in a double is right to 0.6 microseconds.</summary>
    private const double Metres = 1e-5;

    /// <summary>1: 17 digits, turned a few times; the engines' rotations differ by 1e-12.</summary>
    private const double Rotation = 4e-12;

    /// <summary>s: an MJD in a double is right to 0.6 microseconds, ISO times are written to 1.</summary>
    private const double Seconds = 3e-6;

    private static readonly string Page = File.ReadAllText(Path.Combine(TestParts.RepositoryRoot, "docs", "missions.md"));

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [RequiresFact(Part.CSpice, Part.Python, Part.Numpy)]
    public void Read_EachHabit_IsTheStateThatNumpyAndCSpiceSay()
    {
        RunReference("habits", _folder.Path);

        string[] all = ["wxyz", "opencv", "j2000", "still", "thesis", "seconds"];
        Assert.All(all, name => AssertStates("expected.txt", Read($"{name}.csv"), Rotation));
        AssertStates("zyx.txt", Read("zyx.csv"), Rotation);
        AssertStates("313.txt", Read("313.csv"), Rotation);
        Assert.Contains("313", File.ReadAllText(_folder["313.csv"]), StringComparison.Ordinal);

        // Five decimals are right to 2e-5 rad; without --normalize some of them are no rotation.
        BadInputException failure = Assert.Throws<BadInputException>(() => Read("rounded.csv"));
        Assert.Contains("write each number with at least 7 decimals, or give --normalize.", failure.Message, StringComparison.Ordinal);
        AssertStates("expected.txt", Read("rounded.csv", new BatchConventions { Normalizes = true }), 2e-5);

        // What the line says, an option says too.
        File.WriteAllLines(_folder["bare.csv"], File.ReadLines(_folder["j2000.csv"]).Skip(1));
        AssertStates("expected.txt", Read("bare.csv", new BatchConventions { Frame = OrbitFrame.J2000 }), Rotation);
    }

    [RequiresFact(Part.CSpice, Part.Python)]
    public void Page_RecipeForSpice_WritesTheStatesThatCSpiceSays()
    {
        string script = Blocks("python").Single(block => block.Contains("spiceypy", StringComparison.Ordinal))
            .Replace("\"mission.tm\", \"LRO\", \"LRO_LROCNACL\"", "\"msisf.tm\", \"EARTH\", \"MOON_PA\"", StringComparison.Ordinal)
            .Replace("COUNT = \"2010-04-06T20:24:00\", 10.0, 60", "COUNT = \"2010-04-06T20:24:00\", 10.0, 4", StringComparison.Ordinal);
        File.WriteAllText(_folder["recipe.py"], script);
        RunReference("spice", _folder.Path, "2010-04-06T20:24:00", "10", "4");
        RunPython(_folder["recipe.py"]);

        AssertStates("expected.txt", Read("states.csv"), Rotation, metres: 2e-3); // 6 decimals of a second, 4e8 m away
    }

    [RequiresFact(Part.CSpice, Part.Python, Part.Numpy)]
    public void Page_RecipeForGmat_ReadsItsReport()
    {
        File.WriteAllText(
            _folder["recipe.py"], Blocks("python").Single(block => block.Contains("loadtxt", StringComparison.Ordinal)));
        RunReference("gmat", _folder.Path);
        RunPython(_folder["recipe.py"]);

        AssertStates("expected.txt", Read("states.csv"), Rotation);
    }

    [RequiresFact(Part.Ldem4)]
    public void Page_TableOfMatlab_LooksDownAsItsCommandShows()
    {
        File.WriteAllText(
            _folder["states.csv"], Blocks(string.Empty).Single(block => block.StartsWith("seconds,", StringComparison.Ordinal)));
        string[] words = [.. Blocks("sh").Single().Split().Select(word => word == "states.csv" ? _folder["states.csv"] : word)];

        CommandLineRun run = CommandLineRun.Of(
            [.. words.Skip(1).Where(word => word.Length > 0), "--format", "csv", "--ldem", TestParts.Ldem4Label!]);

        Assert.True(run.ExitCode == 0, run.Error);
        string[][] lines = [.. run.Output.TrimEnd().Split('\n').Select(line => line.Split(','))];
        Assert.Equal(["2010-04-06T20:24:00Z", "2010-04-06T20:24:30Z"], [lines[1][1], lines[4][1]]);
        int longitude = Array.IndexOf(lines[0], "boresight_longitude_deg");
        for (int k = 0; k < 4; k++)
        {
            Assert.Equal(0.5 * k, double.Parse(lines[k + 1][longitude], CultureInfo.InvariantCulture), Rounding.OfConvertedPlaces);
        }
    }

    private IReadOnlyList<SpacecraftState> Read(string name, BatchConventions? conventions = null)
    {
        using OpenedEphemeris engine = Engines.BuiltIn();
        RunGeometry scene = new(
            () => throw new InvalidOperationException("no terrain is needed"), () => engine.Engine, () => engine.Engine.TimeScale,
            Aberration.None);
        using StreamReader reader = new(_folder[name]);
        return BatchFileReader.Read(reader, name, scene, conventions);
    }

    private void AssertStates(
        string expected, IReadOnlyList<SpacecraftState> found, double rotation, double metres = Metres, double seconds = Seconds)
    {
        double[][] lines = [.. File.ReadLines(_folder[expected]).Select(line => line.Split().Select(
            number => double.Parse(number, CultureInfo.InvariantCulture)).ToArray())];
        Assert.NotEmpty(lines);
        Assert.Equal(lines.Length, found.Count);
        foreach ((double[] n, SpacecraftState state) in lines.Zip(found))
        {
            Assert.InRange(Math.Abs(state.Time.SecondsSince(Moments.OfMjd(n[0]))), 0.0, seconds);
            Assert.InRange((state.PositionBodyFixed - new Vector3D(n[1], n[2], n[3])).Length, 0.0, metres);
            Vector3D[] axes = [Vector3D.UnitX, Vector3D.UnitY, Vector3D.UnitZ];
            Assert.All(Enumerable.Range(0, 3), i => Assert.InRange(
                ((state.MoonFromCamera * axes[i]) - new Vector3D(n[4 + i], n[7 + i], n[10 + i])).Length, 0.0, rotation));
        }
    }

    /// <summary>Kernels are beside the scripts, as users have them in their own folder.</summary>
    private void RunReference(params string[] arguments)
    {
        foreach (string kernel in Directory.EnumerateFiles(TestParts.Kernels))
        {
            File.CreateSymbolicLink(_folder[Path.GetFileName(kernel)], kernel);
        }

        RunPython(Path.Combine(TestParts.RepositoryRoot, "tests", "reference", "states.py"), arguments);
    }

    private void RunPython(string script, params string[] arguments) => ChildRun.Of(
        TestParts.Python!, ["-B", script, .. arguments], _folder.Path, environment: new Dictionary<string, string>
        {
            ["MSISF_CSPICE"] = TestParts.CSpiceLibrary!,
            ["MSISF_KERNELS"] = "msisf.tm",
            ["PYTHONPATH"] = Path.Combine(TestParts.RepositoryRoot, "tests", "reference", "spice"),
        }).Succeeded();

    private static string[] Blocks(string language) =>
    [
        .. Block().Matches(Page[Page.IndexOf("## States as a batch file", StringComparison.Ordinal)..])
            .Where(match => match.Groups[1].Value == language).Select(match => match.Groups[2].Value),
    ];

    [GeneratedRegex("```([a-z]*)\n(.*?)```", RegexOptions.Singleline)]
    private static partial Regex Block();
}
