using Msisf.TestSupport;
using Msisf.TestSupport.Images;
using Xunit;

namespace Msisf.Stress.Tests.Images;

public sealed class SrgbCurveTests
{
    // IEC 61966-2-1, by mpmath: ((188/255 + 0.055)/1.055)^2.4; 10/255/12.92
    [Theory]
    [InlineData(0, 0.0)]
    [InlineData(10, 0.0030352698354883756)]
    [InlineData(188, 0.5028864580325687)]
    [InlineData(255, 1.0)]
    public void Linear_ALevel_IsTheStandards(double level, double linear) =>
        Assert.Equal(linear, SrgbCurve.Linear(new double[,] { { level } })[0, 0], Rounding.OfTurns);
}
