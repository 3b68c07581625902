using Msisf.Core.Numerics;
using Msisf.Core.Render.Shadows;
using Msisf.Core.Render.Surface;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Render.Shadows;

public sealed class ShadowPassTests(Ldem4Fixture ldem4) : IClassFixture<Ldem4Fixture>
{
    private const double SunDistance = 1.496e11; // m

    [RequiresTheory(Part.Ldem4)]
    [InlineData(1)]
    public void Run_Ldem4_IsWhatBruteForceSays(int seed)
    {
        AssertSameAsBruteForce(ldem4.Grid, ldem4.Moon, new Vector3D(0.3, 0.8, 0.1).Normalized(), 0.15, 20000, seed);
    }

    [Theory]
    [InlineData(1.0, 0.0, 0.0, 20.0)]
    [InlineData(0.0, 0.0, 1.0, 5.0)]
    [InlineData(0.0, 0.0, -1.0, 5.0)]
    [InlineData(0.3, 0.8, 0.1, 180.0)]
    public void Run_RuggedMoon_IsWhatBruteForceSays(double x, double y, double z, double radiusDegrees)
    {
        RuggedMoon rugged = new();
        AssertSameAsBruteForce(rugged.Grid, rugged.Moon, new Vector3D(x, y, z).Normalized(), radiusDegrees * Math.PI / 180.0, 20000, 7);
    }

    private static void AssertSameAsBruteForce(
        IElevationGrid grid, BruteForceMoon moon, Vector3D middle, double radius, int count, int seed)
    {
        Random random = new(seed);
        for (int elevation = -10; elevation <= 50; elevation += 5)
        {
            Vector3D side = Vector3D.Cross(middle, new Vector3D(random.NextDouble(), 0.3, 1.0 - (2.0 * random.NextDouble()))).Normalized();
            (double sin, double cos) = Math.SinCos(elevation * Math.PI / 180.0);
            Vector3D sun = SunDistance * ((sin * middle) + (cos * side));
            (List<Vector3D> points, List<bool> expected) = RandomPoints(moon, middle, radius, sun, count / 13, random);
            ShadowPass pass = new(new SurfaceModel(grid), 1_720_000.0, 1_775_000.0);
            byte[] hidden = new byte[points.Count + 100];
            pass.Run(new PointReceivers(points, 100), sun, hidden, 2, default);
            int different = 0;
            for (int i = 0; i < points.Count; i++)
            {
                different += (hidden[i] != 0) != expected[i] ? 1 : 0;
            }

            Assert.True(different == 0, $"{different} of {points.Count} differ at {elevation}; hidden {expected.Count(x => x)} {pass.Statistics}");
        }
    }

    private static (List<Vector3D> Points, List<bool> Hidden) RandomPoints(
        BruteForceMoon moon, Vector3D middle, double radius, Vector3D sun, int count, Random random)
    {
        List<Vector3D> points = [];
        List<bool> hidden = [];
        while (points.Count < count)
        {
            Vector3D offset = new(random.NextDouble() - 0.5, random.NextDouble() - 0.5, random.NextDouble() - 0.5);
            Vector3D direction = (middle + (2.0 * Math.Tan(Math.Min(1.5, radius)) * offset)).Normalized();
            (BruteForceMoon.FacetId Facet, double T)? hit = moon.FirstHit(4e6 * direction, -direction);
            Vector3D point = (4e6 - hit!.Value.T) * direction;
            if (Vector3D.Dot(moon.Normal(hit.Value.Facet), sun - point) > 0.0)
            {
                points.Add(point);
                hidden.Add(moon.IsShadowed(hit.Value.Facet, point, sun));
            }
        }

        return (points, hidden);
    }
}
