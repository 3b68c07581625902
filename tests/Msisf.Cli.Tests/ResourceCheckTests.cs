using System.CommandLine;
using Msisf.Cli.Options;
using Msisf.Cli.Run;
using Msisf.Core.Errors;
using Xunit;

namespace Msisf.Cli.Tests;

public sealed class ResourceCheckTests
{
    private const long Gibibyte = 1L << 30;

    [Theory]
    [InlineData("--width 16384 --height 16384", 1, Gibibyte, 8 * Gibibyte)]
    [InlineData("--width 1024 --height 1024 --rendering-annotation", 2, Gibibyte, Gibibyte)]
    [InlineData("--width 16384 --height 16384 --grid 1", 1, Gibibyte, 72 * Gibibyte)]
    public void Check_Enough_Passes(string options, int atOnce, long memory, long disk) =>
        ResourceCheck.Check(Settings(options), atOnce, memory, disk);

    [Theory]
    [InlineData("--width 16384 --height 16384 --rendering-annotation", 1, Gibibyte, 100 * Gibibyte, "of memory")]
    [InlineData("--width 16384 --height 16384", 20, 2 * Gibibyte, 1000 * Gibibyte, "of memory")]
    [InlineData("--width 16384 --height 16384", 1, Gibibyte, 6 * Gibibyte, "of free disk space in output")]
    [InlineData("--width 16384 --height 16384 --grid 1", 1, Gibibyte, 60 * Gibibyte, "a wider --grid")]
    [InlineData("--width 16384 --height 16384 --grid 1 --surface terrain", 1, Gibibyte, 250 * Gibibyte, "a wider --grid")]
    public void Check_TooLittle_IsRefusedWithWhatIsThere(string options, int atOnce, long memory, long disk, string message)
    {
        BadInputException exception = Assert.Throws<BadInputException>(() => ResourceCheck.Check(Settings(options), atOnce, memory, disk));

        Assert.Contains(message, exception.Message, StringComparison.Ordinal);
    }

    private static RenderSettings Settings(string options)
    {
        PictureOptions picture = new();
        SourceOptions source = new();
        RunOptions run = new();
        NativeOptions native = new();
        RootCommand command = [.. picture.All, .. source.All, .. run.All, .. native.All];
        return new RenderSettingsReader(command.Parse(options)).Read(picture, source, run, native);
    }
}
