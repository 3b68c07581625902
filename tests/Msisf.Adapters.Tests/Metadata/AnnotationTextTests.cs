using Msisf.Adapters.Metadata;
using Msisf.Core.Camera;
using Msisf.Core.Metadata;
using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.Core.Time;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Metadata;

public class AnnotationTextTests
{
    [Theory]
    [InlineData("LDEM_64", false, 64, 64, "LDEM_64", "64 px/deg")]
    [InlineData("LDEM_64_SYNTHETIC", true, 64, 64, "LDEM_64_SYNTHETIC (SYNTHETIC)", "64 px/deg")]
    [InlineData("LDEM_64", false, 2, 2, "LDEM_64", "64 px/deg, drawn at 2")]
    [InlineData("LDEM_64", false, 16, 2, "LDEM_64", "64 px/deg, drawn at 2 to 16")]
    public void Lines_Model_IsNamedWithTheLevelsDrawn(
        string product, bool isSynthetic, int finest, int coarsest, string model, string resolution)
    {
        string[] lines = AnnotationText.Lines(Frame(new DrawnElevation(product, isSynthetic, 64, finest, coarsest)));

        Assert.Contains($"Elevation model:    {model}", lines);
        Assert.Contains($"Surface resolution: {resolution}", lines);
    }

    [Fact]
    public void Lines_Camera_HasItsHeightOverTheMeanRadiusAndOverTheTerrain() =>
        // 1,800,000 m - 1,737,150 m.
        Assert.Contains(
            "Flight altitude:    62850 m (61234 m over the terrain)", AnnotationText.Lines(Frame(new("LDEM_4", false, 4, 4, 4))));

    private static FrameMetadata Frame(DrawnElevation elevation) => new(
        Moments.OfMjd(55289.0),
        new PinholeCamera(new Vector3D(1.8e6, 0.0, 0.0), UnitQuaternion.Identity, 0.7, 64, 64),
        40.0,
        new Vector3D(1.5e11, 0.0, 0.0),
        elevation,
        61234.25,
        "1.0.0",
        string.Empty,
        RendererKind.PovRay,
        []);
}
