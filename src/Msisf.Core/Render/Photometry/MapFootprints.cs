using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Camera;
using Msisf.Core.Numerics;

namespace Msisf.Core.Render.Photometry;

/// <summary>
/// Where the pixels of an image lie on a map, and how much of it they cover: the middle of each, its long axis and the width across that,
/// all in pixels of the finest level. One object is used for many rows.
/// </summary>
internal sealed class MapFootprints
{
    /// <summary>Longest footprint over its width: nearer to the limb, or to a pole, the map is averaged over more than the pixel.</summary>
    private const double MaxSlant = 64.0;

    private const double TinyLength = 1e-30;

    /// <summary>Distance of the middle from the map's left edge.</summary>
    public double[] X { get; private set; } = [];

    /// <summary>Distance of the middle from the map's upper edge.</summary>
    public double[] Y { get; private set; } = [];

    /// <summary>The long axis, to the right.</summary>
    public double[] AxisX { get; private set; } = [];

    /// <summary>The long axis, down.</summary>
    public double[] AxisY { get; private set; } = [];

    /// <summary>The width across the long axis.</summary>
    public double[] Across { get; private set; } = [];

    /// <summary>The length of the long axis.</summary>
    public double[] Along { get; private set; } = [];

    /// <summary>Finds the footprints of points.</summary>
    /// <param name="points">The surface points.</param>
    /// <param name="camera">The camera that sees them.</param>
    /// <param name="samplesAcross">Samples along a pixel's edge: a sample covers as much less.</param>
    /// <param name="map">The map.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would else be shaded with unoptimised vectors
    public void Find(SunlitPoints points, PinholeCamera camera, int samplesAcross, AlbedoMap map)
    {
        EnsureRoom(points.Count);
        double pixelsPerWidth = map.Levels[0].Width / map.Extent.Width;
        double pixelsPerHeight = map.Levels[0].Height / map.Extent.Height;
        Vector512<double> one = Vector512<double>.One;
        Vector512<double> zero = Vector512<double>.Zero;
        Vector512<double> tiny = Vector512.Create(TinyLength);
        Vector512<double> perEast = Vector512.Create(pixelsPerWidth);
        Vector512<double> perNorth = Vector512.Create(pixelsPerHeight);
        Vector512<double> fullTurn = Vector512.Create(2.0 * Math.PI);
        Vector512<double> tangent = Vector512.Create(camera.PixelTangent / samplesAcross);
        Vector512<double> pixelsAround = Vector512.Create(2.0 * Math.PI * pixelsPerWidth);
        Vector3D position = camera.PositionMoonMe;
        Vector3D forward = camera.ForwardMoonMe;
        for (int i = 0; i < points.Count; i += Vector512<double>.Count)
        {
            Vector512<double> x = Load(points.X, i);
            Vector512<double> y = Load(points.Y, i);
            Vector512<double> z = Load(points.Z, i);
            Vector512<double> viewX = Vector512.Create(position.X) - x;
            Vector512<double> viewY = Vector512.Create(position.Y) - y;
            Vector512<double> viewZ = Vector512.Create(position.Z) - z;
            Vector512<double> axisSquared = Vector512.MaxNative((x * x) + (y * y), one); // 1 m from the polar axis is on it
            Vector512<double> radiusSquared = axisSquared + (z * z);
            Vector512<double> axis = Vector512.Sqrt(axisSquared);
            Vector512<double> radius = Vector512.Sqrt(radiusSquared);
            Vector512<double> perAxis = one / axis;
            Vector512<double> perRadius = one / radius;

            Vector512<double> longitude = Angle(x * perAxis, y * perAxis) - Vector512.Create(map.Extent.West);
            longitude -= fullTurn * Vector512.Floor(longitude / fullTurn);
            Vector512<double> latitude = Angle(axis * perRadius, z * perRadius);
            Store(X, i, longitude * perEast);
            Store(Y, i, (Vector512.Create(map.Extent.North) - latitude) * perNorth);

            // The direction to the viewer along the ground; a square across the line of sight is longer by 1 / cos e along it.
            Vector512<double> range = Vector512.Sqrt((viewX * viewX) + (viewY * viewY) + (viewZ * viewZ));
            Vector512<double> east = ((x * viewY) - (y * viewX)) * perAxis;
            Vector512<double> north = ((viewZ * axisSquared) - (z * ((x * viewX) + (y * viewY)))) * (perAxis * perRadius);
            Vector512<double> ground = Vector512.Sqrt((east * east) + (north * north));
            Vector512<double> isSlant = Vector512.GreaterThan(ground, range * Vector512.Create(1e-9));
            Vector512<double> perGround = one / (ground + tiny);
            east = Vector512.ConditionalSelect(isSlant, east * perGround, one);
            north = Vector512.ConditionalSelect(isSlant, north * perGround, zero);
            Vector512<double> cosine = ((x * viewX) + (y * viewY) + (z * viewZ)) * perRadius / range;
            Vector512<double> side = tangent * -((viewX * Vector512.Create(forward.X))
                + (viewY * Vector512.Create(forward.Y)) + (viewZ * Vector512.Create(forward.Z)));
            Vector512<double> slant = side / Vector512.MaxNative(cosine, Vector512.Create(1.0 / MaxSlant));

            Vector512<double> scaleX = perEast * perAxis;
            Vector512<double> scaleY = perNorth * perRadius;
            Vector512<double> firstX = slant * east * scaleX;
            Vector512<double> firstY = -slant * north * scaleY;
            Vector512<double> secondX = -side * north * scaleX;
            Vector512<double> secondY = -side * east * scaleY;
            Vector512<double> firstSquared = (firstX * firstX) + (firstY * firstY);
            Vector512<double> secondSquared = (secondX * secondX) + (secondY * secondY);
            Vector512<double> isFirst = Vector512.GreaterThanOrEqual(firstSquared, secondSquared);
            Vector512<double> along = Vector512.Sqrt(Vector512.MaxNative(firstSquared, secondSquared)) + tiny;
            Vector512<double> area = Vector512.Abs((firstX * secondY) - (firstY * secondX));
            Vector512<double> held = Vector512.MinNative(one, pixelsAround / along);
            Store(AxisX, i, held * Vector512.ConditionalSelect(isFirst, firstX, secondX));
            Store(AxisY, i, held * Vector512.ConditionalSelect(isFirst, firstY, secondY));
            Store(Along, i, held * along);
            Store(Across, i, area / along);
        }
    }

