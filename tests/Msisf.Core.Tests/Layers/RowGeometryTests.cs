using Msisf.Core.Layers;
using Msisf.Core.Numerics;
using Xunit;

namespace Msisf.Core.Tests.Layers;

public sealed class RowGeometryTests
{
    [Fact]
    public void FindExactAngles_AnyVectors_AreKahans()
    {
        Random random = new(20120222);
        VectorRow u = VectorRow.OfLength(300);
        VectorRow v = VectorRow.OfLength(300);
        for (int i = 0; i < 290; i++)
        {
            (u.X[i], u.Y[i], u.Z[i]) = (random.NextDouble() - 0.5, random.NextDouble(), random.NextDouble());
            (v.X[i], v.Y[i], v.Z[i]) = i % 3 == 0 ? (u.X[i], u.Y[i], u.Z[i] + 1e-9) : (random.NextDouble(), -random.NextDouble(), 1e5);
        }

        double[] uLengths = new double[300];
        double[] vLengths = new double[300];
        double[] degrees = new double[300];
        LaneHypot.Lengths(u, 290, uLengths);
        LaneHypot.Lengths(v, 290, vLengths);
        RowGeometry.FindExactAngles(u, uLengths, v, vLengths, 290, degrees);

        for (int i = 0; i < 290; i++)
        {
            Assert.Equal(double.RadiansToDegrees(Vector3D.AngleBetween(u[i], v[i])), degrees[i]);
        }
    }
}
