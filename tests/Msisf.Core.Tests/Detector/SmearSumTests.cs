using Msisf.Core.Detector;
using Xunit;

namespace Msisf.Core.Tests.Detector;

public sealed class SmearSumTests
{
    private static readonly double[] Electrons = [10.0, 0.0, 20.0, 5.0, 40.0, 0.0]; // three rows of two pixels

    [Theory]
    [InlineData(true, true, new[] { 0.6, 0.05, 0.5, 0.0, 0.3, 0.05 })]
    [InlineData(false, true, new[] { 0.6, 0.05, 0.4, 0.0, 0.0, 0.0 })]
    [InlineData(false, false, new[] { 0.0, 0.0, 0.1, 0.0, 0.3, 0.05 })]
    public void Fill_RowsShiftedPastLight_CollectIt(bool beforeExposure, bool towardsBottom, double[] expected)
    {
        DetectorSettings settings = new()
        {
            ApertureArea = 1.0,
            Response = new SpectralResponse(500.0, 600.0, new SpectralCurve(1.0), new SpectralCurve(1.0)),
            ExposureTime = 0.1,
            Gain = 1.0,
            ConverterBits = 8,
            Smear = new Smear { RowTime = 1e-3, BeforeExposure = beforeExposure, TowardsBottom = towardsBottom },
        };
        double[] smear = new double[Electrons.Length];
        SmearSum.Fill(Electrons, width: 2, .., settings, smear);
        for (int i = 0; i < smear.Length; i++)
        {
            Assert.Equal(expected[i], smear[i], 12);
        }
    }
}
