using Xunit;

namespace Msisf.Synthesis.Tests;

public sealed class SlopeLawTests
{
    // Slopes at 17 m as published; at 473.80 m tests/reference/portable_math.py (mpmath).
    [Theory]
    [InlineData(17.0, 7.5, 2.0)]
    [InlineData(473.80, 6.3607034, 0.90019299)]
    public void TangentAt_Baseline_IsThePublishedSlope(double baseline, double highlandsDegrees, double mariaDegrees)
    {
        Assert.Equal(highlandsDegrees, Degrees(SlopeLaw.Highlands.TangentAt(baseline)), 1e-6);
        Assert.Equal(mariaDegrees, Degrees(SlopeLaw.Maria.TangentAt(baseline)), 1e-6);
    }

    private static double Degrees(double tangent) => Math.Atan(tangent) * 180.0 / Math.PI;
}
