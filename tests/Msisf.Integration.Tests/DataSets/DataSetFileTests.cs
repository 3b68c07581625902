using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.DataSets;

/// <summary>Files of data sets that can't be made: one line that says what and where, and nothing is left.</summary>
public sealed class DataSetFileTests : IDisposable
{
    private const string Good =
        "count: 2\nstates: {altitude: 3e5, sun-elevation: 30}\noptions: {width: 16, height: 16, albedo-map: none}\n";

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData("count: 2\n", "a.yaml, line 1, column 1: a data set needs 'states': how the cameras' states are distributed.")]
    [InlineData("states: {altitude: 3e5, time: 60000}\n", "a data set needs 'count': how many images, or pairs, it has.")]
    [InlineData("count: 2\nstates: {sun-elevation: 3}\n", "line 2, column 1: the states needs 'altitude'")]
    [InlineData("count: 2\nstates: {altitude: 3e5}\n", "needs 'sun-elevation': degrees over the horizon")]
    [InlineData("count: 2\nstates: {altitude: 3e5, time: 60000, sun-azimuth: 3}\n", "'sun-azimuth' is of no use without 'sun-elevation'")]
    [InlineData("count: 2\nstates: {altitude: -3, sun-elevation: 3}\n", "'altitude': -3 goes beyond what is possible: 1 to 1000000000 m.")]
    [InlineData(
        "count: 2\nstates: {altitude: uniform 3, sun-elevation: 3}\n",
        "line 2, column 10: 'altitude': 'uniform 3' is not a distribution; a number, [MIN, MAX], ")]
    [InlineData("count: 2\nstates: {altitud: 3}\n", "'altitud' is not a key of the states; did you mean 'altitude'?", "altitud")]
    [InlineData("count: 2.5\nstates: {altitude: 3e5, sun-elevation: 3}\n", "'count' is 2.5; a whole number from 1 to")]
    [InlineData(Good + "seed: -1\n", "'seed' is \"-1\"; a whole number from 0 on is needed.", "seed")]
    [InlineData(Good + "sampling: halton\n", "'sampling' is \"halton\"; one of kronecker, random is needed", "sampling")]
    [InlineData(Good + "index: [csv, voc]\n", "is not a format; some of csv, coco, tum, kitti are needed.")]
    [InlineData(Good + "index: coco\n", "the index 'coco' holds craters, and no option names a catalogue. Add one below 'options', e.g. ")]
    [InlineData(Good + "accept: {lit: 1.5}\n", "'lit' is 1.5; a part from 0 to 1 is needed.")]
    [InlineData(Good + "accept: {sun-elevation: [9, 3]}\n", "the first limit is not below the second. Swap them.")]
    [InlineData(Good + "accept: {sun-elevation: [50, 90]}\n", "the last 2000 states met not all conditions ('sun-elevation' 2000 of 2000")]
    [InlineData(Good + "split: {train: 0.7, test: 0.2}\n", "the shares of the splits add up to 0.9", "add up to")]
    [InlineData(Good + "split: {train: 0.7, test: [0, 1, 0, 1]}\n", "of the splits some have a share, some a region.")]
    [InlineData(Good + "split: {a: [0, 9, 0, 9], b: [9, 19, 0, 9]}\n", "the regions of 'a' and 'b' touch. Leave a gap between them.")]
    [InlineData(Good + "split: {train: 0.9, test: 0.1, gap: 70, width: 60}\n", "the gap between them is 70. Make that smaller")]
    [InlineData(Good + "split: {../up: 1}\n", "is not a name of a split")]
    [InlineData(Good + "split: 3\n", "'split' is a section: put its keys below it")]
    public void Read_WrongFile_SaysWhatAndWhere(string text, string message, string? part = null) => Check(text, part ?? message);

    [Theory]
    [InlineData("{fov: 500}", "--fov is 500; its range is")]
    [InlineData("{fixed-state: x}", "'fixed-state' can't be in a configuration file: it says where the camera is, or when.")]
    [InlineData("{renderer: povray}", "a data set is drawn by the native renderer.")]
    [InlineData("{craters: none.csv}", "none.csv: there is no such file.")]
    [InlineData("{craters: c.csv}", "the licence of c.csv, which the data set is made from, is not known. Say it below 'licences'")]
    [InlineData("{pieces: 3}", "belongs to one call")]
    [InlineData("{listen: '127.0.0.1:0'}", "'listen' is an option of another command. Leave it out.")]
    [InlineData("{ignore-sun: true}", "'sun-elevation' has no meaning with --ignore-sun. Leave one out.")]
    [InlineData("3", "'options' is a section: put the options below it")]
    public void Read_WrongOptions_SaysWhatAndWhere(string options, string message)
    {
        _folder.Write("c.csv", "lat,lon,diam_km\n0,0,5\n");
        Check($"count: 2\nstates: {{altitude: 3e5, sun-elevation: 30}}\noptions: {options}\n", message);
    }

    [Fact]
    public void Read_NoFile_SaysSo() => Assert.Contains(
        "none.yaml: there is no such file. The YAML file of a data set is needed",
        CommandLineRun.Of(["dataset", _folder["none.yaml"]]).Error,
        StringComparison.Ordinal);

    /// <summary>What the message says to add is taken.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Read_CocoWithoutCraters_IsMadeWithWhatTheMessageSays()
    {
        _folder.Write("craters.csv", "lat,lon,diam_km\n0,0,50\n");
        _folder.Write("a.yaml", Good.Replace("options: {", "options: {craters: craters.csv, ", StringComparison.Ordinal)
            + "licences: {craters.csv: public domain}\nindex: coco\n");
        CommandLineRun run = CommandLineRun.Of(["dataset", _folder["a.yaml"], "--output-dir", _folder["out"], "--batch"]);

        Assert.True(run.ExitCode == 0, run.Error);
        Assert.Equal(2, CocoRules.Check(_folder["out/all.coco.json"]).Images);
    }

    private void Check(string text, string message)
    {
        _folder.Write("a.yaml", text);
        CommandLineRun run = CommandLineRun.Of(["dataset", _folder["a.yaml"], "--output-dir", _folder["out"], "--batch"]);

        Assert.InRange(run.ExitCode, 1, 2);
        Assert.Contains(message, run.Error, StringComparison.Ordinal);
        Assert.DoesNotContain("   at ", run.Error, StringComparison.Ordinal);
        Assert.False(Directory.Exists(_folder["out"]));
    }
}
