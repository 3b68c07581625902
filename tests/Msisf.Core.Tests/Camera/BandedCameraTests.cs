using Msisf.Core.Camera;
using Msisf.Core.Detector;
using Msisf.Core.Numerics;
using Msisf.Core.Tests.Support;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Camera;

public sealed class BandedCameraTests
{
    private static readonly CameraState First = new(new Vector3D(2e6, 0.0, 0.0), UnitQuaternion.Identity);

    private static readonly CameraMotion Motion = new(new Vector3D(0.0, 1600.0, 10.0), new Vector3D(0.01, 0.0, 0.02));

    private static readonly CameraModel Model = LensCases.Of("barrel", 0.3, 40, 31);

    /// <summary>The state of row y, from 1: two rows have each.</summary>
    private static CameraState StateOf(int y) => Motion.Moved(First, 0.1 * ((y - 1) / 2));

    private static ICamera Camera { get; } = BandedCamera.Of(Model, [.. Enumerable.Range(1, 31).Select(StateOf)]);

    [Fact]
    public void Of_StatesThatAreAllTheSame_IsTheFrameCamera()
    {
        ICamera camera = BandedCamera.Of(Model, [.. Enumerable.Repeat(First, 31)]);

        Assert.Same(Model, Assert.IsAssignableFrom<FrameCamera>(camera).Model);
        Assert.Equal(First, camera.State);
    }

    [Fact]
    public void Of_BandsOfSeveralWidths_IsACallersBug() => Assert.Throws<ArgumentException>(
        () => BandedCamera.Of([Model.At(First), LensCases.Of("barrel", 0.3, 41, 31).At(First)]));

    [Theory]
    [InlineData(-3.0, 1)]
    [InlineData(0.5, 1)]
    [InlineData(2.49, 2)]
    [InlineData(2.5, 3)]
    [InlineData(30.0, 30)]
    [InlineData(31.4, 31)]
    [InlineData(99.0, 31)]
    public void BandAt_AnyRow_HasItsState(double y, int row) => Assert.Equal(StateOf(row), Camera.BandAt(y).Camera.State);

    [Fact]
    public void RayThrough_AnyPoint_IsTheRayOfTheWholeImageInTheRowsState()
    {
        foreach ((double x, double y) in ((double, double)[])[(1.0, 1.0), (40.0, 31.0), (17.3, 8.6), (-2.0, -1.0), (20.0, 16.4)])
        {
            Ray expected = Model.At(StateOf(Math.Clamp((int)Math.Round(y), 1, 31))).RayThrough(x, y);
            Ray ray = Camera.RayThrough(x, y);
            Assert.Equal(expected.Origin, ray.Origin);
            Assert.InRange(Vector3D.AngleBetween(expected.Direction, ray.Direction), 0.0, 1e-15); // some last digits of 1
        }
    }

    [Theory]
    [InlineData(3.0, 4.2)]
    [InlineData(40.0, 31.0)]
    [InlineData(1.0, 16.0)]
    [InlineData(20.0, -5.0)] // above the image: the first row's state goes on
    public void TryProjectPoint_PointOnARay_IsWhereTheRayBegan(double x, double y)
    {
        Ray ray = Camera.RayThrough(x, y);
        Assert.True(Camera.TryProjectPoint(ray.Origin + (3e5 * ray.Direction.Normalized()), out RenderingPoint point));

        // While the camera turns, neighbouring rows see the same point too, as near to their own middles.
        Assert.Equal(x, point.X, 0.2);
        Assert.Equal(y, point.Y, 1.0);
        Ray back = Camera.RayThrough(point.X, point.Y);
        Vector3D from = ray.Origin + (3e5 * ray.Direction.Normalized()) - back.Origin;
        Assert.InRange(Vector3D.AngleBetween(from, back.Direction), 0.0, y < 1.0 ? 1e-12 : 0.02);
        Assert.False(Camera.TryProjectPoint(ray.Origin - (1e6 * ray.Direction), out _));
    }

