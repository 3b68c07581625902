using Msisf.Core.Camera;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Camera;

/// <summary>Order and signs of the turns, by what the camera then sees, and the angles at each time.</summary>
public sealed class JitterTests
{
    private const double Turn = 0.01;

    private static readonly CameraModel Model = new(101, 101, (500.0, 500.0), (51.0, 51.0));

    /// <summary>x right, y down: where a point that lay at (61, 41), to the right and above the middle, goes.</summary>
    [Theory]
    [InlineData(JitterAxis.Roll, -1.0, 0.0)]
    [InlineData(JitterAxis.Pitch, 0.0, 1.0)]
    [InlineData(JitterAxis.Yaw, -1.0, -1.0)]
    public void Turn_AboutAnAxis_MovesWhatIsSeen(JitterAxis axis, double right, double down)
    {
        CameraState state = new(new Vector3D(1.9e6, 0.0, 0.0), UnitQuaternion.Identity);
        FrameCamera still = Model.At(state);
        Ray ray = still.RayThrough(61.0, 41.0);
        Jitter jitter = new([new JitterSine(axis, 0.0, Turn, 0.5 * Math.PI)]);
        FrameCamera turned = Model.At(state with { MoonFromCamera = jitter.Turn(state.MoonFromCamera, 7.0) });

        Assert.True(turned.TryProjectPoint(ray.Origin + (1e5 * ray.Direction), out RenderingPoint seen));
        double shift = axis == JitterAxis.Yaw ? 10.0 * Turn : 500.0 * Turn;
        Assert.Equal(61.0 + (right * shift), seen.X, 0.03 * shift + 0.003);
        Assert.Equal(41.0 + (down * shift), seen.Y, 0.03 * shift + 0.003);
    }

    [Fact]
    public void Turn_LargeAngles_IsRollThenPitchThenYaw()
    {
        Jitter jitter = new([(0.0, new Vector3D(0.3, 0.5, 0.7))]);
        UnitQuaternion turn = jitter.Turn(UnitQuaternion.Identity, 0.0);

        // numpy: columns of B Ry(0.3) Rx(0.5) Rz(0.7) B^T, where the columns of B, (0, 1, 0), (0, 0, -1) and (-1, 0, 0), are x right, y
        // down and z forward in camera axes.
        (Vector3D Axis, Vector3D Turned)[] columns =
        [
            (Vector3D.UnitX, new Vector3D(0.8383866435942036, -0.2593433800522308, -0.479425538604203)),
            (Vector3D.UnitY, new Vector3D(-0.06903356805788471, 0.8219543695041275, -0.5653542083811438)),
            (Vector3D.UnitZ, new Vector3D(0.5406867876359134, 0.5070818727544463, 0.6712121661589577)),
        ];
        foreach ((Vector3D axis, Vector3D expected) in columns)
        {
            Assert.InRange((expected - (turn * axis)).Length, 0.0, Rounding.OfUnits);
        }
    }

    [Fact]
    public void AnglesAt_SumOfSines_IsThatOfTheFormula()
    {
        Jitter jitter = new(
        [
            new JitterSine(JitterAxis.Pitch, 5.0, 20e-6, 0.3), new JitterSine(JitterAxis.Roll, 12.0, 3e-6, 0.0),
            new JitterSine(JitterAxis.Pitch, 0.7, 4e-6, -1.0),
        ]);
        Vector3D angles = jitter.AnglesAt(0.123);

        // Python: 20*sin(2*pi*5*.123+.3)+4*sin(2*pi*.7*.123-1), 3*sin(2*pi*12*.123)
        Assert.Equal(-18.841237642797072e-6, angles.Y, 1e-18);
        Assert.Equal(0.4506767673622708e-6, angles.X, 1e-18);
        Assert.Equal(0.0, angles.Z);
    }

    [Fact]
    public void AnglesAt_SamplesOfACubic_IsTheCubic()
    {
        static Vector3D Cubic(double t) => new(1.0 + (2.0 * t) - (t * t * t), t * t, -3.0 * t * t * t);
        double[] times = [-1.0, -0.2, 0.3, 1.1, 1.5, 2.5];
        Jitter jitter = new([.. times.Select(time => (time, Cubic(time)))]);
        foreach (double time in (double[])[-1.0, -0.9, 0.0, 0.3, 0.77, 1.4, 2.4, 2.5])
        {
            Assert.InRange((Cubic(time) - jitter.AnglesAt(time)).Length, 0.0, 1e-13); // 450 ulps: numbers up to 47, a cubic through four
        }

        Assert.Throws<BadInputException>(() => jitter.AnglesAt(2.5001));
    }
}
