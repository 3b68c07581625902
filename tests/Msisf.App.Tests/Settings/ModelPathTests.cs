using Msisf.Adapters.Raster.Heights;
using Msisf.App.Settings;
using Msisf.Core.Errors;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.App.Tests.Settings;

public sealed class ModelPathTests
{
    [Theory]
    [InlineData("site.tif", "site.tif", null, null)]
    [InlineData("site.tif,scale=0.3048", "site.tif", 0.3048, null)]
    [InlineData("a,b/site.tif,offset=-37.5,scale=1e3", "a,b/site.tif", 1000.0, -37.5)]
    [InlineData("/vsicurl/https://h/s.tif?x=1,2&k=v,scale=2", "/vsicurl/https://h/s.tif?x=1,2&k=v", 2.0, null)]
    public void Parse_Options_AreThoseBehindThePath(string text, string path, double? scale, double? offset) =>
        Assert.Equal(new ModelPath(path, new HeightOptions(scale, offset)), ModelPath.Parse(text));

    [Theory]
    [InlineData("site.tif,offset=auto", true, 0.0, 0.0)]
    [InlineData("site.tif,shift=120,-37.5", false, 120.0, -37.5)]
    [InlineData("site.tif,shift=-1e3,0,offset=auto", true, -1000.0, 0.0)]
    public void Parse_Placement_IsThatBehindThePath(string text, bool meetsBorder, double east, double north) => Assert.Equal(
        new ModelPath("site.tif", default, new ModelPlacement(meetsBorder, east, north)), ModelPath.Parse(text));

    [Theory]
    [InlineData("site.tif,shift=1", "shift is two numbers")]
    [InlineData("site.tif,shift=1,x", "shift is two numbers")]
    [InlineData("site.tif,shift=1,2,3", "'3' is not an option of a model")]
    [InlineData("site.tif,shift=1,2,shift=1,2", "given once")]
    [InlineData("site.tif,offset=auto,offset=3", "given once")]
    [InlineData("site.tif,offset=Auto", "is a number or auto")]
    [InlineData("site.tif,scale=0", "scale, metres a step")]
    [InlineData("site.tif,scale=-1", "scale, metres a step")]
    [InlineData("site.tif,scale=NaN", "scale, metres a step")]
    [InlineData("site.tif,scale=1,scale=2", "given once")]
    [InlineData("site.tif,offset=x", "offset, metres that are added")]
    [InlineData("site.tif,offset=1e999", "offset, metres that are added")]
    [InlineData("site.tif,sclae=2", "'sclae' is not an option of a model")]
    [InlineData("site.tif,scale=2,more", "'more' is not an option of a model")]
    public void Parse_WrongOption_IsRefused(string text, string message)
    {
        UsageException exception = Assert.Throws<UsageException>(() => ModelPath.Parse(text));
        Assert.StartsWith($"--ldem {text}: ", exception.Message, StringComparison.Ordinal);
        Assert.Contains(message, exception.Message, StringComparison.Ordinal);
    }

    /// <summary>A file that is there is meant, whatever its name is.</summary>
    [Fact]
    public void Parse_FileWithSuchAName_IsThatFile()
    {
        using TemporaryFolder folder = new();
        string path = folder["site.tif,scale=2"];
        File.WriteAllText(path, string.Empty);
        Assert.Equal(new ModelPath(path, default), ModelPath.Parse(path));
    }
}
