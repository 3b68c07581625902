using Msisf.Adapters.Input;
using Xunit;

namespace Msisf.Adapters.Tests.Input;

public sealed class NearestNameTests
{
    [Theory]
    [InlineData("fovv", "fov")]
    [InlineData("hight", "height")]
    [InlineData("outputdir", "output-dir")]
    [InlineData("", "fov")]
    public void To_MisspeltWord_IsFound(string word, string name) =>
        Assert.Equal(name, NearestName.To(word, ["height", "output-dir", "fov", "width"]));
}
