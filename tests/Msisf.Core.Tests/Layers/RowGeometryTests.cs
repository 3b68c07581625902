using Msisf.Core.Camera;
using Msisf.Core.Layers;
using Msisf.Core.Numerics;
using Msisf.Core.Tests.Support;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Layers;

public sealed class RowGeometryTests
{
    private static readonly Vector3D Position = new(1.9e6, 2e5, -3e5);

    private static readonly UnitQuaternion Orientation = UnitQuaternion.FromComponents(0.1, 0.7, -0.1, 0.7);

    public static TheoryData<string> Cameras => ["thesis", "pinhole", "lens"];

    [Theory]
    [MemberData(nameof(Cameras))]
    public void FindDirections_SomePixelsOfARow_AreTheirRays(string kind)
    {
        PinholeCamera camera = kind switch
        {
            "thesis" => new PinholeCamera(Position, Orientation, 0.7, 60, 41),
            "pinhole" => new PinholeCamera(Position, Orientation, LensCases.Of("principal-point", 0.3, 60, 41)),
            _ => new PinholeCamera(Position, Orientation, LensCases.Of("barrel", 0.3, 60, 41)),
        };
        int[] columns = [0, 1, 2, 5, 6, 7, 8, 9, 30, 58, 59];
        VectorRow directions = VectorRow.OfLength(columns.Length + 8);

        RowGeometry.FindDirections(camera, 17, columns, directions);

        for (int i = 0; i < columns.Length; i++)
        {
            Assert.Equal(camera.RayThrough(columns[i] + 1, 18).Direction, directions[i]);
        }
    }

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
