using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Tests.Support;
using Xunit;

namespace Msisf.Core.Tests.Camera;

public sealed class FrameCameraTests
{
    private static readonly CameraState State =
        new(new Vector3D(1.9e6, 2e5, -3e5), UnitQuaternion.FromComponents(0.1, 0.7, -0.1, 0.7));

    public static TheoryData<string> Cameras => ["thesis", "pinhole", "lens"];

    [Theory]
    [MemberData(nameof(Cameras))]
    public void FindDirections_SomePixelsOfARow_AreTheirRays(string kind)
    {
        FrameCamera camera = kind switch
        {
            "thesis" => CameraModel.FromFieldOfView(0.7, 60, 41).At(State),
            "pinhole" => LensCases.Of("principal-point", 0.3, 60, 41).At(State),
            _ => LensCases.Of("barrel", 0.3, 60, 41).At(State),
        };
        int[] columns = [0, 1, 2, 5, 6, 7, 8, 9, 30, 58, 59];
        VectorRow directions = VectorRow.OfLength(columns.Length + 8);

        camera.FindDirections(17, columns, directions);

        for (int i = 0; i < columns.Length; i++)
        {
            Assert.Equal(camera.RayThrough(columns[i] + 1, 18).Direction, directions[i]);
        }
    }
}
