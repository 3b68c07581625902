using Msisf.App.Series;
using Msisf.App.Tests.Host;
using Msisf.Core.Metadata;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.App.Tests.Series;

/// <summary>Whether a frame that is there was made from the files of this run.</summary>
public sealed class InputComparisonTests : IDisposable
{
    private static readonly string Now = new('a', 64);

    private static readonly string Before = new('b', 64);

    private static readonly InputFile[] Run = [new(InputKind.Kernel, "de.bsp", 10, Now), new(InputKind.AlbedoMap, "map.lbl", 20, Now)];

    private readonly TemporaryFolder _folder = new();
    private readonly ListLog _log = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Compare_SameFiles_SaysNothing()
    {
        Compare($"{Kernel(Now)}{Map}");

        Assert.Empty(_log.Lines);
    }

    [Fact]
    public void Compare_OtherChecksum_NamesFileAndBothChecksums()
    {
        Compare($"{Kernel(Before)}{Map}");

        Assert.Equal(
            ["warning: a.xml was made from other input files: another de.bsp (SHA-256 bbbbbbbbbbbb..., now aaaaaaaaaaaa...)."], _log.Lines);
    }

    [Fact]
    public void Compare_FileMoreAndFileLess_NamesBothOnceForAllFrames()
    {
        InputComparison comparison = new(_log);
        foreach (string name in new[] { "a.xml", "b.xml" })
        {
            comparison.Compare(Meta(name, $"{Kernel(Now)}<Input kind=\"camera\" name=\"nav.yaml\" bytes=\"1\" sha256=\"{Now}\"/>"), Run);
        }

        Assert.Equal(
            ["warning: a.xml was made from other input files: nav.yaml, which this run does not use; without map.lbl."], _log.Lines);
    }

    [Theory]
    [InlineData("")] // before version 3
    [InlineData("<Input kind=\"kernel\"")] // cut off
    public void Compare_MetaFileWithoutInputs_SaysNothing(string inputs)
    {
        Compare(inputs);
        new InputComparison(_log).Compare(_folder["missing.xml"], Run);

        Assert.Empty(_log.Lines);
    }

    private static string Kernel(string hash) => $"<Input kind=\"kernel\" name=\"de.bsp\" bytes=\"10\" sha256=\"{hash}\"/>";

    private static string Map => $"<Input kind=\"albedo-map\" name=\"map.lbl\" bytes=\"20\" sha256=\"{Now}\"/>";

    private void Compare(string inputs) => new InputComparison(_log).Compare(Meta("a.xml", inputs), Run);

    private string Meta(string name, string inputs) => _folder.Write(
        name, $"<MSISRendering><GeneralInformation>{inputs}</GeneralInformation><PixelInformation/></MSISRendering>");
}
