using FsCheck;
using FsCheck.Fluent;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Xunit;

namespace Msisf.Core.Tests.Numerics;

/// <summary>Quaternions and matrices: they turn the right way round, agree with each other, and keep lengths.</summary>
public sealed class RotationTests
{
    /// <summary>1: a rotation rounds each component a few times.</summary>
    private const double Rounding = 1e-15;

    private static readonly Config Seeded = Config.QuickThrowOnFailure.WithMaxTest(500).WithReplay(20120222UL, 1UL);

    private static readonly Gen<UnitQuaternion> Rotations =
        from axis in Gen.Choose(-1000, 1000).Three().Where(a => a != (0, 0, 0))
        from angle in Gen.Choose(-1_000_000, 1_000_000)
        select UnitQuaternion.FromAxisAngle(new Vector3D(axis.Item1, axis.Item2, axis.Item3), angle * Math.PI / 1e6);

    [Fact]
    public void Quaternion_QuarterTurnAboutZ_TurnsXToY() =>
        AssertNear(Vector3D.UnitY, UnitQuaternion.FromAxisAngle(Vector3D.UnitZ, Math.PI / 2.0) * Vector3D.UnitX);

    [Fact]
    public void Quaternion_Product_IsTheRightOneFirst()
    {
        UnitQuaternion aboutZ = UnitQuaternion.FromAxisAngle(Vector3D.UnitZ, Math.PI / 2.0);
        UnitQuaternion aboutX = UnitQuaternion.FromAxisAngle(Vector3D.UnitX, Math.PI / 2.0);

        AssertNear(Vector3D.UnitZ, aboutX * aboutZ * Vector3D.UnitX);
    }

    [Fact]
    public void FrameAboutZ_QuarterTurn_SeesXAtMinusY() =>
        AssertNear(-Vector3D.UnitY, RotationMatrix.FrameAboutZ(Math.PI / 2.0) * Vector3D.UnitX);

    [Fact]
    public void FrameAboutX_QuarterTurn_SeesYAtMinusZ() =>
        AssertNear(-Vector3D.UnitZ, RotationMatrix.FrameAboutX(Math.PI / 2.0) * Vector3D.UnitY);

    [Fact]
    public void FrameAboutY_QuarterTurn_SeesZAtMinusX() =>
        AssertNear(-Vector3D.UnitX, RotationMatrix.FrameAboutY(Math.PI / 2.0) * Vector3D.UnitZ);

    [Fact]
    public void FromMatrix_OfAnyRotation_TurnsTheSameWay() =>
        Prop.ForAll(Rotations.ToArbitrary(), rotation =>
        {
            RotationMatrix matrix = new RotationMatrix(
                rotation * Vector3D.UnitX, rotation * Vector3D.UnitY, rotation * Vector3D.UnitZ).Transposed;
            UnitQuaternion again = UnitQuaternion.FromMatrix(matrix);
            Vector3D v = new(0.3, -0.7, 0.2);
            return again.W >= 0.0 && ((again * v) - (matrix * v)).Length < 4.0 * Rounding
                && ((again * v) - (rotation * v)).Length < 4.0 * Rounding;
        }).Check(Seeded);

    [Fact]
    public void MatrixProduct_OfAnyTwo_IsTheRightOneFirst() =>
        Prop.ForAll(Rotations.Two().ToArbitrary(), pair =>
        {
            RotationMatrix first = MatrixOf(pair.Item1);
            RotationMatrix second = MatrixOf(pair.Item2);
            Vector3D v = new(0.3, -0.7, 0.2);
            return ((second * first * v) - (second * (first * v))).Length < 4.0 * Rounding
                && ((first.Transposed * (first * v)) - v).Length < 4.0 * Rounding;
        }).Check(Seeded);

    [Theory]
    [InlineData(0.0, 0.0, 0.0, 0.0)]
    [InlineData(0.0, 0.0, 0.0, 1.0000011)]
    [InlineData(0.0, 0.0, 0.0, 0.9999989)]
    [InlineData(double.NaN, 0.0, 0.0, 1.0)]
    [InlineData(double.PositiveInfinity, 0.0, 0.0, 1.0)]
    public void FromComponents_NoRotation_IsRefused(double x, double y, double z, double w) =>
        Assert.Throws<BadInputException>(() => UnitQuaternion.FromComponents(x, y, z, w));

    [Fact]
    public void FromComponents_NearlyUnit_IsNormalised()
    {
        UnitQuaternion q = UnitQuaternion.FromComponents(0.6000003, 0.0, 0.0, 0.8000004);

        Assert.Equal((0.6, 0.8), (Math.Round(q.X, 15), Math.Round(q.W, 15)));
    }

    [Fact]
    public void ToString_MatrixAndQuaternion_AreTheirNumbers()
    {
        Assert.Equal("[(1, 0, 0), (0, 1, 0), (0, 0, 1)]", RotationMatrix.Identity.ToString());
        Assert.Equal("{0,0,0,1}", UnitQuaternion.Identity.ToString());
    }

    private static RotationMatrix MatrixOf(UnitQuaternion q) =>
        new RotationMatrix(q * Vector3D.UnitX, q * Vector3D.UnitY, q * Vector3D.UnitZ).Transposed;

    private static void AssertNear(Vector3D expected, Vector3D actual) =>
        Assert.InRange((actual - expected).Length, 0.0, Rounding);
}
