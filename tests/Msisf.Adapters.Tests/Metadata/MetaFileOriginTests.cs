using Msisf.Adapters.Metadata;
using Msisf.Core.Metadata;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Metadata;

public sealed class MetaFileOriginTests : IDisposable
{
    private const string Head = """
        <?xml version="1.0" encoding="UTF-8" standalone="no" ?>
        <!DOCTYPE MSISRendering SYSTEM "../lib/MSISRendering.dtd">
        <MSISRendering>
          <GeneralInformation>
            <FOV unit="deg">40</FOV>
        """;

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Read_Inputs_AreThoseOfTheElements()
    {
        string path = _folder.Write("m.xml", Head + """
            <Input kind="elevation-image" name="a &quot;b&quot; &amp; c.IMG" bytes="34000000000" sha256="0123" />
            <Input kind="kernel" name="de421.bsp" bytes="16788480" sha256="4567" />
            <Input kind="elevation-image" name="LDEM_512.IMG" bytes="34000000000" sha256OfPieces="89ab" />
            <Input kind="of-the-future" name="x" bytes="1" sha256="89" />
          </GeneralInformation>
          <PixelInformation>
            <Pixel h=  what follows is not read
        """);

        Assert.Equal(
            [
                new InputFile(InputKind.ElevationImage, "a \"b\" & c.IMG", 34_000_000_000, "0123"),
                new InputFile(InputKind.Kernel, "de421.bsp", 16788480, "4567"),
                new InputFile(InputKind.ElevationImage, "LDEM_512.IMG", 34_000_000_000, "89ab") { IsOfPieces = true },
            ],
            MetaFileOrigin.Inputs(path));
    }

    [Theory]
    [InlineData(Head + "</GeneralInformation><PixelInformation></PixelInformation></MSISRendering>")]
    [InlineData(Head + "<Input kind=\"kernel\" name=\"x\" bytes=\"many\" sha256=\"0\" /></GeneralInformation></MSISRendering>")]
    [InlineData("not XML")]
    [InlineData("")]
    public void Read_FileWithoutThem_GivesNone(string content) => Assert.Empty(MetaFileOrigin.Inputs(_folder.Write("m.xml", content)));

    [Fact]
    public void Read_NoFile_GivesNone() => Assert.Empty(MetaFileOrigin.Inputs(_folder["m.xml"]));
}
