using Msisf.Core.Camera;
using Msisf.Core.Navigation;
using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Scene;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Navigation;

/// <summary>Flows against single rays from the other camera and to both Suns, and there and back.</summary>
public class FlowFinderTests(Ldem4Fixture ldem4) : IClassFixture<Ldem4Fixture>
{
    private const int Width = 96;
    private const int Height = 72;

    private static readonly NativeRenderOptions Options = new()
    {
        Reflectance = new LambertReflectance(0.64),
        KeepGroundTruth = true,
        Normals = NormalModel.Smooth, // the flow's slopes are those of facets all the same
    };

    /// <summary>How far the other camera is to the side in parts of the height, and the lens; the last one is below peaks.</summary>
    public static TheoryData<string, double, string> Cases => new()
    {
        { "far", 0.3, "" }, { "oblique-20km", 2.0, "barrel" }, { "north-pole", 0.2, "" }, { "limb", 0.5, "" },
        { "nadir-100km", 0.2, "prism" }, { "seam-oblique", 1.0, "" },
    };

    [Theory]
    [MemberData(nameof(Cases))]
    public void Find_EachScene_IsWhatSingleRaysSay(string name, double aside, string lens)
    {
        RenderScenes.RenderSceneCase scene = RenderScenes.Named(name);
        PinholeCamera pinhole = scene.Camera(ldem4.Grid, Width, Height);
        CameraModel model = lens.Length > 0 ? LensCases.Of(lens, Math.Tan(0.5 * pinhole.FieldOfView), Width, Height) : pinhole.Model;
        FrameCamera camera = model.At(pinhole.State);
        double height = camera.PositionBodyFixed.Length - 1_737_400.0;
        Vector3D side = Vector3D.Cross(Vector3D.UnitZ, camera.PositionBodyFixed + new Vector3D(3.0, 4.0, 5.0)).Normalized();
        FrameCamera other = model.At(new CameraState(
            camera.PositionBodyFixed + (aside * Math.Max(height, 3e3) * side), camera.MoonFromCamera * Turn(Vector3D.UnitX, 0.1)));
        SceneLight light = new(scene.Sun, IsSun: true);
        SceneLight otherLight = new(Turn(camera.PositionBodyFixed.Normalized(), 0.4) * scene.Sun, IsSun: true);
        NativeRenderer renderer = new(ldem4.Grid);
        using NativeFrame frame = renderer.Render(camera, light, Options, threads: 2);

        FlowField flow = new FlowFinder(frame, new FrameRedraw(renderer, camera, margin: 0, Options)).Find(
            new FlowTarget(other, otherLight), threads: 2, CancellationToken.None);

        TerrainTracer tracer = new(ldem4.Grid);
        CameraMatrix matrix = CameraMatrix.Of(other);
        int[] classes = new int[4];
        int[] lights = new int[5];
        for (int y = 1; y <= Height; y++)
        {
            for (int x = 1; x <= Width; x++)
            {
                int pixel = ((y - 1) * Width) + x - 1;
                classes[flow.Classes[pixel]]++;
                lights[flow.Lights[pixel]]++;
                if (!tracer.TryTrace(camera.RayThrough(x, y), out SurfaceHit hit))
                {
                    Assert.Equal((0, 0, double.NaN), (flow.Classes[pixel], flow.Lights[pixel], flow.Right[pixel]));
                    continue;
                }

                Vector3D seen = (matrix.Rotation * hit.PointBodyFixed) + matrix.Translation;
                (double u, double v) = (x + flow.Right[pixel], y + flow.Down[pixel]);
                if (seen.Z > 0.0 && lens.Length == 0)
                {
                    double error = 1e-9 + (matrix.FocalLength * 1e-8 / seen.Z);
                    Assert.Equal(Vector3D.Dot(matrix.IntrinsicRows[0], seen) / seen.Z, u - 1.0, error * Math.Max(1.0, Math.Abs(u)));
                    Assert.Equal(Vector3D.Dot(matrix.IntrinsicRows[1], seen) / seen.Z, v - 1.0, error * Math.Max(1.0, Math.Abs(v)));
                }

                FlowClass expected = !(u >= 0.5 && u <= Width + 0.5 && v >= 0.5 && v <= Height + 0.5) ? FlowClass.Outside
                    : tracer.IsHidden(hit.PointBodyFixed, hit.Facet, other.PositionBodyFixed) ? FlowClass.Hidden
                    : FlowClass.Seen;
                Assert.Equal(expected, (FlowClass)flow.Classes[pixel]);
                bool isDark = tracer.IsHidden(hit.PointBodyFixed, hit.Facet, light.PositionBodyFixed);
                bool isDarkThere = tracer.IsHidden(hit.PointBodyFixed, hit.Facet, otherLight.PositionBodyFixed);
                Vector3D source = isDark ? light.PositionBodyFixed : otherLight.PositionBodyFixed;
                FlowLight expectedLight = isDark == isDarkThere ? isDark ? FlowLight.DarkInBoth : FlowLight.LitInBoth
                    : Vector3D.Dot(hit.NormalBodyFixed, source - hit.PointBodyFixed) > 0.0 ? FlowLight.ChangedByShadow
                    : FlowLight.ChangedBySlope;
                Assert.Equal(expectedLight, (FlowLight)flow.Lights[pixel]);
                if (expected == FlowClass.Seen)
                {
                    // And back: what the other camera sees there is seen from this one in the pixel's centre.
                    Assert.True(tracer.TryTrace(other.RayThrough(u, v), out SurfaceHit there));
                    Assert.True(camera.TryProjectPoint(there.PointBodyFixed, out RenderingPoint back));
                    double scale = camera.Model.FocalX * 1e-6 / (hit.PointBodyFixed - camera.PositionBodyFixed).Length;
                    Assert.Equal(x, back.X, 1e-6 + (1e3 * scale));
                    Assert.Equal(y, back.Y, 1e-6 + (1e3 * scale));
                }
            }
        }

        Assert.True(classes[(int)FlowClass.Seen] > 100, $"{name}: {string.Join(' ', classes)}, {string.Join(' ', lights)}");
    }

