using Msisf.Core.Errors;
using Msisf.Core.Layers;
using Xunit;

namespace Msisf.Core.Tests.Layers;

public class LayerSetTests
{
    [Theory]
    [InlineData("all")]
    [InlineData(" ALL ")]
    public void Parse_All_HasEachLayerOnce(string text)
    {
        string[] names = [.. LayerSet.Parse(text).Layers.Select(layer => layer.Name)];

        Assert.Equal(28, names.Length);
        Assert.Equal(28, names.Distinct().Count());
    }

    [Fact]
    public void Parse_List_ComesInTheOrderOfTheFile() =>
        Assert.Equal(["depth", "normal", "mask"], LayerSet.Parse("mask, Normal,depth").Layers.Select(layer => layer.Name));

    [Theory]
    [InlineData("depth,dept", "'dept' is not a layer")]
    [InlineData("", "'' is not a layer")]
    [InlineData("depth,", "'' is not a layer")]
    [InlineData("depth,all", "'all' is not a layer")]
    [InlineData("depth,mask,DEPTH", "depth is there twice")]
    public void Parse_WrongList_IsRefusedWithWhatIsWrong(string text, string reason)
    {
        UsageException failure = Assert.Throws<UsageException>(() => LayerSet.Parse(text));

        Assert.StartsWith($"--layers {text}: {reason}", failure.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Parse_UnknownName_NamesAllThatThereAre() =>
        Assert.Contains(
            "depth, range, position, latitude, longitude, height, normal, incidence, emission, phase, illumination-direction, "
                + "mask, sun-visibility, tile, cell, pixel-scale, slope, aspect, sphere-incidence, radiance-factor, radiance",
            Assert.Throws<UsageException>(() => LayerSet.Parse("x")).Message,
            StringComparison.Ordinal);
}
