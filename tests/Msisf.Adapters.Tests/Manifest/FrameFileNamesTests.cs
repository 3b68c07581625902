using Msisf.Adapters.Manifest;
using Xunit;

namespace Msisf.Adapters.Tests.Manifest;

public class FrameFileNamesTests
{
    [Theory]
    [InlineData("m.png", "m")]
    [InlineData("m.xml", "m")]
    [InlineData("m.pov", "m")]
    [InlineData("m.fits", "m")]
    [InlineData("m.layers.json", "m")]
    [InlineData("m.sun-visibility.npy", "m")]
    [InlineData("m.annotated.png", "m.annotated,m")] // also the image of a frame "m.annotated"
    [InlineData("m.txt", "")]
    [InlineData("m.npy", "")]
    [InlineData("m", "")]
    public void FramesOf_Name_IsThatBeforeTheEnding(string file, string frames)
    {
        string[] expected = frames.Split(',', StringSplitOptions.RemoveEmptyEntries);

        Assert.Equal(expected, FrameFileNames.FramesOf(file));
        Assert.All(expected, frame => Assert.Contains(file, FrameFileNames.Of(frame)));
    }
}
