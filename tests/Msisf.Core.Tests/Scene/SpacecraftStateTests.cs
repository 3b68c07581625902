using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Scene;
using Xunit;

namespace Msisf.Core.Tests.Scene;

public class SpacecraftStateTests
{
    [Fact]
    public void FromNumbers_ThesisOrder_RealPartLast()
    {
        SpacecraftState state = SpacecraftState.FromNumbers([55289.5, 1e6, 2e6, 3e6, 0.6, 0.0, 0.0, -0.8]);

        Assert.Equal(55289.5, state.Time.Days);
        Assert.Equal(new Vector3D(1e6, 2e6, 3e6), state.PositionMoonMe);
        Assert.Equal(
            (0.6, 0.0, 0.0, -0.8),
            (state.MoonFromCamera.X, state.MoonFromCamera.Y, state.MoonFromCamera.Z, state.MoonFromCamera.W));
    }

    [Theory]
    [InlineData(4e6, 0.0, 1.0, "The MJD 4000000 is not a date")]
    [InlineData(55289.0, double.PositiveInfinity, 1.0, "rx (m) is Infinity")]
    [InlineData(55289.0, 0.0, 0.9, "has length 0.9")]
    public void FromNumbers_WrongNumber_Refused(double mjd, double x, double q0, string reason) =>
        Assert.Contains(
            reason,
            Assert.Throws<BadInputException>(() => SpacecraftState.FromNumbers([mjd, x, 2e6, 0.0, 0.0, 0.0, 0.0, q0])).Message,
            StringComparison.Ordinal);

    [Fact]
    public void FromNumbers_SevenNumbers_IsABug() =>
        Assert.Throws<ArgumentException>(() => SpacecraftState.FromNumbers([55289.0, 0.0, 0.0, 2e6, 0.0, 0.0, 1.0]));
}
