using System.Globalization;
using System.Text.Json;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests;

/// <summary>A polar map from its making to its image, as a user has it.</summary>
public sealed class PolarMapRunTests(PolarMapRunTests.Map map) : IClassFixture<PolarMapRunTests.Map>, IDisposable
{
    private const string State = "--fixed-state {51544.5,0,0,-1.9E6,0,0.7071067811865476,0,0.7071067811865476} --ignore-sun --batch";

    private const string View = State + " --width 40 --height 40 --fov 20";

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Run_SyntheticPolarMap_IsDrawn()
    {
        Assert.Equal("LDEM_80S_10000M_SYNTHETIC.LBL", Path.GetFileName(map.Label));

        CommandLineRun run = CommandLineRun.Of(
            [.. View.Split(' '), "--renderer", "native", "--ldem", map.Label, "--surface", "terrain", "--gridH", "13", "--gridV", "13",
                "--output-dir", _folder["out"], "--output-name", "pole"]);

        Assert.Equal((0, string.Empty), (run.ExitCode, run.ExitCode == 0 ? string.Empty : run.Error));
        string xml = File.ReadAllText(Path.Combine(_folder["out"], "pole.xml"));
        Assert.Contains("<SurfaceResolution unit=\"m/px\">10000</SurfaceResolution>", xml, StringComparison.Ordinal);
        Assert.Contains("drawnFinest=\"10000\" drawnCoarsest=\"10000\" unit=\"m/px\"", xml, StringComparison.Ordinal);
        Assert.Contains("      <Facet line=\"", xml, StringComparison.Ordinal);
        Assert.DoesNotContain("--res ", xml, StringComparison.Ordinal);
    }

    [Fact]
    public void Run_LayersOfAPolarMap_AreDescribedAsThoseOfAMap()
    {
        CommandLineRun run = CommandLineRun.Of(
            [.. View.Split(' '), "--renderer", "native", "--ldem", map.Label, "--layers", "tile,cell,height", "--layers-format", "npy",
                "--output-dir", _folder["out"], "--output-name", "pole"]);

        Assert.Equal((0, string.Empty), (run.ExitCode, run.ExitCode == 0 ? string.Empty : run.Error));
        using JsonDocument json = JsonDocument.Parse(File.ReadAllText(Path.Combine(_folder["out"], "pole.layers.json")));
        Assert.Equal(
            [
                "Height over the sphere of 1 737 400 m.",
                "Undefined: a polar map has no tiles.",
                "Cell of the polar map at the level of detail that was drawn: line (0 uppermost) and sample (0 leftmost) of its upper left "
                    + "vertex in the map's image.",
            ],
            json.RootElement.GetProperty("layers").EnumerateArray().Select(layer => layer.GetProperty("description").GetString()));
    }

    /// <summary>From 163 km pixels have 41 km, so cells may have 28 km with 0.35 px of error: 20 km is the map's next level.</summary>
    [Theory]
    [InlineData("", "20000")]
    [InlineData("--lod off", "10000")]
    [InlineData("--lod-error 0.1", "10000")]
    public void Run_FarView_IsDrawnWithTheLevelOfTheRule(string options, string drawn)
    {
        CommandLineRun run = CommandLineRun.Of(
            [.. State.Split(' '), "--renderer", "native", "--ldem", map.Label, "--fov", "90", "--width", "8", "--height", "8",
                .. options.Split(' ', StringSplitOptions.RemoveEmptyEntries), "--output-dir", _folder["out"], "--output-name", "far"]);

        Assert.Equal((0, string.Empty), (run.ExitCode, run.ExitCode == 0 ? string.Empty : run.Error));
        Assert.Contains(
            $"drawnFinest=\"{drawn}\" drawnCoarsest=\"{drawn}\" unit=\"m/px\"",
            File.ReadAllText(Path.Combine(_folder["out"], "far.xml")),
            StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("--renderer native --res 4", 1, "--res contradicts --ldem ")]
    [InlineData("--list-patterns", 1, "only one model of the whole Moon has tiles")]
    public void Run_WhatAMapCannot_IsRefused(string options, int exitCode, string message)
    {
        CommandLineRun run = CommandLineRun.Of(
            [.. View.Split(' '), .. options.Split(' ', StringSplitOptions.RemoveEmptyEntries), "--ldem", map.Label, "--output-dir",
                _folder["out"]]);
        Assert.Equal(exitCode, run.ExitCode);
        Assert.Contains(message, run.Error, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("patterns --ldem")]
    [InlineData("ldem synthesize --res 8 --seed 1 --base")]
    public void Run_CommandsOfWholeMoons_RefuseAMap(string command)
    {
        CommandLineRun run = CommandLineRun.Of([.. command.Split(' '), map.Label]);
        Assert.Equal(2, run.ExitCode);
        Assert.Contains("a SIMPLE CYLINDRICAL model of the whole Moon is needed here", run.Error, StringComparison.Ordinal);
    }

    /// <summary>The map, made once for all tests.</summary>
    public sealed class Map : IDisposable
    {
        private readonly TemporaryFolder _folder = new();

        public Map() => Label = SyntheticModels.MakePolar(_folder.Path, 10000);

        /// <summary>Path of its label.</summary>
        public string Label { get; }

        public void Dispose() => _folder.Dispose();
    }
}
