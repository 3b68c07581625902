using Msisf.Core.Errors;
using Msisf.Core.Render.Photometry;
using Xunit;

namespace Msisf.Core.Tests.Render.Photometry;

public class GreyScaleTests
{
    // POV-Ray 3.7.0.10, PNG of 8 bits and of 16 (+FN16), assumed_gamma 1.0: facets with the texture of PovSceneWriter, lit at these
    // cosines.
    [Theory]
    [InlineData(0.00048828125, 1, 265)]
    [InlineData(0.00146484375, 3, 794)]
    [InlineData(0.00439453125, 9, 2381)]
    [InlineData(0.00537109375, 11, 2899)]
    [InlineData(0.01025390625, 19, 4910)]
    [InlineData(0.09814453125, 71, 18218)]
    [InlineData(0.25048828125, 111, 28641)]
    [InlineData(0.50048828125, 153, 39420)]
    [InlineData(0.74951171875, 184, 47304)]
    [InlineData(0.87939453125, 198, 50810)]
    [InlineData(0.99951171875, 209, 53791)]
    public void Level_LambertFacet_IsPovRays(double cosIncidence, int level8, int level16)
    {
        GreyScale scale = new();
        double radianceFactor = ReflectanceFactory.DefaultAlbedo * cosIncidence;

        Assert.Equal(level8, scale.Level(radianceFactor, 255));
        Assert.Equal(level16, scale.Level(radianceFactor, 65535));
    }

    [Theory]
    [InlineData(1.0, 0.5, 128)]
    [InlineData(1.0, 0.1, 26)]
    [InlineData(2.0, 0.25, 128)]
    [InlineData(0.5, 1.0, 128)]
    [InlineData(1.0, 0.00196, 0)]
    [InlineData(1.0, 0.00197, 1)]
    public void Level_Linear_IsExposureTimesRadianceFactorRounded(double exposure, double radianceFactor, int level) =>
        Assert.Equal(level, new GreyScale(exposure, GreyTransfer.Linear).Level(radianceFactor, 255));

    [Theory]
    [InlineData(GreyTransfer.Srgb)]
    [InlineData(GreyTransfer.Linear)]
    public void Level_BeyondTheEnds_IsBlackAndWhite(GreyTransfer transfer)
    {
        GreyScale scale = new(0.5, transfer);

        Assert.Equal(0, scale.Level(0.0, 255));
        Assert.Equal(0, scale.Level(-1.0, 255));
        Assert.Equal(255, scale.Level(2.0, 255));
        Assert.Equal(65535, scale.Level(1e300, 65535));
    }

    [Theory]
    [InlineData(0.0)]
    [InlineData(-1.0)]
    [InlineData(1e7)]
    [InlineData(double.NaN)]
    public void Constructor_ExposureOutOfRange_IsBadInput(double exposure) =>
        Assert.StartsWith(
            "exposure is ", Assert.Throws<BadInputException>(() => new GreyScale(exposure)).Message, StringComparison.Ordinal);
}
