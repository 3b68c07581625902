using System.Text;
using Msisf.Adapters.Render;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Render;

public sealed class PngFileTests : IDisposable
{
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("msisf-png-");

    public void Dispose() => _folder.Delete(recursive: true);

    [RequiresFact(Part.PovRay)]
    public void CopyImage_FromPovRay_KeepsTheImageAndDropsTheRenderDate()
    {
        string scene = Path.Combine(_folder.FullName, "grey.pov");
        string image = Path.Combine(_folder.FullName, "grey.png");
        File.WriteAllText(scene, "#version 3.7; global_settings { assumed_gamma 1.0 } background { rgb 0.5 }");
        ChildRun.Of(TestParts.Program("povray")!, [scene, "+O" + image, "+W8", "+H4", "-D"], _folder.FullName).Succeeded();
        byte[] original = File.ReadAllBytes(image);
        using MemoryStream copy = new();
        PngHeader header = PngFile.CopyImage(new MemoryStream(original), copy, image);

        Assert.Contains("tIME", Encoding.Latin1.GetString(original), StringComparison.Ordinal);
        Assert.DoesNotContain("tIME", Encoding.Latin1.GetString(copy.ToArray()), StringComparison.Ordinal);
        Assert.DoesNotContain("Render Date", Encoding.Latin1.GetString(copy.ToArray()), StringComparison.Ordinal);
        Assert.Equal((8, 4), (header.Width, header.Height));
        Assert.Equal(
            PngPixels.Read(new MemoryStream(original)).ChannelParts(0), PngPixels.Read(new MemoryStream(copy.ToArray())).ChannelParts(0));
    }
}
