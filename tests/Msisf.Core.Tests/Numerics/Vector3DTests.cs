using Msisf.Core.Numerics;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Numerics;

public sealed class Vector3DTests
{
    [Theory]
    [InlineData(1e-9)]
    [InlineData(1e-300)]
    [InlineData(3.0)]
    public void AngleBetween_SmallAngles_KeepTheirDigits(double angle) =>
        Assert.Equal(
            angle, Vector3D.AngleBetween(Vector3D.UnitX, new Vector3D(Math.Cos(angle), Math.Sin(angle), 0.0)), Rounding.OfUnits * angle);

    [Fact]
    public void AngleBetween_OppositeVectors_IsPi() =>
        Assert.Equal(Math.PI, Vector3D.AngleBetween(new Vector3D(1.0, 2.0, 3.0), new Vector3D(-2.0, -4.0, -6.0)));

    [Theory]
    [InlineData(1e200)]
    [InlineData(1e-200)]
    public void Length_ExtremeComponents_NeitherOverflowNorVanish(double unit) =>
        Assert.Equal(3.0, new Vector3D(unit, 2.0 * unit, 2.0 * unit).Length / unit, Rounding.OfUnits);

    [Fact]
    public void Cross_NearlyParallelVectors_KeepsItsDigits()
    {
        // (1, 1 + 2^-52, 0) x (1 - 2^-53, 1, 0): the z component is 1 - (1 + 2^-52)(1 - 2^-53) = -2^-53 + 2^-105, exactly.
        double z = Vector3D.Cross(new Vector3D(1.0, Math.BitIncrement(1.0), 0.0), new Vector3D(Math.BitDecrement(1.0), 1.0, 0.0)).Z;

        Assert.Equal(-Math.ScaleB(1.0, -53) + Math.ScaleB(1.0, -105), z);
    }

    [Fact]
    public void Cross_Axes_IsRightHanded() => Assert.Equal(Vector3D.UnitZ, Vector3D.Cross(Vector3D.UnitX, Vector3D.UnitY));

    [Theory]
    [InlineData(0.0)]
    [InlineData(double.NaN)]
    [InlineData(double.PositiveInfinity)]
    public void Normalized_VectorWithoutDirection_IsRefused(double x) =>
        Assert.Throws<InvalidOperationException>(() => new Vector3D(x, 0.0, 0.0).Normalized());

    [Fact]
    public void ToString_AnyCulture_HasDecimalPoints() =>
        Assert.Equal("(1.5, -0.1, 1E+20)", new Vector3D(1.5, -0.1, 1e20).ToString());
}
