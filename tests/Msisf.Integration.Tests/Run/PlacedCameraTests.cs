using System.Globalization;
using System.Xml.Linq;
using Msisf.Core.Numerics;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Run;

/// <summary>Cameras given by place, target, date and frame, as a user gives them, on the real model.</summary>
public sealed class PlacedCameraTests : IDisposable
{
    /// <summary>
    /// degrees: the image's facets have their vertices on a lattice, up to 0.016 m away (<see cref="Tolerances.VertexLattice"/>); a line
    /// of sight 60 degrees from the vertical meets them 0.03 m away, and a degree is 30 km.
    /// </summary>
    private const double Degrees = 1e-6;

    /// <summary>Stands for the path of the batch file, which has blanks.</summary>
    private const string Batch = "FLIGHT";

    private const string Clavius = "--position -55,-12,terrain+60000 --time 2010-04-06T20:24:00Z --look-at";

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [RequiresTheory(Part.Ldem4)]
    [InlineData($"{Clavius} -58.6,-14.5 --roll 25", -58.6, 345.5)]
    [InlineData($"{Clavius} -55,-12", -55.0, 348.0)]
    [InlineData($"{Clavius} nadir --up sun", -55.0, 348.0)]
    [InlineData("--position 90,33,1E6 --time 55289 --look-at 80,100", 80.0, 100.0)]
    public void Run_LookAt_HasThePlaceInTheMiddleOfTheImage(string camera, double latitude, double longitude)
    {
        XElement root = Render("middle", $"{camera} --surface terrain --width 101 --height 101 --grid 51");

        XElement middle = Assert.Single(root.Descendants("Pixel"));
        XElement place = middle.Element("SelenographicCoordinates")!;
        Assert.Equal(latitude, Number(place, "lat"), Degrees);
        Assert.Equal(longitude, Number(place, "lon"), Degrees);
    }

    [RequiresTheory(Part.Ldem4)]
    [InlineData("-58.6,-14.5", false)]
    [InlineData("-14.5,-58.6", true)]
    [InlineData("-58.6,165.5,0", true)]
    public void Run_LookAtBeyondTheHorizon_Warns(string target, bool isHidden) => Assert.Equal(
        isHidden,
        CommandLineRun.Of([.. $"{Clavius} {target} --dry-run --ephemeris builtin --ldem".Split(' '), TestParts.Ldem4Label!])
            .Error.Contains("msis: warning: --look-at: the place lies behind ground that hides it", StringComparison.Ordinal));

    [RequiresFact(Part.Ldem4)]
    public void Run_EachWayToSayAState_MakesTheSameBytes()
    {
        XElement root = Render("placed", $"{Clavius} -58.6,-14.5 --roll 25");
        byte[] image = File.ReadAllBytes(_folder["placed.png"]);
        byte[] meta = File.ReadAllBytes(_folder["placed.xml"]);
        string canonical = root.Descendants("CommandLine").Single().Value;
        Assert.StartsWith("--fixed-state '{55292.85,", canonical, StringComparison.Ordinal);

        File.WriteAllText(
            _folder["flight.csv"],
            "time,lat,lon,height,look_lat,look_lon,roll\n2010-096T22:24:00+02:00,-55,-12,terrain+60000,-58.6,-14.5,25\n");
        Render("listed", $"--batch-file {Batch}");
        string state = canonical.Split('\'')[1];
        Render("fixed", $"--fixed-state {state}");
        Render("dated", $"--fixed-state {state.Replace("55292.85", "2010-04-06T20:24:00Z", StringComparison.Ordinal)}");

        foreach (string name in (string[])["listed", "fixed", "dated"])
        {
            Assert.Equal(image, File.ReadAllBytes(_folder[$"{name}.png"]));
            Assert.Equal(meta, File.ReadAllBytes(_folder[$"{name}.xml"]));
        }
    }

    [RequiresFact(Part.Ldem4)]
    public void Run_LvlhQuaternionOfThePage_LooksDownWithTheFlightUp()
    {
        const string orbit = "--kepler-set {1.9E6,0.05,0.7,1.1,0.9,2.0} --epoch 55289 --orbit-frame j2000";
        XElement before = Render("before", $"{orbit} --time 2010-04-03T01:00:00Z");
        XElement after = Render("after", $"{orbit} --time 2010-04-03T01:00:01Z");
        XElement found = Render(
            "lvlh",
            $"{orbit} --time 2010-04-03T01:00:00Z --attitude {{0,0.7071067811865476,0,0.7071067811865476}} --attitude-frame lvlh");

        Vector3D position = Position(found);
        XElement quaternion = found.Descendants("Quaternion").Single();
        UnitQuaternion moonFromCamera = UnitQuaternion.FromComponents(
            Number(quaternion, "x"), Number(quaternion, "y"), Number(quaternion, "z"), Number(quaternion, "r"));
        Assert.Equal(Position(before), position);
        Assert.InRange(((moonFromCamera * -Vector3D.UnitX) + position.Normalized()).Length, 0.0, Rounding.OfTurns);

        // Up is along the track: the Moon turns below the orbit by 2.7e-6 rad in this second, of 8e-4 rad of flight.
        Vector3D track = Position(after) - position;
        Vector3D level = (track - (Vector3D.Dot(track, position) / position.LengthSquared * position)).Normalized();
        Assert.InRange(Vector3D.AngleBetween(moonFromCamera * Vector3D.UnitZ, level), 0.0, 5e-3);
    }

    [RequiresFact(Part.Ldem4)]
    public void Run_OrbitWithDefaults_SaysOnceWhatTheFrameCosts()
    {
        CommandLineRun run = RunOf(
            "orbit_{step}",
            "--kepler-set {1.9E6,0.05,0.7,1.1,0.9,2.0} --epoch 55289 --time-interval 55289:0.04166666666667:55289.0833333333334");

        Assert.Equal(0, run.ExitCode);
        Assert.Single(
            run.Error.Split('\n'),
            line => line.Contains(
                "2 h from the epoch its ground track is off by 1.1 degrees, up to 33.3 km", StringComparison.Ordinal));
    }

    private XElement Render(string name, string words)
    {
        CommandLineRun run = RunOf(name, words);
        Assert.True(run.ExitCode == 0, run.Error);
        return XDocument.Load(_folder[$"{name}.xml"]).Root!;
    }

    private CommandLineRun RunOf(string name, string words) => CommandLineRun.Of(
        [
            .. (words.Contains("--width", StringComparison.Ordinal) ? words : $"{words} --width 64 --height 48 --grid 16")
                .Split(' ').Select(word => word == Batch ? _folder["flight.csv"] : word),
            "--renderer", "native", "--ephemeris", "builtin", "--ldem", TestParts.Ldem4Label!, "--output-dir", _folder.Path,
            "--output-name", name,
        ]);

    private static Vector3D Position(XElement root)
    {
        XElement vector = root.Descendants("CameraPosition").Single().Element("Vector3D")!;
        return new Vector3D(Number(vector, "x"), Number(vector, "y"), Number(vector, "z"));
    }

    private static double Number(XElement element, string attribute) =>
        double.Parse(element.Attribute(attribute)!.Value, CultureInfo.InvariantCulture);
}
