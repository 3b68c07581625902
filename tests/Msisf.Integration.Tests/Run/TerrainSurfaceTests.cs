using System.Globalization;
using System.Xml.Linq;
using Msisf.Adapters.Raster.Heights;
using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Surface;
using Msisf.Core.Tests.Support;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Run;

/// <summary><c>--surface terrain</c> as a user runs it, held against all facets of the real model (BruteForceMoon).</summary>
public sealed class TerrainSurfaceTests : IDisposable
{
    /// <summary>Degrees: computed again from numbers of 16 digits.</summary>
    private const double AngleTolerance = 1e-9;

    /// <summary>m: the point is rounded to some 1e-9 m, and so are corners and normal of the facet here.</summary>
    private const double PlaneTolerance = 1e-7;

    /// <summary>px.</summary>
    private const double PixelTolerance = 1e-6;

    private static readonly PinholeCamera Section92 = new(
        new Vector3D(2e6, 2e6, 0.0),
        UnitQuaternion.FromComponents(-2.391176183943345e-001, +9.904576054128762e-002, +3.696438106143861e-001, +8.923991008325228e-001),
        double.DegreesToRadians(40.0),
        1024,
        1024);

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [RequiresFact(Part.Ldem4, Part.PovRay)]
    public void Run_Section92_PutsEachPixelOnTheFacetThatItShows()
    {
        XElement root = Render(Section92, "--surface", "terrain", "--pov-options", "Antialias=Off");

        using LdemImage grid = LdemImage.Open(LdemLabelReader.ReadFile(TestParts.Ldem4Label!));
        BruteForceMoon moon = new(grid);
        Vector3D sun = VectorIn(root.Element("GeneralInformation")!, "SunPosition");
        PngPixels image = PngPixels.Read(_folder["view.png"]);
        XElement[] pixels = [.. root.Descendants("Pixel")];
        Assert.InRange(pixels.Length, 350, 370);
        Assert.All(pixels, pixel =>
        {
            AssertLiesOnTheRay(pixel);
            BruteForceMoon.FacetId facet = AssertLiesOnTheFacet(pixel, moon);
            AssertAngles(pixel, moon.Normal(facet), sun);

            bool isLit = StateOf(pixel) == "lit";
            Vector3D point = VectorIn(pixel, "Position");
            Assert.Equal(Vector3D.Dot(moon.Normal(facet), sun - point) > 0.0 && !moon.IsShadowed(facet, point, sun), isLit);
            Assert.Equal(image[H(pixel) - 1, V(pixel) - 1, 0] > 0, isLit);
            Assert.Equal(!isLit && Vector3D.Dot(point, sun - point) < 0.0, StateOf(pixel) == "night");
        });
        Assert.Equal(["lit", "night", "shadow"], pixels.Select(StateOf).Distinct().Order());
    }

    [RequiresFact(Part.Ldem4, Part.PovRay)]
    public void Run_IgnoreSun_LightsAllThatIsSeenAtPhaseZero()
    {
        XElement root = Render(Small(Section92), "--surface", "terrain", "--ignore-sun", "--grid", "8");

        XElement[] pixels = [.. root.Descendants("Pixel")];
        Assert.NotEmpty(pixels);
        Assert.All(pixels, pixel =>
        {
            Assert.Equal("lit", StateOf(pixel));
            Assert.Equal(0.0, Number(pixel.Element("PhaseAngle")!.Value));
            Assert.Equal(pixel.Element("EmissionAngle")!.Value, pixel.Element("IncidenceAngle")!.Value);
        });
    }

    [RequiresFact(Part.Ldem4, Part.PovRay)]
    public void Run_CameraBelowTheReferenceSphere_ListsTheTerrainThere()
    {
        // 1500 m over the lowest sample of LDEM_4, which lies 8878.5 m below the reference radius at (70.375 S, 187.625 E).
        Vector3D position = new(-575911.7063287933, -77098.80540201683, -1629526.2720132158);
        PinholeCamera camera = Small(new PinholeCamera(position, NadirPointing.MoonFromCamera(position), 0.7, 64, 64));

        Assert.Empty(Render(camera, "--grid", "8").Descendants("Pixel"));
        XElement[] pixels = [.. Render(camera, "--grid", "8", "--surface", "terrain").Descendants("Pixel")];

        Assert.Equal(64, pixels.Length);
        Assert.All(pixels, pixel => Assert.InRange(Number(pixel.Element("Height")!.Value), -8878.6, -8500.0));
    }

    [RequiresFact(Part.Ldem4, Part.PovRay)]
    public void Run_Sphere_WritesTheBytesOfTheDefault()
    {
        Render(Small(Section92), "--grid", "8");
        string[] byDefault = LinesBesideTheCall();

        Render(Small(Section92), "--grid", "8", "--surface", "sphere");

        Assert.Equal(byDefault, LinesBesideTheCall());
    }

