using Msisf.Core.Attitude;
using Msisf.Core.Numerics;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Attitude;

public sealed class AttitudeSamplesTests
{
    private const double Rate = 0.01; // rad/s

    private static readonly Vector3D Axis = new Vector3D(1.0, 2.0, -2.0) / 3.0;

    /// <summary>The body turns at a constant rate about an axis at rest, which is the same in the body's own axes.</summary>
    [Theory]
    [InlineData(InterpolationMethod.Linear, 1, 1e-15)]
    [InlineData(InterpolationMethod.Lagrange, 5, 1e-9)]
    [InlineData(InterpolationMethod.Hermite, 5, 1e-9)]
    public void At_ConstantRate_IsMet(InterpolationMethod method, int degree, double limit)
    {
        AttitudeSamples samples = new() { Interpolation = new Interpolation(method, degree) };
        for (int i = 0; i < 12; i++)
        {
            UnitQuaternion attitude = Turned(10.0 * i);

            // Every third sample has the other sign, as files that keep the scalar positive have.
            UnitQuaternion written = i % 3 == 0 ? attitude : Negated(attitude);
            samples.Add(10.0 * i, written, Rate * Axis);
        }

        for (double time = 0.0; time <= 110.0; time += 3.7)
        {
            Assert.InRange(Angle(samples.At(time), Turned(time)), 0.0, limit * (time is > 25.0 and < 85.0 ? 1.0 : 1e4));
            Assert.InRange(((Rate * Axis) - samples.RateAt(time)!.Value).Length, 0.0, limit * (time is > 25.0 and < 85.0 ? 1.0 : 1e4));
        }
    }

    /// <summary>The rates that a file states are those at its lines, whatever the attitudes say.</summary>
    [Theory]
    [InlineData(InterpolationMethod.Linear, 1)]
    [InlineData(InterpolationMethod.Lagrange, 3)]
    [InlineData(InterpolationMethod.Hermite, 3)]
    public void RateAt_StatedRates_AreTheirs(InterpolationMethod method, int degree)
    {
        AttitudeSamples samples = new() { Interpolation = new Interpolation(method, degree) };
        for (int i = 0; i < 6; i++)
        {
            samples.Add(10.0 * i, Turned(10.0 * i), new Vector3D(0.02, 0.001 * i, 0.0));
        }

        Assert.InRange((new Vector3D(0.02, 0.002, 0.0) - samples.RateAt(20.0)!.Value).Length, 0.0, Rounding.OfUnits);
        if (method != InterpolationMethod.Hermite)
        {
            Assert.InRange((new Vector3D(0.02, 0.0025, 0.0) - samples.RateAt(25.0)!.Value).Length, 0.0, Rounding.OfUnits);
        }

        AttitudeSamples without = new();
        without.Add(5.0, Turned(5.0));
        Assert.Null(without.RateAt(5.0));
    }

    [Fact]
    public void At_OneSample_IsThatSample()
    {
        AttitudeSamples samples = new();
        samples.Add(5.0, Turned(5.0));

        Assert.InRange(Angle(samples.At(5.0), Turned(5.0)), 0.0, Rounding.OfUnits);
    }

    private static UnitQuaternion Turned(double time) =>
        UnitQuaternion.FromAxisAngle(Vector3D.UnitX, 0.4) * UnitQuaternion.FromAxisAngle(Axis, Rate * time);

    private static UnitQuaternion Negated(UnitQuaternion q) => UnitQuaternion.FromComponents(-q.X, -q.Y, -q.Z, -q.W);

    private static double Angle(UnitQuaternion p, UnitQuaternion q)
    {
        UnitQuaternion turn = p.Conjugate * q;
        return 2.0 * Math.Atan2(new Vector3D(turn.X, turn.Y, turn.Z).Length, Math.Abs(turn.W));
    }
}
