using Msisf.Core.Camera;
using Msisf.Core.Metadata;
using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.Core.Scene;
using Msisf.Core.Time;
using Msisf.Core.Tracing;
using Msisf.TestSupport;

namespace Msisf.Integration.Tests.Metadata;

/// <summary>The example of thesis section 9.2 at any size.</summary>
internal static class ExampleFrame
{
    public static FrameMetadata OfSize(int width, int height)
    {
        UnitQuaternion orientation = UnitQuaternion.FromComponents(
            -2.391176183943345e-001, +9.904576054128762e-002, +3.696438106143861e-001, +8.923991008325228e-001);
        return new FrameMetadata(
            Moments.OfMjd(55289.0),
            new PinholeCamera(new Vector3D(2e6, 2e6, 0.0), orientation, double.DegreesToRadians(40.0), width, height),
            40.0,
            new Vector3D(+1.074955473280880E+011, -1.042430734878980E+011, +4.036164305561260E+009),
            new DrawnElevation("LDEM_64", IsSynthetic: false, 64, 16, 2),
            1092583.25,
            "1.0.0",
            "--fixed-state {55289,2E6} --output-dir \"<a> & b\"",
            RendererKind.PovRay,
            [
                new InputFile(InputKind.ElevationImage, "\"a\" <b> & 'c'.IMG", 34_000_000_000, new string('0', 64)) { IsOfPieces = true },
                new InputFile(InputKind.Kernel, "d.bsp", 1, new string('1', 64)),
            ]);
    }

    public static PixelSampler Sampler(FrameMetadata frame, int spacing) =>
        new(
            frame.Camera,
            new PixelGrid(frame.Camera.Width, frame.Camera.Height, spacing, spacing),
            ReferenceSphere.Lola,
            new SceneLight(frame.SunPositionBodyFixed, IsSun: true));

    /// <summary>Terrain that happens to be the sphere, with each state of light.</summary>
    public static PixelSampler TerrainSampler(FrameMetadata frame, int spacing) => new(
        new PixelGrid(frame.Camera.Width, frame.Camera.Height, spacing, spacing),
        FunctionTruth.OfSphere(frame.Camera, frame.SunPositionBodyFixed),
        pixelsPerDegree: 4);
}