    /// <summary>A camera to the right: the depth from disparity, focal length times baseline over disparity, is that of the ray.</summary>
    [Fact]
    public void Find_CameraToTheRight_HasTheDisparityOfTheDepth()
    {
        const double baseline = 2000.0;
        PinholeCamera camera = RenderScenes.Named("nadir-100km").Camera(ldem4.Grid, Width, Height);
        SceneLight light = new(RenderScenes.Named("nadir-100km").Sun, IsSun: true);
        NativeRenderer renderer = new(ldem4.Grid);
        using NativeFrame frame = renderer.Render(camera, light, Options, threads: 2);
        FrameCamera right = camera.Model.At(new CameraState(camera.PositionBodyFixed + (baseline * camera.UnitRight),
            camera.MoonFromCamera));

        FlowField flow = new FlowFinder(frame, new FrameRedraw(renderer, camera, margin: 0, Options)).Find(
            new FlowTarget(right, light), threads: 1, CancellationToken.None);

        for (int pixel = 0; pixel < Width * Height; pixel++)
        {
            Assert.True(frame.TryGet((pixel % Width) + 1, (pixel / Width) + 1, out SurfaceHit hit, out _));
            double depth = Vector3D.Dot(hit.PointBodyFixed - camera.PositionBodyFixed, camera.ForwardBodyFixed);
            // flow is a difference of pixels, which have 1e-9
            Assert.Equal(depth, camera.Model.FocalX * baseline / -flow.Right[pixel], 1e-6 * depth);
            Assert.Equal(0.0, flow.Down[pixel], Rounding.OfPlaces);
            Assert.NotEqual((byte)FlowLight.ChangedByShadow, flow.Lights[pixel]);
        }
    }

    private static UnitQuaternion Turn(Vector3D axis, double angle)
    {
        (double sin, double cos) = Math.SinCos(0.5 * angle);
        return UnitQuaternion.FromComponents(sin * axis.X, sin * axis.Y, sin * axis.Z, cos);
    }
}
