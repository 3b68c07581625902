using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Numerics;
using Msisf.Core.Render.Visibility;

namespace Msisf.Core.Render.Shadows;

/// <summary>
/// How far in light space the samples of a part of a pixel may lie from the part's mean. Parts within the reach of a frame have light that
/// can be found for all of their samples at once, unless the border of a shadow is near.
/// </summary>
/// <remarks>
/// The part lies in its facet's plane with the normal n. From the mean at t d to a sample whose ray is d + e it is
/// (t e - (n.e) t / (n.d) d) / (1 + (n.e)/(n.d)); e is at most the part's own reach in the image.
/// </remarks>
internal sealed class PartReach
{
    /// <summary>
    /// Above 1 by more than light space stretches lengths (the Moon's radius over the Sun's distance, 1.2e-5) and floats are rounded.
    /// </summary>
    private const double Stretch = 1.001;

    /// <summary>Parts seen so flat that the ray through a sample may turn by more of its height over the facet are left alone.</summary>
    private const double MaxTurn = 0.5;

    private readonly Vector3D _camera;
    private readonly Vector3D _perColumn;
    private readonly Vector3D _perRow;
    private readonly Vector3D _axisU;
    private readonly Vector3D _axisV;
    private readonly Vector3D _axisW;

    /// <summary>Prepares for a frame without a lens.</summary>
    /// <param name="view">The projection.</param>
    /// <param name="frame">Light space.</param>
    /// <param name="grid">The bins: the reach is a bin to each side.</param>
    public PartReach(ImageView view, LightFrame frame, ReceiverGrid grid)
    {
        _camera = view.Camera.PositionMoonMe;
        (_perColumn, _perRow) = (view.RayPerColumn, view.RayPerRow);
        (U, V) = (grid.AxisU.BinWidth, grid.AxisV.BinWidth);
        (_axisU, _axisV, _axisW) = (frame.AxisU, frame.AxisV, frame.AxisW);
    }

    /// <summary>m: reach along u.</summary>
    public double U { get; }

    /// <summary>m: reach along v.</summary>
    public double V { get; }

    /// <summary>
    /// Marks the parts of a row that are not within reach, and moves their points away from the Sun, to the depth of their deepest sample.
    /// </summary>
    /// <param name="points">The parts' means, with unit normals.</param>
    /// <param name="pixels">px: distance along columns or rows of each part's farthest sample from its place.</param>
    /// <param name="states">Receives <paramref name="mark"/> where a part is not within reach; else left as it is.</param>
    /// <param name="mark">The mark.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would else be drawn with unoptimised vectors
    public void Reach(SurfaceRow points, ReadOnlySpan<float> pixels, Span<byte> states, byte mark)
    {
        Span<float> eight = stackalloc float[Vector512<double>.Count];
        for (int i = 0; i < points.Count; i += Vector512<double>.Count)
        {
            Vector512<double> x = Vector512.LoadUnsafe(ref points.X[i]) - Vector512.Create(_camera.X);
            Vector512<double> y = Vector512.LoadUnsafe(ref points.Y[i]) - Vector512.Create(_camera.Y);
            Vector512<double> z = Vector512.LoadUnsafe(ref points.Z[i]) - Vector512.Create(_camera.Z);
            Vector512<double> normalX = Vector512.LoadUnsafe(ref points.NormalX[i]);
            Vector512<double> normalY = Vector512.LoadUnsafe(ref points.NormalY[i]);
            Vector512<double> normalZ = Vector512.LoadUnsafe(ref points.NormalZ[i]);
            Vector512<double> parameter = Vector512.LoadUnsafe(ref points.Parameters[i]);
            int left = Math.Min(points.Count - i, Vector512<double>.Count);
            pixels.Slice(i, left).CopyTo(eight);
            (Vector256<double> four, Vector256<double> others) = Vector256.Widen(Vector256.Create((ReadOnlySpan<float>)eight));
            Vector512<double> step = Vector512.Create(four, others) * Vector512.Create(Stretch);
            Vector512<double> turn = parameter / ((normalX * x) + (normalY * y) + (normalZ * z));
            Vector512<double> turnOfColumn = turn * Dot(normalX, normalY, normalZ, _perColumn);
            Vector512<double> turnOfRow = turn * Dot(normalX, normalY, normalZ, _perRow);
            Vector512<double> most = step * (Vector512.Abs(turnOfColumn) + Vector512.Abs(turnOfRow));
            Vector512<double> scale = step / (Vector512<double>.One - most);
            Vector512<double> isNear = Vector512.LessThan(most, Vector512.Create(MaxTurn));
            isNear &= Vector512.LessThan(Along(_axisU), Vector512.Create(U)) & Vector512.LessThan(Along(_axisV), Vector512.Create(V));
            Vector512<double> deeper = Along(_axisW);
            (Vector512.LoadUnsafe(ref points.X[i]) + (deeper * _axisW.X)).StoreUnsafe(ref points.X[i]);
            (Vector512.LoadUnsafe(ref points.Y[i]) + (deeper * _axisW.Y)).StoreUnsafe(ref points.Y[i]);
            (Vector512.LoadUnsafe(ref points.Z[i]) + (deeper * _axisW.Z)).StoreUnsafe(ref points.Z[i]);
            uint near = (uint)isNear.ExtractMostSignificantBits();
            for (int lane = 0; near != 0xff && lane < left; lane++)
            {
                states[i + lane] = (near >> lane & 1) != 0 ? states[i + lane] : mark;
            }

            Vector512<double> Along(Vector3D axis)
            {
                Vector512<double> along = Dot(x, y, z, axis);
                return scale * (Vector512.Abs((parameter * Vector512.Create(Vector3D.Dot(_perColumn, axis))) - (turnOfColumn * along))
                    + Vector512.Abs((parameter * Vector512.Create(Vector3D.Dot(_perRow, axis))) - (turnOfRow * along)));
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> Dot(Vector512<double> x, Vector512<double> y, Vector512<double> z, Vector3D axis) =>
        (x * Vector512.Create(axis.X)) + (y * Vector512.Create(axis.Y)) + (z * Vector512.Create(axis.Z));
}
