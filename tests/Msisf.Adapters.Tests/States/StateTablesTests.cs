using System.Globalization;
using Msisf.Adapters.States;
using Msisf.Core.Camera;
using Msisf.Core.Camera.Lenses;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Scene;
using Msisf.Core.Time;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.States;

public sealed class StateTablesTests
{
    private static readonly SpacecraftState Straight = new(
        Moments.OfMjd(60328.5), new Vector3D(2e6, 1e5, -3e5), UnitQuaternion.Identity);

    /// <summary>
    /// 2024-01-19T12:00:00Z is 1705665600 s after 1970 (date -d). Of an attitude that turns nothing, right is y, down -z, forward -x.
    /// </summary>
    [Fact]
    public void WriteTum_StraightCamera_HasOpenCvAxes()
    {
        string line = Lines(writer => StateTables.WriteTum(writer, [Straight]))[^1];
        double[] n = [.. line.Split(' ').Select(word => double.Parse(word, CultureInfo.InvariantCulture))];

        Assert.StartsWith("1705665600.000000000 2000000 100000 -300000 ", line);
        UnitQuaternion q = UnitQuaternion.FromComponents(n[4], n[5], n[6], n[7]);
        AssertNear(Vector3D.UnitY, q * Vector3D.UnitX);
        AssertNear(-Vector3D.UnitZ, q * Vector3D.UnitY);
        AssertNear(-Vector3D.UnitX, q * Vector3D.UnitZ);
    }

    [Fact]
    public void WriteEurocStates_SameState_HasTheScalarFirst()
    {
        string[] lines = Lines(writer => StateTables.WriteEurocStates(
            writer, [Straight with { Motion = new CameraMotion(new Vector3D(1.0, 2.0, 3.0), default) }]));
        string[] tum = Lines(writer => StateTables.WriteTum(writer, [Straight]))[^1].Split(' ');
        string[] words = lines[^1].Split(',');

        Assert.Equal("1705665600000000000", words[0]);
        Assert.Equal([tum[7], tum[4], tum[5], tum[6], "1", "2", "3"], words[4..]);
        Assert.EndsWith("q_RS_w [],q_RS_x [],q_RS_y [],q_RS_z [],v_RS_R_x [m s^-1],v_RS_R_y [m s^-1],v_RS_R_z [m s^-1]", lines[0]);
    }

    /// <summary>A point's pixel by COLMAP's files, computed as COLMAP does, is the one that msis shows, whose first centre is 1.</summary>
    [Fact]
    public void WriteColmap_PointOffTheAxis_IsAtItsPixel()
    {
        CameraModel model = new(640, 480, (600.0, 610.0), (300.25, 260.5), 0.0, new OpenCvDistortion([0.05, -0.01], [1e-3, -2e-3]));
        UnitQuaternion attitude = UnitQuaternion.FromAxisAngle(new Vector3D(1.0, 2.0, 3.0), 0.3);
        SpacecraftState state = Straight with { MoonFromCamera = attitude };
        Vector3D point = state.PositionBodyFixed + (attitude * new Vector3D(-1e5, 2e4, 1.5e4));
        Assert.True(model.At(new CameraState(state.PositionBodyFixed, attitude)).TryProjectPoint(point, out RenderingPoint seen));

        string[] camera = Lines(writer => CameraTables.WriteColmapCameras(writer, [model]))[^1].Split(' ');
        string[] lines = Lines(writer => CameraTables.WriteColmapImages(writer, [([state], ["frame"])]));
        double[] pose = [.. lines[^2].Split(' ')[1..8].Select(Number)];
        double[] k = [.. camera[4..].Select(Number)];
        Vector3D inCamera = (UnitQuaternion.FromComponents(pose[1], pose[2], pose[3], pose[0]) * point)
            + new Vector3D(pose[4], pose[5], pose[6]);
        (double x, double y) = (inCamera.X / inCamera.Z, inCamera.Y / inCamera.Z);
        double r2 = (x * x) + (y * y);
        double radial = 1.0 + (k[4] * r2) + (k[5] * r2 * r2);
        double u = (k[0] * ((x * radial) + (2.0 * k[6] * x * y) + (k[7] * (r2 + (2.0 * x * x))))) + k[2];
        double v = (k[1] * ((y * radial) + (2.0 * k[7] * x * y) + (k[6] * (r2 + (2.0 * y * y))))) + k[3];

        Assert.Equal("OPENCV", camera[1]);
        Assert.Equal("1 frame.png", string.Join(' ', lines[^2].Split(' ')[8..]));
        Assert.Equal(seen.X - 0.5, u, Rounding.OfPlaces);
        Assert.Equal(seen.Y - 0.5, v, Rounding.OfPlaces);
    }

    [Fact]
    public void WriteColmap_LensThatItHasNoModelOf_SaysSo()
    {
        CameraModel model = new(640, 480, (600.0, 600.0), (320.5, 240.5), 0.0, new OpenCvDistortion([0.1], [0.0, 0.0], [0.01]));

        Assert.Equal(
            "COLMAP has no camera with the distortion 'opencv' of this camera file. Remove it, or choose another --format.",
            Assert.Throws<BadInputException>(() => CameraTables.WriteColmapCameras(TextWriter.Null, [model])).Message);
    }

    [Theory]
    [InlineData(60328.0, "2024-01-19T00:00:00.000000000")]
    [InlineData(60328.99999999999, "2024-01-19T23:59:59.999999136")]
    public void Calendar_Time_HasNanoseconds(double mjd, string expected) =>
        Assert.Equal(expected, StateTables.Calendar(Moments.OfMjd(mjd)));

    private static double Number(string word) => double.Parse(word, CultureInfo.InvariantCulture);

    private static string[] Lines(Action<TextWriter> write)
    {
        using StringWriter writer = new(CultureInfo.InvariantCulture) { NewLine = "\n" };
        write(writer);
        return writer.ToString()[..^1].Split('\n');
    }

    private static void AssertNear(Vector3D expected, Vector3D actual) => Assert.InRange((expected - actual).Length, 0.0, Rounding.OfUnits);
}
