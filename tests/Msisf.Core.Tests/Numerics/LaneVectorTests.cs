using System.Runtime.Intrinsics;
using Msisf.Core.Numerics;
using Xunit;

namespace Msisf.Core.Tests.Numerics;

public sealed class LaneVectorTests
{
    [Fact]
    public void Operations_NearlyParallelVectors_HaveTheBitsOfSingleOnes()
    {
        Random random = new(20120222);
        VectorRow u = VectorRow.OfLength(8);
        VectorRow v = VectorRow.OfLength(8);
        for (int i = 0; i < 8; i++)
        {
            (u.X[i], u.Y[i], u.Z[i]) = (random.NextDouble(), 1e6 * random.NextDouble(), random.NextDouble() - 0.5);
            (v.X[i], v.Y[i], v.Z[i]) = (u.X[i] + (1e-12 * random.NextDouble()), u.Y[i], u.Z[i]);
        }

        VectorRow cross = VectorRow.OfLength(8);
        VectorRow sum = VectorRow.OfLength(8);
        VectorRow difference = VectorRow.OfLength(8);
        LaneVector a = LaneVector.Load(u, 0);
        LaneVector b = LaneVector.Load(v, 0);
        Vector512<double> seven = Vector512.Create(7.0);
        LaneVector.Cross(a, b).Store(cross, 0);
        ((seven * a) + b).Store(sum, 0);
        ((a / seven) - b).Store(difference, 0);

        for (int i = 0; i < 8; i++)
        {
            Assert.Equal(Vector3D.Cross(u[i], v[i]), cross[i]);
            Assert.Equal((7.0 * u[i]) + v[i], sum[i]);
            Assert.Equal((u[i] / 7.0) - v[i], difference[i]);
            Assert.Equal(Vector3D.Dot(u[i], v[i]), LaneVector.Dot(a, b)[i]);
        }
    }
}
