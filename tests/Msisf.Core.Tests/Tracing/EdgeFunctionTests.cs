using System.Numerics;
using Msisf.Core.Numerics;
using Msisf.Core.Tracing;
using Xunit;

namespace Msisf.Core.Tests.Tracing;

public sealed class EdgeFunctionTests
{
    /// <summary>Rays through or a few steps beside points of an edge, judged by whole numbers of any length.</summary>
    [Fact]
    public void Of_RaysBesideAnEdge_SignIsThatOfTheExactDeterminant()
    {
        Random random = new(20120222);
        int zeros = 0;
        for (int number = 0; number < 20_000; number++)
        {
            long[] a = Whole(random, 1L << 27);
            long[] b = [.. a.Zip(Whole(random, 1L << (4 + (number % 16))), (x, y) => x + y)];
            long[] origin = Whole(random, 1L << (20 + (number % 18)));
            int part = random.Next(0, 3);
            long[] aim = [.. a.Zip(b, (x, y) => ((2 - part) * x) + (part * y))]; // twice a point of the edge
            long[] direction = [.. aim.Zip(origin, (x, y) => x - (2 * y) + random.Next(-(number % 3), 1 + (number % 3)))];
            int expected = Determinant(origin, direction, a, b).Sign;
            zeros += expected == 0 ? 1 : 0;

            EdgeFunction edge = new(Metres(origin), Metres(direction));
            Assert.Equal(expected, Math.Sign(edge.Of(Metres(a), Metres(b))));
            Assert.Equal(-expected, Math.Sign(edge.Of(Metres(b), Metres(a))));
        }

        Assert.InRange(zeros, 5000, 15_000);
    }

    private static long[] Whole(Random random, long limit) =>
        [random.NextInt64(-limit, limit), random.NextInt64(-limit, limit), random.NextInt64(-limit, limit)];

    private static Vector3D Metres(long[] steps) => new(steps[0] / 128.0, steps[1] / 128.0, steps[2] / 128.0);

    /// <summary>det(direction, b - origin, a - origin).</summary>
    private static BigInteger Determinant(long[] origin, long[] direction, long[] a, long[] b)
    {
        BigInteger[] d = [.. direction.Select(x => (BigInteger)x)];
        BigInteger[] u = [.. b.Zip(origin, (x, y) => (BigInteger)x - y)];
        BigInteger[] v = [.. a.Zip(origin, (x, y) => (BigInteger)x - y)];
        return (d[0] * ((u[1] * v[2]) - (u[2] * v[1]))) + (d[1] * ((u[2] * v[0]) - (u[0] * v[2])))
            + (d[2] * ((u[0] * v[1]) - (u[1] * v[0])));
    }
}
