using System.Runtime.InteropServices;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests;

/// <summary>--certify as a user has it.</summary>
public sealed class CertifyRunTests(SmallMoon moon) : IClassFixture<SmallMoon>, IDisposable
{
    private const string View = "--renderer native --position=12,5,terrain+60000 --time 2000-01-01T00:00:00Z --ephemeris builtin "
        + "--sun-position {8E9,1.5E11,0} --width 16 --height 16 --fov 40 --batch --albedo-map none --layers-format npy";

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Run_Limits_WritesBoundsOfTheImage()
    {
        moon.Draw(
            _folder["a"],
            [.. View.Split(' '), "--layers", "radiance-factor", "--certify", "height=1,step=0.5,position=10,turn=0.001,sun=0.01"]);

        double[] factors = Doubles("radiance-factor");
        double[] low = Doubles("certain.certain-low");
        double[] high = Doubles("certain.certain-high");
        Assert.Equal(256, low.Length);
        Assert.Contains(factors, factor => factor > 0.0);
        Assert.All(factors.Select((factor, i) => (factor, i)), pixel =>
        {
            double factor = double.IsNaN(pixel.factor) ? 0.0 : pixel.factor;
            Assert.InRange(factor, low[pixel.i], high[pixel.i]);
        });
        Assert.Contains(low.Zip(high, (least, greatest) => greatest - least), width => width > 0.0);
    }

    [Theory]
    [InlineData("--shading smooth", "Give --shading facet")]
    [InlineData("--reflectance akimov", "--reflectance")]
    [InlineData("--samples auto", "Give --samples a number")]
    public void Run_WhatIsNotKnown_IsRefused(string option, string advice)
    {
        CommandLineRun run = CommandLineRun.Of(
            [.. View.Split(' '), .. option.Split(' '), "--certify", "height=1", "--output-dir", _folder["b"], .. moon.Options]);

        Assert.Equal(2, run.ExitCode);
        Assert.Contains(advice, run.Error, StringComparison.Ordinal);
    }

    private double[] Doubles(string layer) => MemoryMarshal.Cast<byte, double>(
        File.ReadAllBytes(Directory.GetFiles(_folder["a"], $"*.{layer}.npy").Single()).AsSpan()[^(256 * sizeof(double))..]).ToArray();
}
