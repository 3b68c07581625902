using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Scene;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Scene;

public class SpacecraftStateTests
{
    [Fact]
    public void FromNumbers_ThesisOrder_RealPartLast()
    {
        SpacecraftState state = Moments.StateOf([55289.5, 1e6, 2e6, 3e6, 0.6, 0.0, 0.0, -0.8]);

        Assert.Equal(55289.5, state.Time.Mjd);
        Assert.Equal(new Vector3D(1e6, 2e6, 3e6), state.PositionBodyFixed);
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
            Assert.Throws<BadInputException>(() => Moments.StateOf([mjd, x, 2e6, 0.0, 0.0, 0.0, 0.0, q0])).Message,
            StringComparison.Ordinal);

    [Fact]
    public void FromNumbers_SixNumbersBehindTheTime_IsABug() =>
        Assert.Throws<ArgumentException>(() => Moments.StateOf([55289.0, 0.0, 0.0, 2e6, 0.0, 0.0, 1.0]));

    /// <summary>
    /// A state that is written out and read back is the same to the last bit, so a run from a batch file is that from the orbit.
    /// </summary>
    [Fact]
    public void ToNumbers_ReadBack_IsTheSameState()
    {
        Random random = new(7);
        double Component() => (2.0 * random.NextDouble()) - 1.0;
        for (int i = 0; i < 100_000; i++)
        {
            double[] q = [Component(), Component(), Component(), Component()];
            double length = Math.Sqrt(q.Sum(c => c * c));
            SpacecraftState state = Moments.StateOf(
                [55289.0 + Component(), Component(), Component(), Component(), q[0] / length, q[1] / length, q[2] / length, q[3] / length]);
            UnitQuaternion product = state.MoonFromCamera * UnitQuaternion.FromAxisAngle(Vector3D.UnitZ, Component());
            SpacecraftState turned = state with { MoonFromCamera = product };

            Assert.Equal(state, Moments.StateOf(state.ToNumbers()));
            Assert.Equal(turned, Moments.StateOf(turned.ToNumbers()));
        }
    }
}
