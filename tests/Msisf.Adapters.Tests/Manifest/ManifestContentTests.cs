using Msisf.Adapters.Manifest;
using Xunit;

namespace Msisf.Adapters.Tests.Manifest;

public sealed class ManifestContentTests
{
    private static readonly ManifestRecord[] Registration =
    [
        new SettingsRecord("s1", "{}"), new RunRecord("r1", "s1", 3),
        new ExpectedRecord("r1", 1, "m_1", "f1"), new ExpectedRecord("r1", 2, "m_2", "f2"), new ExpectedRecord("r1", 3, "m_3", "f3"),
    ];

    [Fact]
    public void InOrder_FramesMadeInAnyOrderAndTwice_AreTheSameLines()
    {
        ManifestContent one = Content([.. Registration, Frame(1, "a"), Frame(2, "b"), Frame(3, "c")]);
        ManifestContent other = Content(
            [.. Registration, Frame(3, "c"), new FailedRecord(
                1, "m_1", "f1", "killed"), .. Registration, Frame(2, "x"), Frame(1, "a"), Frame(2, "b"), Frame(3, "c")]);

        Assert.Equal(one.InOrder().SelectMany(ManifestLine.Write), other.InOrder().SelectMany(ManifestLine.Write));
        Assert.Equal(8, one.InOrder().Count());
    }

    [Fact]
    public void InOrder_RunWhoseNamesAnotherTook_IsLeftOut()
    {
        ManifestContent content = Content(
            [.. Registration, Frame(1, "a"), new SettingsRecord("s2", "{}"), new RunRecord("r2", "s2", 3), .. Enumerable.Range(1, 3).Select(
                step => new ExpectedRecord("r2", step, $"m_{step}", $"g{step}"))]);

        Assert.Equal(["r2"], content.InOrder().OfType<RunRecord>().Select(run => run.Run));
        // s1 is that of the frame that is there
        Assert.Equal(["s1", "s2"], content.InOrder().OfType<SettingsRecord>().Select(settings => settings.Key));
    }

    [Fact]
    public void Failed_FrameThatWasMadeLater_IsForgotten()
    {
        ManifestContent content = Content(
            [.. Registration, new FailedRecord(1, "m_1", "f1", "killed"), Frame(1, "a"), new FailedRecord(2, "m_2", "f2", "killed")]);

        Assert.Equal(["m_2"], content.Failed.Keys);
    }

    private static ManifestContent Content(IEnumerable<ManifestRecord> records)
    {
        ManifestContent content = new();
        foreach (ManifestRecord record in records)
        {
            content.Add(record);
        }

        return content;
    }

    private static FrameRecord Frame(int step, string hashDigit) =>
        new(step, $"m_{step}", $"f{step}", "s1", [new OutputFile($"m_{step}.png", 1, string.Concat(Enumerable.Repeat(hashDigit, 64)))]);
}
