using System.Globalization;
using System.Runtime.Versioning;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests.Pieces;

/// <summary><c>--epoch</c> with batch files: it is used where it has a meaning, and refused everywhere else.</summary>
[SupportedOSPlatform("linux")]
public sealed class BatchEpochTests : IDisposable
{
    private const string WithTimes = "mjd,x,y,z,qx,qy,qz,q0\n55289,1900000,0,0,0,0,0,1\n55290,1900000,0,0,0,0,0,1\n";
    private const string WithoutNames = "55289 1900000 0 0 0 0 0 1\n55290 1900000 0 0 0 0 0 1\n";
    private const string WithSeconds = "seconds,x,y,z,qx,qy,qz,q0\n0,1900000,0,0,0,0,0,1\n86400,1900000,0,0,0,0,0,1\n";

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>
    /// From axes that are held still the camera goes west over the Moon, which turns by 13.176358 degrees a day on average (IAU) and by
    /// some tenths more or less about its pole in a month; in the Moon's own axes it stays.
    /// </summary>
    [RequiresTheory(Part.Ldem4)]
    [InlineData(WithSeconds, "--epoch 55289", 55289.0, 0.0)]
    [InlineData(WithSeconds, "--epoch 55200.25 --normalize", 55200.25, 0.0)]
    [InlineData(WithSeconds, "--epoch 55289 --batch-frame moon-me-epoch", 55289.0, 13.176358)]
    [InlineData(WithTimes, "--epoch 55289 --batch-frame moon-me-epoch --normalize", 55289.0, 13.176358)]
    [InlineData(WithoutNames, "--epoch 55289 --batch-frame moon-me-epoch", 55289.0, 13.176358)]
    public void Epoch_ThatHasAMeaning_IsUsed(string batch, string options, double first, double degreesADay)
    {
        CommandLineRun run = CommandLineRun.Of(
            ["batchconvert", "--format", "sh", "--script", _folder["b.sh"], "--pieces", "1", .. Options(batch, options), "--fov", "40"]);

        Assert.True(run.ExitCode == 0, run.Error);
        string states = File.Exists(_folder["b.sh.states.tab"]) ? _folder["b.sh.states.tab"] : _folder["b.csv"];
        double[][] rows =
        [
            .. File.ReadLines(states).Where(line => line[0] != '#')
                .Select(line => line.Split(' ').Select(number => double.Parse(number, CultureInfo.InvariantCulture)).ToArray()),
        ];
        Assert.Equal([first, first + 1.0], rows.Select(row => row[0]));
        Assert.Equal([1_900_000.0, 0.0, 0.0], rows[0][1..4], (given, read) => Math.Abs(given - read) < 1e-3);
        double west = double.RadiansToDegrees(-Math.Atan2(rows[1][2], rows[1][1]));
        Assert.Equal(degreesADay, west, 0.1);
    }

    [RequiresTheory(Part.Ldem4)]
    [InlineData(WithTimes, "--epoch 55289", "the epoch has no meaning")]
    [InlineData(WithTimes, "--epoch 55289 --batch-frame j2000 --normalize", "the epoch has no meaning")]
    [InlineData(WithoutNames, "--epoch 55289", "the epoch has no meaning")]
    [InlineData(WithSeconds, "", "column seconds needs the epoch from which they count: --epoch, or ")]
    [InlineData(WithTimes, "--batch-frame moon-me-epoch", "frame moon-me-epoch needs the epoch whose axes are held still: --epoch, or ")]
    [InlineData("# msis: epoch=55289\n" + WithSeconds, "--epoch 55289", "'epoch' is said twice: here, and before or by --epoch.")]
    public void Epoch_WithoutMeaningOrMissing_IsRefusedByEveryCommand(string batch, string options, string message)
    {
        string[][] commands = [["--dry-run"], ["batchconvert", "--format", "sh", "--script", _folder["b.sh"], "--pieces", "1"]];
        foreach (string[] command in commands)
        {
            CommandLineRun run = CommandLineRun.Of([.. command, .. Options(batch, options)]);

            Assert.Equal(2, run.ExitCode);
            Assert.Contains(message, run.Error, StringComparison.Ordinal);
        }

        Assert.False(File.Exists(_folder["b.sh"]));
    }

    private string[] Options(string batch, string options) =>
    [
        "--batch-file", _folder.Write("b.csv", batch), .. options.Split(' ', StringSplitOptions.RemoveEmptyEntries),
        .. ConvertedScript.Common,
    ];
}
