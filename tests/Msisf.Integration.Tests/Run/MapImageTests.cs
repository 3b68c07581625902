using System.Globalization;
using System.Runtime.InteropServices;
using System.Text.RegularExpressions;
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

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>
    /// From the side a ray gets below a map, whose facets are met from outside only. The ridges around the site rise with it: there the Sun
    /// is 16 degrees high.
    /// </summary>
    [RequiresTheory(Part.Ldem4, Part.PovRay)]
    [InlineData("map alone, over the pole", "COARSE", "-89,30,150000", "-89.5,40", 60, "2000")]
    [InlineData("map alone, from the side and below", "COARSE", "-50,250,1500000", "-88,20", 25, "2000")]
    [InlineData("nested maps, low Sun", "MOON COARSE FINE", "-86,0,60000", "-89.2,0", 60, "4 2000 250")]
    [InlineData("a seam at a corner", "MOON COARSE", "-82,225,60000", "-82.2,225", 70, "4 2000")]
    [InlineData("a rough site of 1 m", "MOON COARSE SITE", "-89.9985,0,terrain+30", "-89.9999,0", 60, "4 2000 1")]
    [InlineData("map alone, at a level", "COARSE", "-89,30,1500000", "-89.5,40", 60, "4000", "auto")]
    [InlineData("nested maps at levels", "MOON COARSE FINE", "-82,0,900000", "-86,0", 90, "4 4000 no", "auto")]
    [InlineData("nested maps, one at a level", "MOON COARSE FINE", "-89,0,270000", "-89,0", 40, "4 2000 500", "auto")]
    public void Image_OfBlocks_IsTheNativeRenderers(
        string name, string models, string position, string target, int fieldOfView, string drawn, string lod = "off")
    {
        string[] arguments =
        [
            .. models.Split(' ').SelectMany(model => (string[])["--ldem", model switch
            {
                "MOON" => TestParts.Ldem4Label!,
                "COARSE" => maps.Coarse,
                "FINE" => maps.Fine,
                _ => maps.Site,
            }]),
            $"--position={position}", $"--look-at={target}", "--time", "2026-01-07T00:00:00Z", "--lod", lod,
            "--fov", fieldOfView.ToString(CultureInfo.InvariantCulture), "--width", $"{Side}", "--height", $"{Side}",
            "--output-dir", _folder["out"], "--ephemeris", "builtin", "--surface", "terrain", "--grid", "15",
            "--batch", .. models.EndsWith("SITE", StringComparison.Ordinal) ? (string[])["--sun-position", "{1.4E11,0,-4E10}"] : [],
        ];
        CommandLineRun povRay = CommandLineRun.Of(
            [.. arguments, "--output-name", "povray", "--pov-options", "Antialias=Off", "--pattern-repos", maps.Repository]);
        Assert.True(povRay.ExitCode == 0, povRay.Error);
        CommandLineRun native = CommandLineRun.Of(
            [.. arguments, "--output-name", "native", "--renderer", "native", "--reflectance", "lambert"]);
        Assert.True(native.ExitCode == 0, native.Error);

        ImageDifference difference = new(
            PngPixels.Read(Path.Combine(_folder["out"], "povray.png")), PngPixels.Read(Path.Combine(_folder["out"], "native.png")), 1);

        output.WriteLine($"{name}: {difference}");
        Assert.True(difference.OffEdge.Count == 0, $"{name}: {difference}");
        Assert.True(difference.BlackDiffers + difference.GreyDiffers <= EdgePixels * Side * Side, $"{name}: {difference}");
        Assert.True(difference.Leaks == 0, $"{name}: {difference}");
        Assert.InRange(difference.Black, Side * Side / 100, 99 * Side * Side / 100);
        string[] povRayMeta = File.ReadAllLines(Path.Combine(_folder["out"], "povray.xml"));
        string[] nativeMeta = File.ReadAllLines(Path.Combine(_folder["out"], "native.xml"));
        string[] tags = ["<Facet ", "<Elevation"];
        string[] expected = [.. nativeMeta.Where(line => tags.Any(line.Contains))];
        Assert.Contains(expected, line => line.Contains("<Facet ", StringComparison.Ordinal));
        Assert.Equal(expected, povRayMeta.Where(line => tags.Any(line.Contains)));
        string attribute = models.Contains(' ', StringComparison.Ordinal) ? " drawn" : " drawnFinest";
        Assert.Equal(
            drawn.Split(' '),
            povRayMeta.Where(line => line.Contains($"{attribute}=\"", StringComparison.Ordinal))
                .Select(line => line.Split($"{attribute}=\"")[1].Split('"')[0]));
    }

    /// <summary>Two maps with detail that is made up, in the real model, made once for all tests.</summary>
    public sealed class Maps : IDisposable
    {
        private readonly TemporaryFolder _folder = new();
        private readonly Lazy<string> _coarse;
        private readonly Lazy<string> _fine;
        private readonly Lazy<string> _site;

        public Maps()
        {
            _coarse = new Lazy<string>(() => Make("2000", "84"));
            _fine = new Lazy<string>(() => Make("250", "88.5"));
            _site = new Lazy<string>(MakeSite);
        }

        /// <summary>Label of a map of 2 km from 84 degrees of latitude on.</summary>
        public string Coarse => _coarse.Value;

        /// <summary>Label of a map of 250 m from 88.5 degrees on.</summary>
        public string Fine => _fine.Value;

        /// <summary>
        /// Label of a map of 1 m from 89.995 degrees on: waves of 0.2 m and bumps of some decimetres on a plateau in the sunlight, 4 km
        /// above the ground around it.
        /// </summary>
        public string Site => _site.Value;

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

        private string MakeSite()
        {
            string label = Make("1", "89.995");
            string image = Path.ChangeExtension(label, ".IMG");
            int side = (int)Math.Sqrt(new FileInfo(image).Length / sizeof(float));
            Random random = new(20120222);
            float[] kilometres = new float[side * side];
            for (int i = 0; i < kilometres.Length; i++)
            {
                (int line, int sample) = (i / side, i % side);
                double waves = 0.2 * (Math.Sin(sample / 7.0) + Math.Sin(line / 5.0));
                kilometres[i] = (float)(4.0 + ((waves + (0.5 * random.NextDouble())) / 1000.0));
            }

            File.WriteAllBytes(image, MemoryMarshal.AsBytes<float>(kilometres));
            string text = Regex.Replace(File.ReadAllText(label), @"(?m)^( *MINIMUM *=).*?(\r?)$", "$1 3.9$2");
            File.WriteAllText(label, Regex.Replace(text, @"(?m)^( *MAXIMUM *=).*?(\r?)$", "$1 4.1$2"));
            return label;
        }
    }
}
