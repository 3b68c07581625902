using Msisf.Adapters.Input;
using Xunit;

namespace Msisf.Adapters.Tests.Input;

public sealed class NearestNameTests
{
    [Theory]
    [InlineData("fovv", "fov")]
    [InlineData("hight", "height")]
    [InlineData("outputdir", "output-dir")]
    [InlineData("FOV", "fov")]
    public void Question_MisspeltWord_NamesTheNearest(string word, string name) =>
        Assert.Equal($": did you mean {name}?", NearestName.Question(word, ["height", "output-dir", "fov", "width"]));

    [Theory]
    [InlineData("widht", ": did you mean width?")]
    [InlineData("WIDHT", ": did you mean width?")]
    [InlineData("frobnicate", "")]
    [InlineData("", "")]
    public void Question_WordFarFromAllNames_IsEmpty(string word, string question) =>
        Assert.Equal(question, NearestName.Question(word, ["height", "output-dir", "fov", "width"]));
}
