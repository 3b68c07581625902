using Msisf.Core.Attitude;
using Msisf.Core.Numerics;
using Xunit;

namespace Msisf.Core.Tests.Attitude;

public sealed class EulerAngleSamplesTests
{
    /// <summary>Angles that grow at constant rates do so between the samples, past a full turn too, whatever the sequence.</summary>
    [Theory]
    [InlineData("ZXZ", false)]
    [InlineData("ZYX", false)]
    [InlineData("XYZ", true)]
    public void At_ConstantRates_AreKeptBetweenSamples(string axes, bool turnsToBody)
    {
        EulerSequence sequence = EulerSequence.Parse(axes);
        EulerAngleSamples samples = new(sequence, turnsToBody) { Interpolation = new Interpolation(InterpolationMethod.Hermite, 3) };
        for (int i = 0; i < 12; i++)
        {
            Vector3D angles = Angles(40.0 * i);
            samples.Add(40.0 * i, new Vector3D(angles.X % Math.Tau, angles.Y % Math.Tau, angles.Z % Math.Tau), Rates);
        }

        foreach (double time in (double[])[0.0, 13.0, 20.0, 177.0, 440.0])
        {
            UnitQuaternion expected = At(sequence, turnsToBody, time);
            Assert.InRange(Angle(expected, samples.At(time)), 0.0, 1e-12);

            // The rate about the body's axes, from attitudes half a millisecond before and after.
            const double Step = 5e-4;
            UnitQuaternion turn = At(sequence, turnsToBody, time - Step).Conjugate * At(sequence, turnsToBody, time + Step);
            Vector3D rate = 2.0 / (2.0 * Step) * new Vector3D(turn.X, turn.Y, turn.Z);
            Assert.InRange((rate - samples.RateAt(time)!.Value).Length, 0.0, 1e-11);
        }
    }

    private static Vector3D Rates => new(0.02, -0.013, 0.035); // rad/s: up to 1.4 rad from sample to sample

    private static Vector3D Angles(double time) => new Vector3D(0.3, 1.1, -2.0) + (time * Rates);

    private static UnitQuaternion At(EulerSequence sequence, bool turnsToBody, double time)
    {
        Vector3D angles = Angles(time);
        UnitQuaternion turned = sequence.FrameFromBody([angles.X, angles.Y, angles.Z]);
        return turnsToBody ? turned.Conjugate : turned;
    }

    private static double Angle(UnitQuaternion p, UnitQuaternion q)
    {
        UnitQuaternion turn = p.Conjugate * q;
        return 2.0 * Math.Atan2(new Vector3D(turn.X, turn.Y, turn.Z).Length, Math.Abs(turn.W));
    }
}
