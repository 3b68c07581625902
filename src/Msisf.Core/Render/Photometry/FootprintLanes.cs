using System.Diagnostics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Camera;
using Msisf.Core.Terrain;

namespace Msisf.Core.Render.Photometry;

/// <summary>
/// The steps of <see cref="MapFootprints"/>, each for a block of points: in one long step each operation would wait for the one before it,
/// and without AVX-512 the compiler makes calls of them.
/// </summary>
internal sealed class FootprintLanes
{
    /// <summary>Vectors of a block: with its buffer it stays in the fastest memory.</summary>
    private const int Block = 8;

    /// <summary>Longest footprint over its width: nearer to the limb, or to a pole, the map is averaged over more than the pixel.</summary>
    private const double MaxSlant = 64.0;

    /// <summary>Most places at which a level is read for one pixel; a longer footprint is read from a coarser level.</summary>
    private const double MaxProbes = 16.0;

    /// <summary>
    /// Most places over <see cref="MaxProbes"/> where meridians run together, for each part of the Moon's radius over the distance from its
    /// axis: a pixel beside a pole covers many columns of the map, but no more rows than others.
    /// </summary>
    private const double PolarProbes = 4.0;

    /// <summary>Added to squares of lengths that can be 0.</summary>
    private const double TinySquare = 1e-60;

    /// <summary>The bits of a number that are its digits, without sign and exponent.</summary>
    private const long Digits = (1L << 52) - 1;

    // Places of the quantities in the buffer; a later one takes the place of one that is no longer needed.
    private const int PerAxis = 0 * Block; // the first three are first the squares
    private const int PerRadius = 1 * Block;
    private const int PerRange = 2 * Block;
    private const int PerGround = 3 * Block;
    private const int PerAlong = 4 * Block;
    private const int East = 5 * Block;
    private const int North = 6 * Block;
    private const int IsSlant = 7 * Block;
    private const int Side = 8 * Block;
    private const int Slant = 9 * Block;
    private const int CosLongitude = 10 * Block;
    private const int SinLongitude = 11 * Block;
    private const int CosLatitude = 12 * Block;
    private const int SinLatitude = 13 * Block;
    private const int LongX = CosLongitude;
    private const int LongY = SinLongitude;
    private const int Area = CosLatitude;
    private const int Places = 14;

    private readonly Vector512<double>[] _buffer = new Vector512<double>[Places * Block];

    public static int BlockPoints => Block * Vector512<double>.Count;

    /// <summary>Finds the footprints of the points of a block.</summary>
    /// <param name="points">The surface points.</param>
    /// <param name="camera">The camera that sees them.</param>
    /// <param name="tangent">Tangent of the angle that a sample covers.</param>
    /// <param name="footprints">Receives the footprints.</param>
    public void Find(SunlitPoints points, int first, FrameCamera camera, double tangent, AlbedoMap map, MapFootprints footprints)
    {
        int count = Math.Min(Block, (points.Count - first + Vector512<double>.Count - 1) / Vector512<double>.Count);
        ref Vector512<double> places = ref MemoryMarshal.GetArrayDataReference(_buffer);
        ref Vector512<double> x = ref Lanes(points.X, first, count);
        ref Vector512<double> y = ref Lanes(points.Y, first, count);
        ref Vector512<double> z = ref Lanes(points.Z, first, count);
        Vector3D eye = camera.PositionBodyFixed;
        FindLengths(eye, ref x, ref y, ref z, ref places, count);
        LaneMath.InverseSqrt(_buffer.AsSpan(PerAxis, count));
        LaneMath.InverseSqrt(_buffer.AsSpan(PerRadius, count));
        LaneMath.InverseSqrt(_buffer.AsSpan(PerRange, count));
        FindWays(eye, camera.ForwardBodyFixed, tangent, ref x, ref y, ref z, ref places, count);
        LaneMath.InverseSqrt(_buffer.AsSpan(PerGround, count));
        FindAngles(ref Unsafe.Add(ref places, CosLongitude), ref Unsafe.Add(ref places, SinLongitude), count);
        FindAngles(ref Unsafe.Add(ref places, CosLatitude), ref Unsafe.Add(ref places, SinLatitude), count);
        double perEast = map.Levels[0].Width / map.Extent.Width;
        double perNorth = map.Levels[0].Height / map.Extent.Height;
        FindMiddles(
            map.Extent, perEast, perNorth, ref places, ref Lanes(footprints.X, first, count), ref Lanes(footprints.Y, first, count), count);
        FindAxes(perEast, perNorth, ref places, count);
        LaneMath.InverseSqrt(_buffer.AsSpan(PerAlong, count));
        HoldAxes(
            2.0 * Math.PI * perEast, ref places, ref Lanes(footprints.AxisX, first, count), ref Lanes(footprints.AxisY, first, count),
            count);
        FindLevels(
            Math.ScaleB(1.0, map.Levels.Count - 1), ref places, ref Lanes(footprints.Probes, first, count),
            ref Lanes(footprints.Parts, first, count), ref Lanes(footprints.Levels, first, count), count);
    }

