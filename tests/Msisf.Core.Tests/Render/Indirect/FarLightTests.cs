using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Render.Indirect;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Surface;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Render.Indirect;

/// <summary>Light of far ground by a part of its points, against all of them one by one, with the exact tracer's sight.</summary>
public sealed class FarLightTests
{
    private const double Albedo = 0.3;
    private const int Side = 24;

    /// <summary>rad: of a pixel, seen from the body's centre.</summary>
    private const double Pixel = 4e-3;

    private static readonly Vector3D Up = new(
        Math.Cos(0.5) * Math.Cos(1.3), Math.Cos(0.5) * Math.Sin(1.3), -Math.Sin(0.5));

    /// <summary>
    /// What pixels far apart see is not what others see; both sums together are right all the same, whatever is chosen. Both laws, with
    /// smooth normals that differ from facets.
    /// </summary>
    [Theory]
    [InlineData(false, false)]
    [InlineData(true, false)]
    [InlineData(true, true)]
    public void AddSharedAndOther_RoughGround_IsAsAllPointsOneByOne(bool isShared, bool isLommelSeeliger)
    {
        IReflectance law = isLommelSeeliger ? new LommelSeeligerReflectance(Albedo) : new LambertReflectance(Albedo);
        NativeRenderOptions options = new() { Reflectance = law };
        (TerrainTracer tracer, GroundTree tree, GroundLights lights, PinholeCamera camera) = Scene(options);
        Ground image = new(tracer);
        SharedSight? shared = isShared ? SharedSight.Find(image, tree, lights, 2, default) : null;
        LightGather gather = new(tree, lights, camera, options);
        (int square, int seen, int hidden) = (5, 0, 0);
        for (int pixel = 0; pixel < 64; pixel++)
        {
            SurfaceHit hit = image.At(square + (pixel % 8), square + (pixel / 8));
            Vector3D normal = (hit.NormalBodyFixed + (0.1 * Up)).Normalized();
            Vector3D toCamera = (camera.PositionBodyFixed - hit.PointBodyFixed).Normalized();
            gather.Group.Add(hit.PointBodyFixed, hit.NormalBodyFixed, normal, toCamera, lights.ReachOfView, pixel);
        }

        gather.Begin(shared);
        GatheredLight found = new(isIrradiance: false);
        gather.Far.AddShared(400_000, 1, found);
        gather.Far.AddOther(400_000, 2, found);

        List<double> differences = [];
        for (int receiver = 0; receiver < 64; receiver += 11)
        {
            double expected = 0.0;
            for (int i = 0; i < lights.Count; i++)
            {
                Vector3D way = lights.Points[i] - gather.Group.Points[receiver];
                Vector3D direction = way.Normalized();
                double received = Vector3D.Dot(direction, gather.Group.Normals[receiver]);
                double emitted = -Vector3D.Dot(direction, lights.Normals[i]);
                if (lights.FromSun[i] <= 0.0 || received <= 0.0 || emitted <= 0.0 || way.Length < lights.ReachOfView
                    || Vector3D.Dot(direction, gather.Group.Facets[receiver]) <= 0.0)
                {
                    continue;
                }

                bool isHidden = IsHidden(tracer, gather.Group.Points[receiver], way);
                (seen, hidden) = isHidden ? (seen, hidden + 1) : (seen + 1, hidden);
                Vector3D toCamera = gather.Group.ToCamera[receiver];
                double thrown = Factor(law, lights.Normals[i], lights.ToSun[i], -direction);
                double reflected = Factor(law, gather.Group.Normals[receiver], direction, toCamera);
                double solidAngle = lights.Areas[i] * emitted / way.LengthSquared;
                expected += isHidden ? 0.0 : lights.FromSun[i] * solidAngle * thrown * reflected / Math.PI;
            }

            differences.Add((found.Values[receiver] / expected) - 1.0);
        }

        Assert.InRange(seen, 200, int.MaxValue);
        Assert.InRange(hidden, 200, int.MaxValue);
        Assert.All(differences, difference => Assert.InRange(difference, -OfChoices, OfChoices));
        Assert.InRange(differences.Average(), -OfChoices / 3.0, OfChoices / 3.0);
    }

