using Msisf.App.Settings;
using Msisf.Core.Numerics;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.App.Tests.Settings;

/// <summary>Quaternions of few decimals.</summary>
public sealed class TrajectorySettingsReaderTests
{
    // Half a turn about (1, 1, 1) and more, to five decimals: its length is 1 - 6e-6.
    private const string Rounded = "0.35355,0.35355,0.61237,0.61237";

    [Fact]
    public void Read_RoundedQuaternion_IsNormalisedIfTheUserSaysSo()
    {
        TrajectorySettings settings = TrajectorySettingsReader.Read(
            Given.Options($"--fixed-state {{55289,2E6,0,0,{Rounded}}} --normalize"));

        AssertUnit(Assert.IsType<FixedStateSettings>(settings).State.MoonFromCamera);
    }

    [Fact]
    public void Read_RoundedAttitude_IsNormalisedIfTheUserSaysSo()
    {
        OrbitSettings orbit = Assert.IsType<OrbitSettings>(TrajectorySettingsReader.Read(Given.Options(
            $"--kepler-set {{1.9E6,0.05,0.7,1.1,0.9,2.0}} --epoch 55289 --time 55289 --attitude {{{Rounded}}} --normalize")));

        AssertUnit(orbit.Attitude!.At(0.0));
    }

    private static void AssertUnit(UnitQuaternion q)
    {
        Assert.Equal(1.0, Math.Sqrt((q.X * q.X) + (q.Y * q.Y) + (q.Z * q.Z) + (q.W * q.W)), Rounding.OfUnits);
        Assert.Equal(0.35355 / 0.61237, q.X / q.W, Rounding.OfTurns);
    }
}
