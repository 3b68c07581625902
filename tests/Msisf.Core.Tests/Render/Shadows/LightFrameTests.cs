using Msisf.Core.Numerics;
using Msisf.Core.Render.Shadows;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Render.Shadows;

public sealed class LightFrameTests
{
    private static readonly Vector3D Sun = new(1.074955e11, -1.042431e11, 4.036e9);

    [Fact]
    public void FromMoonMe_Vectors_AreTheScalarBitForBit()
    {
        LightFrame frame = new(Sun, new Vector3D(1.0, 2.0, 3.0));
        Random random = new(3);
        double[] x = new double[64];
        double[] y = new double[64];
        double[] z = new double[64];
        Vector3D[] points = new Vector3D[64];
        for (int i = 0; i < points.Length; i++)
        {
            points[i] = 1.74e6 * new Vector3D(random.NextDouble() - 0.5, random.NextDouble() - 0.5, random.NextDouble() - 0.5).Normalized();
            (x[i], y[i], z[i]) = points[i];
        }

        frame.FromBodyFixed(x, y, z);
        for (int i = 0; i < points.Length; i++)
        {
            Assert.Equal(frame.FromBodyFixed(points[i]), new Vector3D(x[i], y[i], z[i]));
        }
    }

    [Fact]
    public void FromMoonMe_PointsOfARayFromTheSun_DifferInDepthOnly()
    {
        LightFrame frame = new(Sun, Vector3D.UnitZ);
        Vector3D near = new(1.2e6, -1.1e6, 3e5);
        Vector3D far = near + (6e5 * (near - Sun).Normalized());
        Vector3D a = frame.FromBodyFixed(near);
        Vector3D b = frame.FromBodyFixed(far);
        // m: some last digits of 1.7e6 m, each 2e-10.
        Assert.Equal(a.X, b.X, 1e-9);
        Assert.Equal(a.Y, b.Y, Rounding.OfPlaces);
        Assert.True(b.Z > a.Z + 5e5);
    }

    [Theory]
    [InlineData(0.0, 0.0, 1.0)]
    [InlineData(1.0, 0.0, 0.0)]
    [InlineData(0.3, -0.2, 0.1)]
    public void Axes_DirectionAlongOrNearTheSun_AreOrthonormalAndRightHanded(double x, double y, double z)
    {
        foreach (Vector3D towards in new[] { new Vector3D(x, y, z), default, 1.000001 * new Vector3D(x, y, z), Vector3D.UnitY })
        {
            LightFrame frame = new(1.5e11 * new Vector3D(x, y, z).Normalized(), towards);
            // Some last digits of 1, here and below.
            Assert.True((Vector3D.Cross(frame.AxisU, frame.AxisV) - frame.AxisW).Length < 1e-15);
            Assert.Equal(1.0, frame.AxisU.Length, Rounding.OfUnits);
            Assert.Equal(0.0, Vector3D.Dot(frame.AxisU, frame.AxisW), Rounding.OfUnits);
        }
    }

    [Fact]
    public void Axes_Direction_LeansToIt()
    {
        LightFrame frame = new(1.5e11 * Vector3D.UnitX, new Vector3D(5.0, 3.0, 4.0));
        Assert.True((frame.AxisU - new Vector3D(0.0, 0.6, 0.8)).Length < Rounding.OfUnits);
    }
}