    /// <summary>Some vectors of an array, which must hold all of them.</summary>
    private static ref Vector512<T> Lanes<T>(T[] values, int first, int count)
    {
        Debug.Assert(first + (count * Vector512<T>.Count) <= values.Length, "A block reaches beyond its array.");
        return ref Unsafe.As<T, Vector512<T>>(ref values[first]);
    }

    /// <summary>The squares of the distances from the polar axis, from the Moon's middle and from the viewer.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would otherwise be shaded with unoptimised vectors
    private static void FindLengths(
        Vector3D eye, ref Vector512<double> xs, ref Vector512<double> ys, ref Vector512<double> zs, ref Vector512<double> places, int count)
    {
        for (int i = 0; i < count; i++)
        {
            ref Vector512<double> at = ref Unsafe.Add(ref places, i);
            SightLanes sight = new(eye, Unsafe.Add(ref xs, i), Unsafe.Add(ref ys, i), Unsafe.Add(ref zs, i));
            Unsafe.Add(ref at, PerAxis) = sight.AxisSquared;
            Unsafe.Add(ref at, PerRadius) = sight.AxisSquared + (sight.Z * sight.Z);
            Unsafe.Add(ref at, PerRange) = sight.RangeSquared;
        }
    }

    /// <summary>
    /// Cosines and sines of longitude and latitude, the way to the viewer along the ground, and the sides of a square across the line of
    /// sight on the ground: along the line it is longer by 1 / cos e.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private static void FindWays(
        Vector3D eye, Vector3D forward, double tangent, ref Vector512<double> xs, ref Vector512<double> ys, ref Vector512<double> zs,
        ref Vector512<double> places, int count)
    {
        for (int i = 0; i < count; i++)
        {
            ref Vector512<double> at = ref Unsafe.Add(ref places, i);
            SightLanes sight = new(eye, Unsafe.Add(ref xs, i), Unsafe.Add(ref ys, i), Unsafe.Add(ref zs, i));
            Vector512<double> perAxis = Unsafe.Add(ref at, PerAxis);
            Vector512<double> perRadius = Unsafe.Add(ref at, PerRadius);
            Unsafe.Add(ref at, CosLongitude) = sight.X * perAxis;
            Unsafe.Add(ref at, SinLongitude) = sight.Y * perAxis;
            Unsafe.Add(ref at, CosLatitude) = sight.AxisSquared * perAxis * perRadius;
            Unsafe.Add(ref at, SinLatitude) = sight.Z * perRadius;

            Vector512<double> along = (sight.X * sight.ToEyeX) + (sight.Y * sight.ToEyeY);
            Vector512<double> east = ((sight.X * sight.ToEyeY) - (sight.Y * sight.ToEyeX)) * perAxis;
            Vector512<double> north = ((sight.ToEyeZ * sight.AxisSquared) - (sight.Z * along)) * (perAxis * perRadius);
            Vector512<double> groundSquared = (east * east) + (north * north);
            Unsafe.Add(ref at, East) = east;
            Unsafe.Add(ref at, North) = north;
            Unsafe.Add(ref at, IsSlant) = Vector512.GreaterThan(groundSquared, sight.RangeSquared * Vector512.Create(1e-18));
            Unsafe.Add(ref at, PerGround) = groundSquared + Vector512.Create(TinySquare);

            Vector512<double> cosine = (along + (sight.Z * sight.ToEyeZ)) * perRadius * Unsafe.Add(ref at, PerRange);
            Vector512<double> side = Vector512.Create(tangent) * -((sight.ToEyeX * Vector512.Create(forward.X))
                + (sight.ToEyeY * Vector512.Create(forward.Y)) + (sight.ToEyeZ * Vector512.Create(forward.Z)));
            Unsafe.Add(ref at, Side) = side;
            Unsafe.Add(ref at, Slant) = side / Vector512.MaxNative(cosine, Vector512.Create(1.0 / MaxSlant));
        }
    }

    /// <summary>Replaces cosines by angles from -pi to pi.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private static void FindAngles(ref Vector512<double> cosines, ref Vector512<double> sines, int count)
    {
        for (int i = 0; i < count; i++)
        {
            Vector512<double> cosine = Unsafe.Add(ref cosines, i);
            Vector512<double> sine = Unsafe.Add(ref sines, i);
            Vector512<double> absoluteCosine = Vector512.Abs(cosine);
            Vector512<double> absoluteSine = Vector512.Abs(sine);
            Vector512<double> smaller = Vector512.MinNative(absoluteCosine, absoluteSine);
            Vector512<double> squared = Vector512.MinNative(smaller * smaller, Vector512.Create(0.5));
            Vector512<double> angle = absoluteCosine * absoluteSine * LaneMath.ArcsinOverSineCosine(squared);
            angle = Vector512.ConditionalSelect(
                Vector512.GreaterThan(absoluteSine, absoluteCosine), Vector512.Create(Math.PI / 2.0) - angle, angle);
            angle = Vector512.ConditionalSelect(
                Vector512.LessThan(cosine, Vector512<double>.Zero), Vector512.Create(Math.PI) - angle, angle);
            Unsafe.Add(ref cosines, i) = Vector512.ConditionalSelect(
                Vector512.LessThan(sine, Vector512<double>.Zero), -angle, angle);
        }
    }

    /// <summary>The middles on the map.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private static void FindMiddles(
        MapExtent extent, double perEast, double perNorth, ref Vector512<double> places, ref Vector512<double> middleX,
        ref Vector512<double> middleY, int count)
    {
        for (int i = 0; i < count; i++)
        {
            ref Vector512<double> at = ref Unsafe.Add(ref places, i);
            Vector512<double> longitude = Unsafe.Add(ref at, CosLongitude) - Vector512.Create(extent.West);
            longitude -= Vector512.Create(2.0 * Math.PI) * Vector512.Floor(longitude * Vector512.Create(0.5 / Math.PI));
            Unsafe.Add(ref middleX, i) = longitude * Vector512.Create(perEast);
            Unsafe.Add(ref middleY, i) =
                (Vector512.Create(extent.North) - Unsafe.Add(ref at, CosLatitude)) * Vector512.Create(perNorth);
        }
    }

    /// <summary>The longer of the two axes on the map with the square of its length, and the area of the parallelogram.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private static void FindAxes(double perEast, double perNorth, ref Vector512<double> places, int count)
    {
        for (int i = 0; i < count; i++)
        {
            ref Vector512<double> at = ref Unsafe.Add(ref places, i);
            Vector512<double> perGround = Unsafe.Add(ref at, PerGround);
            Vector512<double> isSlant = Unsafe.Add(ref at, IsSlant);
            Vector512<double> east = Vector512.ConditionalSelect(
                isSlant, Unsafe.Add(ref at, East) * perGround, Vector512<double>.One);
            Vector512<double> north = isSlant & (Unsafe.Add(ref at, North) * perGround);
            Vector512<double> slant = Unsafe.Add(ref at, Slant);
            Vector512<double> side = Unsafe.Add(ref at, Side);
            Vector512<double> scaleX = Vector512.Create(perEast) * Unsafe.Add(ref at, PerAxis);
            Vector512<double> scaleY = Vector512.Create(perNorth) * Unsafe.Add(ref at, PerRadius);
            Vector512<double> firstX = slant * east * scaleX;
            Vector512<double> firstY = -slant * north * scaleY;
            Vector512<double> secondX = -side * north * scaleX;
            Vector512<double> secondY = -side * east * scaleY;
            Vector512<double> firstSquared = (firstX * firstX) + (firstY * firstY);
            Vector512<double> secondSquared = (secondX * secondX) + (secondY * secondY);
            Vector512<double> isFirst = Vector512.GreaterThanOrEqual(firstSquared, secondSquared);
            Unsafe.Add(ref at, PerAlong) =
                Vector512.MaxNative(firstSquared, secondSquared) + Vector512.Create(TinySquare);
            Unsafe.Add(ref at, LongX) = Vector512.ConditionalSelect(isFirst, firstX, secondX);
            Unsafe.Add(ref at, LongY) = Vector512.ConditionalSelect(isFirst, firstY, secondY);
            Unsafe.Add(ref at, Area) = Vector512.Abs((firstX * secondY) - (firstY * secondX));
        }
    }

    /// <summary>Shortens the long axes to once round the Moon; leaves their lengths and the widths across them.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private static void HoldAxes(
        double pixelsAround, ref Vector512<double> places, ref Vector512<double> axisX, ref Vector512<double> axisY, int count)
    {
        for (int i = 0; i < count; i++)
        {
            ref Vector512<double> at = ref Unsafe.Add(ref places, i);
            Vector512<double> perAlong = Unsafe.Add(ref at, PerAlong);
            Vector512<double> longX = Unsafe.Add(ref at, LongX);
            Vector512<double> longY = Unsafe.Add(ref at, LongY);
            Vector512<double> held = Vector512.MinNative(Vector512<double>.One, Vector512.Create(pixelsAround) * perAlong);
            Unsafe.Add(ref axisX, i) = held * longX;
            Unsafe.Add(ref axisY, i) = held * longY;
            Unsafe.Add(ref at, LongX) =
                held * (((longX * longX) + (longY * longY) + Vector512.Create(TinySquare)) * perAlong);
            Unsafe.Add(ref at, Area) *= perAlong;
        }
    }

    /// <summary>How many places along the axis are to be read, and at which levels.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private static void FindLevels(
        double widest, ref Vector512<double> places, ref Vector512<double> probeCounts, ref Vector512<double> parts,
        ref Vector512<long> levels, int count)
    {
        Vector512<double> one = Vector512<double>.One;
        for (int i = 0; i < count; i++)
        {
            ref Vector512<double> at = ref Unsafe.Add(ref places, i);
            Vector512<double> along = Unsafe.Add(ref at, LongX);
            Vector512<double> across = Unsafe.Add(ref at, Area);

            Vector512<double> maxProbes = Vector512.MinNative(
                Vector512.MaxNative(
                    Vector512.Floor(Vector512.Create(PolarProbes * MoonConstants.ReferenceRadius) * Unsafe.Add(ref at, PerAxis)),
                    Vector512.Create(MaxProbes)),
                Vector512.Create((double)MapLevelLanes.MaxPlaces));

            // Less than half a square at the end is shared among the others, which are longer then; but not beside a pole, where the rows
            // would be blurred with the columns.
            Vector512<double> shared = Vector512.LessThanOrEqual(maxProbes, Vector512.Create(MaxProbes)) & Vector512.Create(0.5);
            Vector512<double> squares = along / Vector512.MaxNative(across, one);
            Vector512<double> probes = Vector512.MinNative(
                Vector512.MaxNative(Vector512.Ceiling(squares - shared), one), maxProbes);
            Vector512<double> width = Vector512.MinNative(
                Vector512.MaxNative(Vector512.MaxNative(across, along / probes), one), Vector512.Create(widest));
            Unsafe.Add(ref probeCounts, i) = probes;
            Unsafe.Add(ref parts, i) = ((width.AsInt64() & Vector512.Create(Digits)) | one.AsInt64()).AsDouble() - one;
            Unsafe.Add(ref levels, i) = Vector512.ShiftRightLogical(width.AsInt64(), 52) - Vector512.Create(1023L);
        }
    }
}