    /// <summary>The angle of a direction of length 1, from -pi to pi.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> Angle(Vector512<double> cosine, Vector512<double> sine)
    {
        Vector512<double> absoluteCosine = Vector512.Abs(cosine);
        Vector512<double> absoluteSine = Vector512.Abs(sine);
        Vector512<double> smaller = Vector512.MinNative(absoluteCosine, absoluteSine);
        Vector512<double> squared = Vector512.MinNative(smaller * smaller, Vector512.Create(0.5));
        Vector512<double> angle = absoluteCosine * absoluteSine * LaneMath.ArcsinOverSineCosine(squared);
        angle = Vector512.ConditionalSelect(
            Vector512.GreaterThan(absoluteSine, absoluteCosine), Vector512.Create(Math.PI / 2.0) - angle, angle);
        angle = Vector512.ConditionalSelect(
            Vector512.LessThan(cosine, Vector512<double>.Zero), Vector512.Create(Math.PI) - angle, angle);
        return Vector512.ConditionalSelect(Vector512.LessThan(sine, Vector512<double>.Zero), -angle, angle);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> Load(double[] values, int index) =>
        Vector512.LoadUnsafe(ref MemoryMarshal.GetArrayDataReference(values), (nuint)index);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Store(double[] values, int index, Vector512<double> value) =>
        value.StoreUnsafe(ref MemoryMarshal.GetArrayDataReference(values), (nuint)index);

    private void EnsureRoom(int count)
    {
        int size = count + SunlitPoints.Padding;
        if (X.Length < size)
        {
            (X, Y) = (new double[size], new double[size]);
            (AxisX, AxisY) = (new double[size], new double[size]);
            (Across, Along) = (new double[size], new double[size]);
        }
    }
}
