using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Camera;
using Msisf.Core.Numerics;

namespace Msisf.Core.Render.Photometry;

/// <summary>
/// Where the pixels of an image lie on a map, and how much of it they cover: the middle of each and its long axis, in pixels of the finest
/// level, and at how many places along the axis which levels are to be read. One object is used for many rows.
/// </summary>
internal sealed class MapFootprints
{
    /// <summary>Longest footprint over its width: nearer to the limb, or to a pole, the map is averaged over more than the pixel.</summary>
    private const double MaxSlant = 64.0;

    /// <summary>Most places at which a level is read for one pixel; a longer footprint is read from a coarser level.</summary>
    private const double MaxProbes = 16.0;

    /// <summary>Added to squares of lengths that can be 0.</summary>
    private const double TinySquare = 1e-60;

    /// <summary>The bits of a number that are its digits, without sign and exponent.</summary>
    private const long Digits = (1L << 52) - 1;

    /// <summary>Distance of the middle from the map's left edge.</summary>
    public double[] X { get; private set; } = [];

    /// <summary>Distance of the middle from the map's upper edge.</summary>
    public double[] Y { get; private set; } = [];

    /// <summary>The long axis, to the right.</summary>
    public double[] AxisX { get; private set; } = [];

    /// <summary>The long axis, down.</summary>
    public double[] AxisY { get; private set; } = [];

    /// <summary>Number of places along the axis, a whole number from 1: each covers about a square.</summary>
    public double[] Probes { get; private set; } = [];

    /// <summary>The finer of the two levels between which the width of such a square lies.</summary>
    public long[] Levels { get; private set; } = [];

    /// <summary>How far the width lies towards the coarser level, 0 to below 1.</summary>
    public double[] Parts { get; private set; } = [];

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
        Vector512<double> tiny = Vector512.Create(TinySquare);
        Vector512<double> perEast = Vector512.Create(pixelsPerWidth);
        Vector512<double> perNorth = Vector512.Create(pixelsPerHeight);
        Vector512<double> fullTurn = Vector512.Create(2.0 * Math.PI);
        Vector512<double> perTurn = Vector512.Create(0.5 / Math.PI);
        Vector512<double> widest = Vector512.Create(Math.ScaleB(1.0, map.Levels.Count - 1));
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
            Vector512<double> perAxis = LaneMath.InverseSqrt(axisSquared);
            Vector512<double> perRadius = LaneMath.InverseSqrt(radiusSquared);

            Vector512<double> longitude = Angle(x * perAxis, y * perAxis) - Vector512.Create(map.Extent.West);
            longitude -= fullTurn * Vector512.Floor(longitude * perTurn);
            Vector512<double> latitude = Angle(axisSquared * perAxis * perRadius, z * perRadius);
            Store(X, i, longitude * perEast);
            Store(Y, i, (Vector512.Create(map.Extent.North) - latitude) * perNorth);

            // The direction to the viewer along the ground; a square across the line of sight is longer by 1 / cos e along it.
            Vector512<double> rangeSquared = (viewX * viewX) + (viewY * viewY) + (viewZ * viewZ);
            Vector512<double> east = ((x * viewY) - (y * viewX)) * perAxis;
            Vector512<double> north = ((viewZ * axisSquared) - (z * ((x * viewX) + (y * viewY)))) * (perAxis * perRadius);
            Vector512<double> groundSquared = (east * east) + (north * north);
            Vector512<double> isSlant = Vector512.GreaterThan(groundSquared, rangeSquared * Vector512.Create(1e-18));
            Vector512<double> perGround = LaneMath.InverseSqrt(groundSquared + tiny);
            east = Vector512.ConditionalSelect(isSlant, east * perGround, one);
            north = Vector512.ConditionalSelect(isSlant, north * perGround, zero);
            Vector512<double> cosine = ((x * viewX) + (y * viewY) + (z * viewZ)) * perRadius * LaneMath.InverseSqrt(rangeSquared);
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
            Vector512<double> longer = Vector512.MaxNative(firstSquared, secondSquared) + tiny;
            Vector512<double> perAlong = LaneMath.InverseSqrt(longer);
            Vector512<double> held = Vector512.MinNative(one, pixelsAround * perAlong);
            Vector512<double> along = held * (longer * perAlong);
            Vector512<double> across = Vector512.Abs((firstX * secondY) - (firstY * secondX)) * perAlong;
            Store(AxisX, i, held * Vector512.ConditionalSelect(isFirst, firstX, secondX));
            Store(AxisY, i, held * Vector512.ConditionalSelect(isFirst, firstY, secondY));

            // Less than half a square at the end is shared among the others, which are longer then.
            Vector512<double> squares = along / Vector512.MaxNative(across, one);
            Vector512<double> probes = Vector512.MinNative(
                Vector512.MaxNative(Vector512.Ceiling(squares - Vector512.Create(0.5)), one), Vector512.Create(MaxProbes));
            Vector512<double> width = Vector512.MinNative(
                Vector512.MaxNative(Vector512.MaxNative(across, along / probes), one), widest);
            Store(Probes, i, probes);
            Store(Parts, i, ((width.AsInt64() & Vector512.Create(Digits)) | one.AsInt64()).AsDouble() - one);
            (Vector512.ShiftRightLogical(width.AsInt64(), 52) - Vector512.Create(1023L))
                .StoreUnsafe(ref MemoryMarshal.GetArrayDataReference(Levels), (nuint)i);
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
            (Probes, Parts, Levels) = (new double[size], new double[size], new long[size]);
        }
    }
}