    /// <summary>
    /// At the pixels that look at all points, what they see; in the middle of four, what most of these see that face a point, and whether
    /// they agree.
    /// </summary>
    [Fact]
    public void Mix_InAndBetweenItsPixels_IsAsTheTracer()
    {
        (TerrainTracer tracer, GroundTree tree, GroundLights lights, _) = Scene(new() { Reflectance = new LambertReflectance(Albedo) });
        Ground image = new(tracer);
        SharedSight shared = SharedSight.Find(image, tree, lights, 2, default);
        int padded = lights.Bright.PaddedLength;
        (int X, int Y)[] pixels = [(8, 0), (16, 0), (8, 8), (16, 8)];
        SurfaceHit[] corners = [.. pixels.Select(pixel => image.At(pixel.X, pixel.Y))];
        (float[] Seen, float[] IsUnsure) middle = MixAt(12.0, 4.0);
        (float[] Seen, float[] IsUnsure)[] single = [.. pixels.Select(pixel => MixAt(pixel.X, pixel.Y))];
        (int visible, int hidden, int mixed) = (0, 0, 0);
        for (int i = 0; i < lights.Bright.Length; i += 5)
        {
            int light = lights.Bright[i];
            bool?[] sees = [.. corners.Select(corner =>
            {
                Vector3D way = lights.Points[light] - corner.PointBodyFixed;
                bool isFacing = Vector3D.Dot(way, corner.NormalBodyFixed) > 0.0 && Vector3D.Dot(way, lights.Normals[light]) < 0.0
                    && way.Length >= lights.ReachOfView;
                return isFacing ? !IsHidden(tracer, corner.PointBodyFixed, way) : (bool?)null;
            })];
            (int known, int open) = (sees.Count(one => one is not null), sees.Count(one => one is true));
            (visible, hidden, mixed) = (visible + open, hidden + known - open, mixed + (open > 0 && open < known ? 1 : 0));
            Assert.Equal(known == 0 ? 0.0f : (float)open / known, middle.Seen[i], 1e-6f);
            Assert.Equal(known == 0 || (open > 0 && open < known) ? 1.0f : 0.0f, middle.IsUnsure[i]);
            for (int pixel = 0; pixel < pixels.Length; pixel++)
            {
                Assert.Equal(sees[pixel] is true ? 1.0f : 0.0f, single[pixel].Seen[i]);
                Assert.Equal(sees[pixel] is null ? 1.0f : 0.0f, single[pixel].IsUnsure[i]);
            }
        }

        Assert.InRange(visible, 20, int.MaxValue);
        Assert.InRange(hidden, 20, int.MaxValue);
        Assert.InRange(mixed, 20, int.MaxValue);

        (float[] Seen, float[] IsUnsure) MixAt(double x, double y)
        {
            (float[] Seen, float[] IsUnsure) mixed = (new float[padded], new float[padded]);
            shared.Mix(x, y, mixed.Seen, mixed.IsUnsure);
            return mixed;
        }
    }

    private static (TerrainTracer Tracer, GroundTree Tree, GroundLights Lights, PinholeCamera Camera) Scene(NativeRenderOptions options)
    {
        FunctionGrid terrain = FunctionGrid.Rugged(4);
        GroundTree tree = new(SurfaceModel.Of(terrain), Up);
        double field = 2.0 * Math.Atan(Side * Pixel * 0.5 * 1_737_400.0 / 762_600.0);
        PinholeCamera camera = new(2_500_000.0 * Up, CameraCases.Attitude(-Up, Vector3D.UnitZ), field, Side, Side);
        Vector3D sun = 1.5e11 * (Up + (3.0 * Vector3D.Cross(Vector3D.UnitZ, Up))).Normalized();
        GroundLights lights = GroundPlacing.Place(tree, (Up, 0.5 * Side * Pixel), [sun], 192, 2, default);
        new GroundBounces(tree, lights, camera, options).Start(2, default);
        return (new TerrainTracer(terrain), tree, lights, camera);
    }

    /// <summary>Whether ground lies on a way, but for its last centimetre.</summary>
    private static bool IsHidden(TerrainTracer tracer, Vector3D from, Vector3D way) =>
        tracer.TryTrace(new Ray(from, way.Normalized()), out SurfaceHit hit) && hit.RayParameter < way.Length - 0.01;

    /// <summary>Part of the light that 400,000 choices leave unsure on a point with little of it.</summary>
    private const double OfChoices = 0.03;

    private static double Factor(IReflectance law, Vector3D normal, Vector3D toLight, Vector3D toViewer) => law.RadianceFactor(
        Math.Min(1.0, Vector3D.Dot(normal, toLight)), Math.Min(1.0, Vector3D.Dot(normal, toViewer)),
        0.5 * (1.0 - Vector3D.Dot(toLight, toViewer)));

    /// <summary>Pixels that look down.</summary>
    private sealed class Ground(TerrainTracer tracer) : ISurfaceRows
    {
        private static readonly Vector3D Right = Vector3D.Cross(Vector3D.UnitZ, Up).Normalized();

        public int Width => Side;

        public int Height => Side;

        public ImageView View => throw new NotSupportedException();

        public SurfaceHit At(int x, int y)
        {
            Vector3D down = Vector3D.Cross(Right, Up);
            Vector3D place = Up + (Pixel * (x - (0.5 * (Side - 1))) * Right) + (Pixel * (y - (0.5 * (Side - 1))) * down);
            Assert.True(tracer.TryTrace(new Ray(1_800_000.0 * place.Normalized(), -place.Normalized()), out SurfaceHit hit));
            return hit;
        }

        public void Read(int y, SurfaceRow row)
        {
            row.EnsureWidth(Side);
            row.Count = Side;
            for (int i = 0; i < Side; i++)
            {
                SurfaceHit hit = At(i, y - 1);
                row.Columns[i] = i;
                (row.X[i], row.Y[i], row.Z[i]) = (hit.PointBodyFixed.X, hit.PointBodyFixed.Y, hit.PointBodyFixed.Z);
                (row.NormalX[i], row.NormalY[i], row.NormalZ[i]) = (hit.NormalBodyFixed.X, hit.NormalBodyFixed.Y, hit.NormalBodyFixed.Z);
            }
        }

        public void ReadPoints(int y, ReadOnlySpan<int> columns, SurfaceRow row) => throw new NotSupportedException();

        public FacetId FacetOf(int y, int number) => throw new NotSupportedException();
    }
}
