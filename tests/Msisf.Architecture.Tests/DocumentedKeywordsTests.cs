using System.Globalization;
using System.Text.RegularExpressions;
using Msisf.Adapters.Camera;
using Msisf.Core.Camera.Lenses;
using Msisf.Core.Terrain;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Architecture.Tests;

/// <summary>What stands in the files is described on the pages.</summary>
public sealed partial class DocumentedKeywordsTests
{
    private const string Metric = "width: 64\nheight: 48\nfocal-length: 10\npixel-pitch: 0.1\n";

    [Fact]
    public void Fits_EachKeywordOfThePrimaryHeader_IsOnThePage()
    {
        string source = File.ReadAllText(Path.Combine(TestParts.RepositoryRoot, "src", "Msisf.Adapters", "Layers", "FitsProvenance.cs"));
        string[] keywords = [.. FitsKeyword().Matches(source).Select(match => match.Groups[1].Value).Distinct()];

        Assert.Contains("CAMDIST", keywords);
        Assert.Contains("CAMD", keywords);
        string page = Page("formats.md");
        Assert.All(keywords, keyword => Assert.Contains($"`{keyword.TrimEnd('X', 'Y', 'Z')}", page, StringComparison.Ordinal));
    }

    [Fact]
    public void Xml_EachElement_IsOnThePage()
    {
        string grammar = File.ReadAllText(Path.Combine(TestParts.RepositoryRoot, "lib", "MSISRendering.dtd"));
        string[] elements = [.. Element().Matches(grammar).Select(match => match.Groups[1].Value)];

        Assert.Contains("Distortion", elements);
        string page = Page("formats.md");
        Assert.All(elements, element => Assert.Matches($"[`<]{element}[` >/]", page));
    }

    /// <summary>A lens with one coefficient has it in the place that the page names.</summary>
    [Theory]
    [InlineData("opencv", "k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4", "model: opencv\n  {0}: 1e-3")]
    [InlineData("fisheye", "k1 k2 k3 k4", "model: fisheye\n  {0}: 1e-3")]
    [InlineData("owen", "e1 e2 e3 e4 e5 e6", "model: owen\n  {0}: 1e-5")]
    [InlineData("brown", "k0 k1 k2 k3 p1 p2 s1 s2 s3 s4 x0 y0", "model: brown\n  {0}: 1e-5")]
    public void Lens_EachCoefficient_IsWhereThePageSays(string name, string coefficients, string section)
    {
        string[] order = coefficients.Split();

        Assert.Contains($"| {string.Join(", ", order)} |", RowOf(name), StringComparison.Ordinal);
        for (int index = 0; index < order.Length; index++)
        {
            Distortion lens = Lens(string.Format(CultureInfo.InvariantCulture, section, order[index]));
            Assert.Equal(name, lens.Name);
            Assert.Equal(order.Length, lens.Coefficients.Count);
            Assert.Equal([index], Enumerable.Range(0, order.Length).Where(place => lens.Coefficients[place] != 0.0));
        }
    }

    [Theory]
    [InlineData("radial-factor", "k1, k2, k3", "model: radial\n  form: factor\n  k: [{0}, {1}, {2}]")]
    [InlineData("radial-division", "k1, k2, k3", "model: radial\n  form: division\n  k: [{0}, {1}, {2}]")]
    [InlineData(
        "polynomial-radius", "a0, a1, a2, a3, b0, b1, b2, b3",
        "model: polynomial\n  argument: radius\n  x: [{0}, {1}, {2}, {3}]\n  y: [{4}, {5}, {6}, {7}]")]
    [InlineData(
        "polynomial-x", "a0, a1, a2, a3, b0, b1, b2, b3",
        "model: polynomial\n  argument: x\n  x: [{0}, {1}, {2}, {3}]\n  y: [{4}, {5}, {6}, {7}]")]
    public void Lens_OfLists_HasTheirOrder(string name, string order, string section)
    {
        Assert.Contains($"| {order} |", RowOf(name), StringComparison.Ordinal);
        int count = order.Split(',').Length;
        for (int index = 0; index < count; index++)
        {
            object[] numbers = [.. Enumerable.Range(0, count).Select(place => place == index ? "1e-5" : "0")];
            Distortion lens = Lens(string.Format(CultureInfo.InvariantCulture, section, numbers));
            Assert.Equal(name, lens.Name);
            Assert.Equal(count, lens.Coefficients.Count);
            Assert.Equal([index], Enumerable.Range(0, count).Where(place => lens.Coefficients[place] != 0.0));
        }
    }

    [Fact]
    public void GravitationalParameter_IsOnThePage() => Assert.Contains(
        $"GM = {MoonConstants.GravitationalParameter.ToString("0.000000000e0", CultureInfo.InvariantCulture)} m3/s2",
        Page("camera-model.md"),
        StringComparison.Ordinal);

    private static Distortion Lens(string section) => CameraFileReader.Parse(
        System.Text.Encoding.UTF8.GetBytes($"{Metric}distortion:\n  {section}\n"), "camera.yaml").Model.Distortion!;

    private static string RowOf(string name) => Assert.Single(
        Page("cameras.md").Split('\n').SkipWhile(line => !line.Contains("`CAMDIST`", StringComparison.Ordinal)),
        line => line.StartsWith('|') && line.Split('|')[1].Contains($"`{name}`", StringComparison.Ordinal));

    private static string Page(string name) => File.ReadAllText(Path.Combine(TestParts.RepositoryRoot, "docs", name));

    [GeneratedRegex("""Put[A-Z]?[a-z]*\((?:unit, )?(?:Invariant\()?\$?"([A-Z][A-Z-]+)""")]
    private static partial Regex FitsKeyword();

    [GeneratedRegex("<!ELEMENT (\\w+)")]
    private static partial Regex Element();
}
