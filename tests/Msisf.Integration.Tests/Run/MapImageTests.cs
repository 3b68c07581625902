using System.Globalization;
using Msisf.TestSupport;
using Xunit;
using Xunit.Abstractions;

namespace Msisf.Integration.Tests.Run;

/// <summary>
/// Maps of a part of the Moon, and several models in one scene: POV-Ray's images from blocks of the surface beside the native renderer's of
/// the same facets, without antialiasing (<see cref="NativeImageTests"/> says what may differ).
/// </summary>
public sealed class MapImageTests(ITestOutputHelper output, MapImageTests.Maps maps) : IClassFixture<MapImageTests.Maps>, IDisposable
{
    private const int Side = 256;

    /// <summary>1: part of the pixels that may lie at the other side of an edge.</summary>
    private const double EdgePixels = 0.001;

    /// <summary>Pixels through which POV-Ray's rays slip between two triangles; 4 of 384 x 384 are the most seen.</summary>
    private const int PovRayLeaks = 8;

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>From the side a ray gets below a map, whose facets are met from outside only.</summary>
    [RequiresTheory(Part.Ldem4, Part.PovRay)]
    [InlineData("map alone, over the pole", "COARSE", "-89,30,150000", "-89.5,40", 60)]
    [InlineData("map alone, from the side and below", "COARSE", "-50,250,1500000", "-88,20", 25)]
    [InlineData("nested maps, low Sun", "MOON COARSE FINE", "-86,0,60000", "-89.2,0", 60)]
    [InlineData("a seam at a corner", "MOON COARSE", "-82,225,60000", "-82.2,225", 70)]
    public void Image_OfBlocks_IsTheNativeRenderers(string name, string models, string position, string target, int fieldOfView)
    {
        string[] arguments =
        [
            .. models.Split(' ').SelectMany(model => (string[])["--ldem", model switch
            {
                "MOON" => TestParts.Ldem4Label!,
                "COARSE" => maps.Coarse,
                _ => maps.Fine,
            }]),
            $"--position={position}", $"--look-at={target}", "--time", "2026-01-10T00:00:00Z",
            "--fov", fieldOfView.ToString(CultureInfo.InvariantCulture), "--width", $"{Side}", "--height", $"{Side}",
            "--output-dir", _folder["out"], "--ephemeris", "builtin", "--batch",
        ];
        CommandLineRun povRay = CommandLineRun.Of(
            [.. arguments, "--output-name", "povray", "--pov-options", "Antialias=Off", "--pattern-repos", maps.Repository]);
        Assert.True(povRay.ExitCode == 0, povRay.Error);
        CommandLineRun native = CommandLineRun.Of(
            [.. arguments, "--output-name", "native", "--renderer", "native", "--reflectance", "lambert", "--lod", "off"]);
        Assert.True(native.ExitCode == 0, native.Error);

        ImageDifference difference = new(
            PngPixels.Read(Path.Combine(_folder["out"], "povray.png")), PngPixels.Read(Path.Combine(_folder["out"], "native.png")), 1);

        output.WriteLine($"{name}: {difference}");
        Assert.True(difference.OffEdge.Count == 0, $"{name}: {difference}");
        Assert.True(difference.BlackDiffers + difference.GreyDiffers <= EdgePixels * Side * Side, $"{name}: {difference}");
        Assert.True(difference.Leaks <= PovRayLeaks, $"{name}: {difference}");
        Assert.InRange(difference.Black, Side * Side / 100, 99 * Side * Side / 100);
        string meta = File.ReadAllText(Path.Combine(_folder["out"], "povray.xml"));
        Assert.Equal(
            models.Contains(' ', StringComparison.Ordinal), meta.Contains("<ElevationPart part=\"1\"", StringComparison.Ordinal));
    }

    /// <summary>Two maps with detail that is made up, in the real model, made once for all tests.</summary>
    public sealed class Maps : IDisposable
    {
        private readonly TemporaryFolder _folder = new();
        private readonly Lazy<string> _coarse;
        private readonly Lazy<string> _fine;

        public Maps()
        {
            _coarse = new Lazy<string>(() => Make("2000", "84"));
            _fine = new Lazy<string>(() => Make("250", "88.5"));
        }

        /// <summary>Label of a map of 2 km from 84 degrees of latitude on.</summary>
        public string Coarse => _coarse.Value;

        /// <summary>Label of a map of 250 m from 88.5 degrees on.</summary>
        public string Fine => _fine.Value;

        /// <summary>Patterns of all scenes.</summary>
        public string Repository => _folder["patterns"];

        public void Dispose() => _folder.Dispose();

        private string Make(string scale, string latitude)
        {
            CommandLineRun made = CommandLineRun.Of(
                ["ldem", "synthesize", "--projection", "polar-south", "--map-scale", scale, "--latitude", latitude, "--base",
                    TestParts.Ldem4Label!, "--seed", "1", "--output-dir", _folder.Path, "--batch"]);
            Assert.True(made.ExitCode == 0, made.Error);
            return made.Output.Trim();
        }
    }
}
