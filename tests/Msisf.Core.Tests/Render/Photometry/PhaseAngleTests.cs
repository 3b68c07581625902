using Msisf.Core.Numerics;
using Msisf.Core.Render.Photometry;
using Xunit;

namespace Msisf.Core.Tests.Render.Photometry;

public class PhaseAngleTests
{
    [Theory]
    [InlineData(0.0, 0.0)]
    [InlineData(60.0, 0.25)]
    [InlineData(90.0, 0.5)]
    [InlineData(120.0, 0.75)]
    [InlineData(180.0, 1.0)]
    public void Haversine_KnownAngle_IsItsHaversine(double degrees, double haversine)
    {
        (double sine, double cosine) = Math.SinCos(double.DegreesToRadians(degrees));

        Assert.Equal(haversine, PhaseAngle.Haversine(Vector3D.UnitX, new Vector3D(cosine, sine, 0.0)), 15);
        Assert.Equal(degrees, double.RadiansToDegrees(PhaseAngle.FromHaversine(haversine)), 12);
    }

    [Fact]
    public void Haversine_NearOpposition_KeepsItsDigits()
    {
        // hav(1e-9) = 2.5e-19 (1 - 1e-18 / 12 ...); a cosine of that angle is 1.
        double haversine = PhaseAngle.Haversine(Vector3D.UnitX, new Vector3D(1.0, 1e-9, 0.0));

        Assert.InRange(haversine, 2.5e-19 * (1.0 - 1e-15), 2.5e-19 * (1.0 + 1e-15));
        Assert.InRange(PhaseAngle.FromHaversine(haversine), 1e-9 * (1.0 - 1e-15), 1e-9 * (1.0 + 1e-15));
    }

    [Fact]
    public void HalfTangent_RightAngleAndBackwards_IsOneAndInfinite()
    {
        Assert.Equal(1.0, PhaseAngle.HalfTangent(0.5));
        Assert.Equal(double.PositiveInfinity, PhaseAngle.HalfTangent(1.0));
    }

    [Fact]
    public void Haversine_VectorsTooLongByRounding_StaysInRange()
    {
        Vector3D v = (1.0 + 1e-15) * Vector3D.UnitX;

        Assert.Equal(1.0, PhaseAngle.Haversine(v, -v));
    }
}
