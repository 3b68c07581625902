using Msisf.Adapters.IO;
using Msisf.Adapters.Manifest;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Manifest;

public sealed class FrameCheckerTests : IDisposable
{
    private static readonly ExpectedRecord Expected = new("r1", 1, "m", "f1");

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Check_AllFilesAsWritten_IsComplete() => Assert.Equal(FrameState.Complete, Check(Made(), CheckDepth.Checksums).State);

    [Fact]
    public void Check_NothingMade_IsMissing() => Assert.Equal(FrameState.Missing, Check(null, CheckDepth.Lengths).State);

    [Fact]
    public void Check_NothingMadeButAFailure_SaysWhy()
    {
        FrameCheck check = new FrameChecker(_folder.Path, CheckDepth.Lengths).Check(
            Expected, null, new FailedRecord(1, "m", "f1", "killed"));

        Assert.Equal((FrameState.Failed, "killed"), (check.State, check.Reason));
    }

    [Fact]
    public void Check_FailureOfOtherSettings_IsMissing() => Assert.Equal(
        FrameState.Missing,
        new FrameChecker(_folder.Path, CheckDepth.Lengths).Check(Expected, null, new FailedRecord(1, "m", "f0", "killed")).State);

    [Fact]
    public void Check_OtherSettings_IsNoticed() =>
        Assert.Equal(FrameState.OtherSettings, Check(Made() with { Frame = "f0" }, CheckDepth.Checksums).State);

    [Fact]
    public void Check_AllFilesGone_IsMissing()
    {
        FrameRecord made = Made();
        Array.ForEach(Directory.GetFiles(_folder.Path), File.Delete);

        Assert.Equal(FrameState.Missing, Check(made, CheckDepth.Lengths).State);
    }

    [Fact]
    public void Check_OtherSettingsAndAllFilesGone_IsMissing()
    {
        FrameRecord made = Made() with { Frame = "f0" };
        Array.ForEach(Directory.GetFiles(_folder.Path), File.Delete);

        Assert.Equal(FrameState.Missing, Check(made, CheckDepth.Lengths).State);
    }

    [Fact]
    public void Check_LinkToTheFile_IsComplete()
    {
        FrameRecord made = Made();
        File.Move(_folder["m.pov"], _folder["elsewhere"]);
        File.CreateSymbolicLink(_folder["m.pov"], _folder["elsewhere"]);
        Assert.Equal(FrameState.Complete, Check(made, CheckDepth.Checksums).State);
        File.Delete(_folder["elsewhere"]);
        Assert.Equal(FrameState.Damaged, Check(made, CheckDepth.Lengths).State);
    }

    [Fact]
    public void Check_OneFileGone_IsDamagedByName()
    {
        FrameRecord made = Made();
        File.Delete(_folder["m.pov"]);
        FrameCheck check = Check(made, CheckDepth.Lengths);

        Assert.Equal((FrameState.Damaged, "m.pov: missing"), (check.State, check.Reason));
    }

    [Theory]
    [InlineData("scenf", CheckDepth.Lengths, FrameState.Complete)] // the quick look can't see it
    [InlineData("scenf", CheckDepth.Checksums, FrameState.Damaged)]
    [InlineData("scen", CheckDepth.Lengths, FrameState.Damaged)]
    [InlineData("", CheckDepth.Lengths, FrameState.Damaged)]
    public void Check_ChangedFile_IsDamaged(string content, CheckDepth depth, FrameState expected)
    {
        FrameRecord made = Made();
        File.WriteAllText(_folder["m.pov"], content);

        Assert.Equal(expected, Check(made, depth).State);
    }

    private FrameCheck Check(FrameRecord? made, CheckDepth depth) => new FrameChecker(_folder.Path, depth).Check(Expected, made, null);

    private FrameRecord Made()
    {
        string[] paths = [_folder.Write("m.txt", "image"), _folder.Write("m.pov", "scene")];
        return new FrameRecord(1, "m", "f1", "s1", [.. paths.Select(path => new OutputFile(
            Path.GetFileName(path), new FileInfo(path).Length, FileHash.Sha256Of(path)))]);
    }
}
