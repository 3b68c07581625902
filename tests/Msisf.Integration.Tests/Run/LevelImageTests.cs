using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Run;

/// <summary>Images of POV-Ray from blocks at levels of detail, beside those from whole tiles.</summary>
public sealed class LevelImageTests : IDisposable
{
    /// <summary>Half of the Moon, 64 px a radius; the terminator runs through it.</summary>
    private static readonly string[] Disc = [.. From("{8.66e6,5e6,0,0,0,100}"), "--fov", "22", "--width", "160", "--height", "160"];

    /// <summary>Some blocks.</summary>
    private static readonly string[] Near = [.. From("{1.9e6,1e5,0,0,0,100}"), "--fov", "30", "--width", "32", "--height", "32"];

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>
    /// The disc has half a million triangles, so where there are two cores it is drawn in strips; coarser levels have far fewer.
    /// </summary>
    [RequiresFact(Part.Ldem4, Part.PovRay)]
    public void Render_BlocksOfTheModelItselfAndCoarserLevels_AreTheImageOfTilesAndStayNearIt()
    {
        Render(Disc, "whole", "--lod", "off");
        Render(Disc, "blocks", "--lod-error", "0");

        // POV-Ray's 32-bit floats round the same vertices from other origins.
        Assert.InRange(RootMeanSquare(PngPixels.Read(_folder["whole.png"]), PngPixels.Read(_folder["blocks.png"])), 0.0, 0.05);

        Render(Disc, "half", "--lod-error", "0.5");
        Render(Disc, "coarse", "--lod-error", "1");
        PngPixels whole = PngPixels.Read(_folder["whole.png"]);

        Assert.Contains("_levels_1_", File.ReadAllText(_folder["half.pov"]), StringComparison.Ordinal);
        Assert.Contains("_levels_2_", File.ReadAllText(_folder["coarse.pov"]), StringComparison.Ordinal);

        // Cells of 0.8 and 1.5 px beside those of 0.4; measured 3.3 and 4.1 grey levels.
        double half = RootMeanSquare(whole, PngPixels.Read(_folder["half.png"]));
        double coarse = RootMeanSquare(whole, PngPixels.Read(_folder["coarse.png"]));
        Assert.InRange(half, 0.1, 5.0);
        Assert.InRange(coarse, half, 6.0);
    }

    [RequiresFact(Part.Ldem4, Part.PovRay)]
    public void Render_Again_MakesNoBlockAnew()
    {
        string[] empty = ["--pattern-repos", _folder["patterns"]];
        CommandLineRun first = Render(Near, "first", ["--timing", .. empty]);
        CommandLineRun again = Render(Near, "again", ["--timing", .. empty]);

        Assert.DoesNotContain("\"patterns_made\":0,", first.Error, StringComparison.Ordinal);
        Assert.Contains("\"patterns_made\":0,", again.Error, StringComparison.Ordinal);
        Assert.Equal(File.ReadAllBytes(_folder["first.png"]), File.ReadAllBytes(_folder["again.png"]));
    }

    private static double RootMeanSquare(PngPixels a, PngPixels b)
    {
        double sum = 0.0;
        for (int pixel = 0; pixel < a.Width * a.Height; pixel++)
        {
            double difference = a[pixel % a.Width, pixel / a.Width, 0] - b[pixel % a.Width, pixel / a.Width, 0];
            sum += difference * difference;
        }

        return Math.Sqrt(sum / (a.Width * a.Height));
    }

    private static string[] From(string state) => ["--state-vectors", state, "--epoch", "55289", "--time", "55289"];

    private CommandLineRun Render(string[] view, string name, params string[] more)
    {
        string[] common = RealMoon.Arguments(_folder.Path);
        string[] rest = more.Contains("--pattern-repos") ? [.. common.Where((_, index) => index is not (2 or 3))] : common;
        CommandLineRun run = CommandLineRun.Of([.. view, "--output-name", name, .. more, .. rest]);
        Assert.True(run.ExitCode == 0, run.Error);
        return run;
    }
}