    /// <summary>A scan that runs up shows what lies further up in lower rows; beyond its first and last row nothing is seen.</summary>
    [Theory]
    [InlineData(-1.0)] // down, as the rows of a frame
    [InlineData(1.0)]
    public void TryProjectPoint_BeyondTheRows_IsOutsideOfTheImage(double up)
    {
        Vector3D step = new(0.0, 0.0, up * 9e3); // m from row to row, wider than the 7.6 km that a row sees at 300 km
        ICamera scan = BandedCamera.Of(
            Model, [.. Enumerable.Range(0, 31).Select(row => First with { PositionBodyFixed = First.PositionBodyFixed + (row * step) })]);
        foreach ((double row, double beyond) in ((double, double)[])[(1.0, -5.0), (31.0, 5.0)])
        {
            Ray ray = scan.RayThrough(17.0, row);
            Vector3D seen = ray.Origin + (3e5 * ray.Direction.Normalized());

            Assert.True(scan.TryProjectPoint(seen, out RenderingPoint inside));
            Assert.Equal(row, inside.Y, 0.5);
            Assert.True(scan.TryProjectPoint(seen + (beyond * step), out RenderingPoint outside));
            Assert.True(row < 2.0 ? outside.Y < 0.5 : outside.Y > 31.5, $"{row}: {outside}");
        }
    }

    [Theory]
    [InlineData(0, 0, 40, 31)]
    [InlineData(5, 7, 20, 12)]
    [InlineData(-3, -2, 46, 35)]
    public void Window_AnyPixel_SeesWhatItSeesInTheWhole(int left, int top, int width, int height)
    {
        ICamera window = Camera.Window(left, top, width, height);
        Assert.Equal((width, height), (window.Width, window.Height));
        foreach ((int x, int y) in ((int, int)[])[(1, 1), (width, height), (9, 5), (12, 12)])
        {
            Ray expected = Camera.RayThrough(x + left, y + top);
            Ray ray = window.RayThrough(x, y);
            Assert.Equal(expected.Origin, ray.Origin);
            Assert.InRange(Vector3D.AngleBetween(expected.Direction, ray.Direction), 0.0, Rounding.OfChains);
        }
    }

    [Fact]
    public void Moved_SomeSeconds_MovesEachRow()
    {
        ICamera moved = Camera.Moved(Motion, 0.1);
        for (int y = 1; y <= 29; y++)
        {
            CameraState expected = StateOf(y + 2);
            CameraState state = moved.BandAt(y).Camera.State;
            // Some last digits of seconds below 1, of positions of 2e6 m, and of 1.
            Assert.Equal(expected.Seconds, state.Seconds, 1e-15);
            Assert.Equal(0.0, (expected.PositionBodyFixed - state.PositionBodyFixed).Length, Rounding.OfPlaces);
            Assert.Equal(
                0.0, ((expected.MoonFromCamera * Vector3D.UnitY) - (state.MoonFromCamera * Vector3D.UnitY)).Length, Rounding.OfUnits);
        }
    }

    [Fact]
    public void Bounds_OfSomeRows_AreThoseOfTheirBands()
    {
        ViewFrustum[] bounds = [.. Camera.Bounds(0.5, new PixelRows(3, 6))]; // rows 4 of the second band, 5 and 6 of the third
        Assert.Equal(2, bounds.Length);
        Assert.Equal([StateOf(4).PositionBodyFixed, StateOf(5).PositionBodyFixed], bounds.Select(frustum => frustum.CameraBodyFixed));
    }

    [Fact]
    public void Throughput_OfRows_IsThatOfTheFrame()
    {
        double[] rows = PixelThroughput.Of(Camera, isFlatFielded: false, threads: 2);
        double[] whole = PixelThroughput.Of(Model.At(First), isFlatFielded: false, threads: 1);

        Assert.All(rows.Zip(whole), pixel => Assert.Equal(1.0, pixel.First / pixel.Second, Rounding.OfPlaces));
    }
}
