using Msisf.TestSupport;
using Xunit;

namespace Msisf.Synthesis.Tests;

public sealed class MareMaskTests
{
    private static readonly MareMask Mask = new(FunctionGrid.HighlandsAndMare(2), CancellationToken.None);

    [Theory]
    [InlineData(-2500.0, 1.0, 1.0)] // Mare Imbrium
    [InlineData(-5000.0, -0.8, 0.0)] // South Pole-Aitken basin
    [InlineData(0.0, 1.0, 0.0)]
    [InlineData(-1250.0, 1.0, 0.5)]
    public void FractionOf_HeightAndSide_FollowsTheRule(double height, double nearSide, double expected) =>
        Assert.Equal(expected, MareMask.FractionOf(height, nearSide), Rounding.OfChains);

    [Theory]
    [InlineData(0.0, 0.0, 1.0)]
    [InlineData(0.0, 359.9, 1.0)]
    [InlineData(0.0, 180.0, 0.0)]
    [InlineData(90.0, 0.0, 0.0)]
    public void At_Place_IsMareOnTheLowNearSideOnly(double latitude, double longitude, double expected) =>
        Assert.Equal(expected, Mask.At(latitude, longitude), 1e-6); // fractions are floats

    [Fact]
    public void FillLine_OverPrimeMeridianAndPole_AgreesWithAt()
    {
        TileFrame frame = new(pixelsPerDegree: 4, firstLine: -8, lines: 120, firstSample: -360, samples: 720);
        float[] fractions = new float[frame.Stride];
        for (int line = 0; line < frame.Lines; line++)
        {
            Mask.FillLine(frame, line, fractions);
            for (int column = 0; column < frame.Samples; column++)
            {
                double longitude = (frame.FirstSample + column + 0.5) / frame.PixelsPerDegree;
                longitude += longitude < 0.0 ? 360.0 : 0.0;
                // a line is computed in floats, a place in doubles
                Assert.Equal(Mask.At(frame.LatitudeDegrees(line), longitude), fractions[column], 1e-5);
            }
        }
    }
}
