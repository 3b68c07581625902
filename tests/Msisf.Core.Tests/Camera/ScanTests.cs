using Msisf.Core.Camera;
using Msisf.Core.Camera.Lenses;
using Msisf.Core.Numerics;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Camera;

/// <summary>Which row of the image is seen by which row of the camera, when and from where.</summary>
public sealed class ScanTests
{
    private static readonly CameraModel Model = new(
        9, 5, (40.0, 43.0), (4.2, 2.4), skew: 0.7, new OpenCvDistortion([-0.1, 0.02], [0.001, 0.002]));

    [Fact]
    public void CameraOf_LineScan_SeesTheMiddleOfTheRowsAtEachTime()
    {
        Scan scan = new(ScanKind.LineScan, 4, 0.25) { Stages = 5 };
        ICamera image = scan.CameraOf(Model, States(4));

        Assert.Equal((9, 4), (image.Width, image.Height));
        Assert.Equal([0.0, 0.25, 0.5, 0.75], Enumerable.Range(0, 4).Select(scan.SecondsOf));
        for (int line = 1; line <= 4; line++)
        {
            AssertSees(image, line, State(line - 1), rowOfModel: 3.0);
        }
    }

    [Theory]
    [InlineData(true, 1.0)]
    [InlineData(false, -1.0)]
    public void LineOf_StagesOfTdi_AreTheRowsInTheOrderOfTheCharge(bool movesDown, double sign)
    {
        Scan scan = new(ScanKind.LineScan, 1, 0.5) { Stages = 5, ChargeMovesDown = movesDown };
        for (int stage = 0; stage < 5; stage++)
        {
            (double below, double seconds) = scan.Stage(stage);
            Assert.Equal(0.5 * (stage - 2), seconds);
            AssertSees(Scan.LineOf(Model, below).At(State(0)), 1, State(0), 3.0 + (sign * (stage - 2)));
        }
    }

    [Theory]
    [InlineData(false, false, new[] { 2, 3, 4, 2, 3, 4 }, new[] { 0, 0, 0, 1, 1, 1 })]
    [InlineData(true, false, new[] { 2, 3, 4, 2, 3, 4 }, new[] { 1, 1, 1, 0, 0, 0 })]
    [InlineData(false, true, new[] { 4, 3, 2, 4, 3, 2 }, new[] { 0, 0, 0, 1, 1, 1 })]
    [InlineData(true, true, new[] { 4, 3, 2, 4, 3, 2 }, new[] { 1, 1, 1, 0, 0, 0 })]
    public void CameraOf_PushFrame_StacksFramelets(bool up, bool flips, int[] rows, int[] exposures)
    {
        Scan scan = new(ScanKind.PushFrame, 2, 1.0) { Framelet = new PixelRows(1, 4), GrowsUpwards = up, FlipsFramelets = flips };
        ICamera image = scan.CameraOf(Model, States(2));

        Assert.Equal(6, scan.HeightOf(Model));
        Assert.Equal(6, image.Height);
        for (int y = 1; y <= 6; y++)
        {
            AssertSees(image, y, State(exposures[y - 1]), rows[y - 1]);
        }
    }

    [Fact]
    public void CameraOf_RollingShutter_SeesEachRowAtItsTime()
    {
        Scan scan = new(ScanKind.RollingShutter, 5, 1.0);
        ICamera image = scan.CameraOf(Model, States(5));

        for (int y = 1; y <= 5; y++)
        {
            AssertSees(image, y, State(y - 1), y);
        }
    }

    private static void AssertSees(ICamera image, int y, CameraState state, double rowOfModel)
    {
        FrameCamera still = Model.At(state);
        for (int x = 1; x <= 9; x++)
        {
            Ray ray = image.RayThrough(x, y);
            Assert.Equal(state.PositionBodyFixed, ray.Origin);
            Assert.InRange(Vector3D.AngleBetween(still.RayThrough(x, rowOfModel).Direction, ray.Direction), 0.0, Rounding.OfTurns);
        }
    }

    private static CameraState[] States(int count) => [.. Enumerable.Range(0, count).Select(State)];

    private static CameraState State(int exposure) => new(
        new Vector3D(1.9e6, 100.0 * exposure, 30.0), UnitQuaternion.FromAxisAngle(new Vector3D(1.0, 2.0, 3.0), 0.1 + (0.01 * exposure)));
}
