using System.Text;
using Msisf.Adapters.Manifest;
using Xunit;

namespace Msisf.Adapters.Tests.Manifest;

public sealed class ManifestLineTests
{
    public static TheoryData<ManifestRecord> Records =>
    [
        new SettingsRecord("ab12", """{"version":"1.0.0","kernels":[{"name":"n\u00e4if.tls"}]}"""),
        new RunRecord("r1", "ab12", 200),
        new ExpectedRecord("r1", 7, "Mond \u00e4 \"7\"", "f7"),
        new FailedRecord(8, "m_8", "f8", "POV-Ray ended with exit code 137:\n<killed>"),
    ];

    [Theory]
    [MemberData(nameof(Records))]
    public void TryRead_WrittenRecord_IsTheSame(ManifestRecord record)
    {
        byte[] line = ManifestLine.Write(record);

        Assert.Equal((byte)'\n', line[^1]);
        Assert.Equal(1, line.Count(character => character == (byte)'\n'));
        Assert.Equal(record, ManifestLine.TryRead(line.AsMemory()[..^1]));
    }

    [Fact]
    public void TryRead_WrittenFrame_IsTheSame()
    {
        FrameRecord frame = new(
            3,
            "m_3",
            "f3",
            "ab12",
            [new OutputFile("m_3.png", 5_000_000_000, new string('a', 64)), new OutputFile("m_3.xml", 0, new string('0', 64))]);
        FrameRecord read = Assert.IsType<FrameRecord>(ManifestLine.TryRead(ManifestLine.Write(frame).AsMemory()[..^1]));

        Assert.Equal(frame.Files, read.Files);
        Assert.Equal(frame, read with { Files = frame.Files });
    }

    [Theory]
    [InlineData("")]
    [InlineData("null")]
    [InlineData("[]")]
    [InlineData("{}")]
    [InlineData("""{"record":"other"}""")]
    [InlineData("""{"record":"run","run":"r1","settings":"s","frames":0}""")]
    [InlineData("""{"record":"run","run":"r1","settings":"s","frames":2.5}""")]
    [InlineData("""{"record":"run","run":null,"settings":"s","frames":1}""")]
    [InlineData("""{"record":"expected","run":"r1","step":1,"name":"../x","frame":"f"}""")]
    [InlineData("""{"record":"expected","run":"r1","step":1,"name":"..","frame":"f"}""")]
    [InlineData("""{"record":"frame","step":1,"name":"m","frame":"f","settings":"s","files":[]}""")]
    [InlineData("""{"record":"frame","step":1,"name":"m","frame":"f","settings":"s","files":[{"name":"m","bytes":1,"sha256":"short"}]}""")]
    [InlineData("""{"record":"settings","settings":"k","description":[]}""")]
    [InlineData("""{"record":"frame","step":1,"name":"m","fra""")]
    public void TryRead_NoLineOfAManifest_IsNull(string line) => Assert.Null(ManifestLine.TryRead(Encoding.UTF8.GetBytes(line)));
}
