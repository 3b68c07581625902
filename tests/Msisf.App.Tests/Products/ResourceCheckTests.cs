using Msisf.App.Preparation;
using Msisf.App.Products;
using Msisf.App.Settings;
using Msisf.App.Tests.Settings;
using Msisf.Core.Errors;
using Xunit;

namespace Msisf.App.Tests.Products;

public sealed class ResourceCheckTests
{
    private const long Gibibyte = 1L << 30;

    [Theory]
    [InlineData("--width 16384 --height 16384", 1, Gibibyte, 8 * Gibibyte)]
    [InlineData("--width 1024 --height 1024 --rendering-annotation", 2, Gibibyte, Gibibyte)]
    [InlineData("--width 16384 --height 16384 --grid 1", 1, Gibibyte, 72 * Gibibyte)]
    public void Check_Enough_Passes(string options, int atOnce, long memory, long disk) =>
        ResourceCheck.Check([(Settings(options), atOnce)], atOnce, memory, disk);

    [Theory]
    [InlineData("--width 16384 --height 16384 --rendering-annotation", 1, Gibibyte, 100 * Gibibyte, "of memory")]
    [InlineData("--width 16384 --height 16384", 20, 2 * Gibibyte, 1000 * Gibibyte, "of memory")]
    [InlineData("--width 16384 --height 16384", 1, Gibibyte, 6 * Gibibyte, "of free disk space in output")]
    [InlineData("--width 16384 --height 16384 --grid 1", 1, Gibibyte, 60 * Gibibyte, "a wider --grid")]
    [InlineData("--width 16384 --height 16384 --grid 1 --surface terrain", 1, Gibibyte, 250 * Gibibyte, "a wider --grid")]
    public void Check_TooLittle_IsRefusedWithWhatIsThere(string options, int atOnce, long memory, long disk, string message)
    {
        BadInputException exception = Assert.Throws<BadInputException>(
            () => ResourceCheck.Check([(Settings(options), atOnce)], atOnce, memory, disk));

        Assert.Contains(message, exception.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Check_SeriesThatWillNotFit_IsRefusedBeforeItBegins()
    {
        const string Small = "--renderer native --width 1000 --height 1000 --grid 1000"; // 0.3 MB a frame
        ResourceCheck.Check([(Settings(Small), 3000)], atOnce: 2, Gibibyte, Gibibyte);
        BadInputException exception = Assert.Throws<BadInputException>(
            () => ResourceCheck.Check([(Settings(Small), 4000)], atOnce: 2, Gibibyte, Gibibyte));

        Assert.Contains("4000 frames will take about 1145 MiB", exception.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void CheckExposures_MoreThanMemory_AreRefusedBeforeTheyAreMade()
    {
        RenderSettings settings = Settings("--renderer native --camera lroc-nac-l --lines 500000");
        ExposureRoom.Check(settings, 2 * Gibibyte);
        BadInputException exception = Assert.Throws<BadInputException>(() => ExposureRoom.Check(settings, Gibibyte));

        Assert.Contains("500000 exposures of a scan need 1049 MiB of memory, 1024 MiB", exception.Message, StringComparison.Ordinal);
    }

    /// <summary>A small camera leaves its room to a large one.</summary>
    [Fact]
    public void Check_CamerasOfARig_TakeTheirSum()
    {
        RenderSettings small = Settings("--renderer native --width 10 --height 10 --grid 1000");
        RenderSettings large = Settings("--renderer native --width 1000 --height 1000 --grid 1000");
        ResourceCheck.Check([(small, 3000), (large, 3000)], atOnce: 2, Gibibyte, Gibibyte);
        BadInputException exception = Assert.Throws<BadInputException>(
            () => ResourceCheck.Check([(large, 2000), (small, 1), (large, 2000)], atOnce: 2, Gibibyte, Gibibyte));

        Assert.Contains("4001 frames will take about 1145 MiB", exception.Message, StringComparison.Ordinal);
    }

    /// <summary>Of single and double precision: 16 and 8 + 4 x 8 bytes a pixel beside the image's 0.3.</summary>
    [Theory]
    [InlineData("--layers depth,normal --layers-precision single", "15545 MiB")]
    [InlineData("--layers depth,position,mask", "31757 MiB")]
    public void Check_SeriesWithLayers_CountsTheirBytes(string layers, string size)
    {
        BadInputException exception = Assert.Throws<BadInputException>(() => ResourceCheck.Check(
            [(Settings($"--renderer native --width 1000 --height 1000 --grid 1000 {layers}"), 1000)], atOnce: 1, Gibibyte, Gibibyte));

        Assert.Contains(size, exception.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("--width 1024 --height 1024", 8, 8)]
    [InlineData("--width 1024 --height 1024", 3, 3)]
    [InlineData("--width 2048 --height 2048 --renderer native", 8, 1)]
    [InlineData("--width 2048 --height 2048 --renderer native --jobs 4", 8, 4)]
    public void AtOnce_CoresAndMemory_AreNotExceeded(string options, int frames, int expected) =>
        Assert.Equal(expected, ResourceCheck.AtOnce(Settings(options), frames, cores: 8, Gibibyte));

    [Theory]
    [InlineData("", 2, 4)]
    [InlineData("", 1, 2)]
    [InlineData("", 3, 3)] // six processes of 276 MiB are more than a gibibyte
    [InlineData("--jobs 2", 2, 2)]
    public void SmallScenesAtOnce_MemoryAndJobs_AreNotExceeded(string options, int atOnce, int expected) =>
        Assert.Equal(expected, ResourceCheck.SmallScenesAtOnce(Settings(options), atOnce, Gibibyte + (Gibibyte / 4)));

    private static RenderSettings Settings(string options) => RenderSettingsReader.Read(Given.Options(options));
}