    /// <summary>Reprojected, the point is the pixel's centre; coordinates, height and range are those of the point.</summary>
    private static void AssertLiesOnTheRay(XElement pixel)
    {
        Vector3D point = VectorIn(pixel, "Position");
        Vector3D fromCamera = point - Section92.PositionBodyFixed;
        Assert.True(Section92.TryProject(fromCamera, out RenderingPoint projected));
        Assert.InRange(projected.X - H(pixel), -PixelTolerance, PixelTolerance);
        Assert.InRange(projected.Y - V(pixel), -PixelTolerance, PixelTolerance);
        Assert.InRange(Number(pixel.Element("Range")!.Value) - Math.Sqrt(fromCamera.LengthSquared), -1e-8, 1e-8);
        Assert.InRange(Number(pixel.Element("Height")!.Value) - (Math.Sqrt(point.LengthSquared) - 1_737_400.0), -1e-8, 1e-8);
        XElement coordinates = pixel.Element("SelenographicCoordinates")!;
        double latitude = Number(coordinates.Attribute("lat")!.Value) * Math.PI / 180.0;
        double longitude = Number(coordinates.Attribute("lon")!.Value) * Math.PI / 180.0;
        Vector3D direction = new(Math.Cos(latitude) * Math.Cos(longitude), Math.Cos(latitude) * Math.Sin(longitude), Math.Sin(latitude));
        Assert.InRange(Vector3D.AngleBetween(direction, point) * 180.0 / Math.PI, 0.0, Rounding.OfChains);
    }

    /// <summary>The facet that the ray meets first, whose plane holds the point and whose normal is the element's.</summary>
    private static BruteForceMoon.FacetId AssertLiesOnTheFacet(XElement pixel, BruteForceMoon moon)
    {
        XElement named = pixel.Element("Facet")!;
        BruteForceMoon.FacetId facet = new(
            (int)named.Attribute("line")! + 1, (int)named.Attribute("sample")!, named.Attribute("half")!.Value == "SW" ? 0 : 1);
        Ray ray = Section92.RayThrough(H(pixel), V(pixel));
        Assert.Equal(moon.FirstHit(ray.Origin, ray.Direction)!.Value.Facet, facet);

        (Vector3D corner, _, _) = moon.Corners(facet.Row, facet.Column, facet.Half);
        Vector3D normal = moon.Normal(facet);
        Assert.InRange(Vector3D.Dot(normal, VectorIn(pixel, "Position") - corner), -PlaneTolerance, PlaneTolerance);
        Assert.InRange((VectorIn(pixel, "Normal") - normal).Length, 0.0, Rounding.OfUnits);

        int tile = moon.TileOf(facet);
        int south = 85 - (5 * (tile / 72));
        int west = 5 * (tile % 72);
        Assert.Equal($"lat_{south}_{south + 5}_lon_{west}_{west + 5}", named.Attribute("tile")!.Value);
        return facet;
    }

    private static void AssertAngles(XElement pixel, Vector3D normal, Vector3D sun)
    {
        Vector3D point = VectorIn(pixel, "Position");
        AssertAngle(sun - point, normal, "IncidenceAngle");
        AssertAngle(Section92.PositionBodyFixed - point, normal, "EmissionAngle");
        AssertAngle(sun - point, Section92.PositionBodyFixed - point, "PhaseAngle");

        // By the law of cosines: not the formula of the program.
        void AssertAngle(Vector3D u, Vector3D v, string name)
        {
            double expected = Math.Acos(Vector3D.Dot(u, v) / Math.Sqrt(u.LengthSquared * v.LengthSquared)) * 180.0 / Math.PI;
            Assert.InRange(Number(pixel.Element(name)!.Value) - expected, -AngleTolerance, AngleTolerance);
        }
    }

    private static PinholeCamera Small(PinholeCamera camera) =>
        new(camera.PositionBodyFixed, camera.MoonFromCamera, camera.FieldOfView, 64, 64);

    private static int H(XElement pixel) => (int)pixel.Attribute("h")!;

    private static int V(XElement pixel) => (int)pixel.Attribute("v")!;

    private static string StateOf(XElement pixel) => pixel.Element("Illumination")!.Attribute("state")!.Value;

    private static Vector3D VectorIn(XElement parent, string name)
    {
        XElement vector = parent.Element(name)!.Element("Vector3D")!;
        return new Vector3D(
            Number(vector.Attribute("x")!.Value), Number(vector.Attribute("y")!.Value), Number(vector.Attribute("z")!.Value));
    }

    private static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);

    private string[] LinesBesideTheCall() =>
        [.. File.ReadLines(_folder["view.xml"]).Where(line => !line.Contains("<CommandLine>", StringComparison.Ordinal))];

    private XElement Render(PinholeCamera camera, params string[] more)
    {
        (Vector3D position, UnitQuaternion q) = (camera.PositionBodyFixed, camera.MoonFromCamera);
        string state = string.Create(
            CultureInfo.InvariantCulture, $"{{55289,{position.X:R},{position.Y:R},{position.Z:R},{q.X:R},{q.Y:R},{q.Z:R},{q.W:R}}}");
        string side = camera.Width.ToString(CultureInfo.InvariantCulture);
        string fieldOfView = double.RadiansToDegrees(camera.FieldOfView).ToString("R", CultureInfo.InvariantCulture);
        CommandLineRun run = CommandLineRun.Of(
        [
            "--fixed-state", state, "--width", side, "--height", side, "--fov", fieldOfView, "--output-name", "view",
            .. more, .. RealMoon.Arguments(_folder.Path),
        ]);
        Assert.True(run.ExitCode == 0, run.Error);
        return XDocument.Load(_folder["view.xml"]).Root!;
    }
}
