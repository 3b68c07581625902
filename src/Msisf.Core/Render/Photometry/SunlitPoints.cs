using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Render.Visibility;

namespace Msisf.Core.Render.Photometry;

/// <summary>
/// The sunlit pixels of one row, with the angles that a reflectance law needs; one object is used for many rows. Each array has
/// <see cref="Padding"/> elements after the last pixel.
/// </summary>
internal sealed class SunlitPoints
{
    /// <summary>Elements after the last pixel, so that whole vectors can be read and written from any pixel.</summary>
    public const int Padding = 8;

    /// <summary>Vectors for which angles are computed at once.</summary>
    private const int Block = 8;

    private int[] _ownColumns = [];
    private int[] _ownFacets = [];
    private double[] _ownX = [];
    private double[] _ownY = [];
    private double[] _ownZ = [];
    private double[] _ownNormalX = [];
    private double[] _ownNormalY = [];
    private double[] _ownNormalZ = [];
    private double[] _ownCosIncidence = [];

    /// <summary>Number of pixels.</summary>
    public int Count { get; private set; }

    /// <summary>Column of each pixel, from 0.</summary>
    public int[] Columns { get; private set; } = [];

    /// <summary>
    /// Index of each pixel's facet, as in <see cref="SurfaceRow.Facets"/>; undefined for pixels that were added one by one.
    /// </summary>
    public int[] Facets { get; private set; } = [];

    /// <summary>Weight of each pixel's radiance factor in its mean.</summary>
    public double[] Weights { get; private set; } = [];

    /// <summary>Coordinate of each surface point, m, body-fixed.</summary>
    public double[] X { get; private set; } = [];

    /// <inheritdoc cref="X"/>
    public double[] Y { get; private set; } = [];

    /// <inheritdoc cref="X"/>
    public double[] Z { get; private set; } = [];

    /// <summary>Component of each unit normal, body-fixed.</summary>
    public double[] NormalX { get; private set; } = [];

    /// <inheritdoc cref="NormalX"/>
    public double[] NormalY { get; private set; } = [];

    /// <inheritdoc cref="NormalX"/>
    public double[] NormalZ { get; private set; } = [];

    /// <summary>Cosine of the incidence angle of each pixel.</summary>
    public double[] CosIncidence { get; private set; } = [];

    /// <summary>Cosine of the emission angle of each pixel.</summary>
    public double[] CosEmission { get; private set; } = [];

    /// <summary>Haversine of the phase angle of each pixel.</summary>
    public double[] PhaseHaversine { get; private set; } = [];

    /// <summary>Radiance factor of each pixel.</summary>
    public double[] Factors { get; private set; } = [];

    /// <summary>
    /// Radiance factor of each pixel's surface in the geometry of a map of the reflectance, if that differs from place to place.
    /// </summary>
    public double[] ReferenceFactors { get; private set; } = [];

    /// <summary>Forgets all pixels and makes room for a row.</summary>
    public void Clear(int width)
    {
        Count = 0;
        int size = width + Padding;
        if (Weights.Length < size)
        {
            (_ownColumns, _ownFacets) = (new int[size], new int[size]);
            _ownX = new double[size];
            _ownY = new double[size];
            _ownZ = new double[size];
            (_ownNormalX, _ownNormalY, _ownNormalZ) = (new double[size], new double[size], new double[size]);
            _ownCosIncidence = new double[size];
            (Weights, CosEmission, PhaseHaversine) = (new double[size], new double[size], new double[size]);
            (Factors, ReferenceFactors) = (new double[size], new double[size]);
        }

        (Columns, Facets) = (_ownColumns, _ownFacets);
        (X, Y, Z) = (_ownX, _ownY, _ownZ);
        (NormalX, NormalY, NormalZ) = (_ownNormalX, _ownNormalY, _ownNormalZ);
        CosIncidence = _ownCosIncidence;
    }

    /// <summary>Adds a pixel.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Add(int column, double weight, Vector3D pointBodyFixed, Vector3D normalBodyFixed, double cosIncidence)
    {
        int i = Count++;
        Columns[i] = column;
        Weights[i] = weight;
        (X[i], Y[i], Z[i]) = (pointBodyFixed.X, pointBodyFixed.Y, pointBodyFixed.Z);
        (NormalX[i], NormalY[i], NormalZ[i]) = (normalBodyFixed.X, normalBodyFixed.Y, normalBodyFixed.Z);
        CosIncidence[i] = cosIncidence;
    }

    /// <summary>Adds pixels that follow each other in a row, without weights.</summary>
    /// <param name="cosIncidence">Cosines of the incidence angles of all its pixels.</param>
    /// <param name="first">The first pixel, from 0.</param>
    public void AddRun(SurfaceRow row, ReadOnlySpan<double> cosIncidence, int first, int count)
    {
        row.Columns.AsSpan(first, count).CopyTo(Columns.AsSpan(Count));
        row.Facets.AsSpan(first, count).CopyTo(Facets.AsSpan(Count));
        row.X.AsSpan(first, count).CopyTo(X.AsSpan(Count));
        row.Y.AsSpan(first, count).CopyTo(Y.AsSpan(Count));
        row.Z.AsSpan(first, count).CopyTo(Z.AsSpan(Count));
        row.NormalX.AsSpan(first, count).CopyTo(NormalX.AsSpan(Count));
        row.NormalY.AsSpan(first, count).CopyTo(NormalY.AsSpan(Count));
        row.NormalZ.AsSpan(first, count).CopyTo(NormalZ.AsSpan(Count));
        cosIncidence.Slice(first, count).CopyTo(CosIncidence.AsSpan(Count));
        Count += count;
    }

    /// <summary>
    /// Takes all pixels of a row without weights, and without copying them: until <see cref="Clear"/> the row must not be read again.
    /// </summary>
    /// <param name="cosIncidence">Cosines of the incidence angles of all its pixels, as long as the row's arrays.</param>
    public void Share(SurfaceRow row, double[] cosIncidence)
    {
        Count = row.Count;
        (Columns, Facets) = (row.Columns, row.Facets);
        (X, Y, Z) = (row.X, row.Y, row.Z);
        (NormalX, NormalY, NormalZ) = (row.NormalX, row.NormalY, row.NormalZ);
        CosIncidence = cosIncidence;
    }

    /// <summary>Computes emission and phase angles of all pixels.</summary>
    /// <param name="lightBodyFixed">Position of the Sun or lamp, m.</param>
    /// <param name="cameraBodyFixed">Position of the camera, m.</param>
    public void FindAngles(Vector3D lightBodyFixed, Vector3D cameraBodyFixed)
    {
        Span<Vector512<double>> perLengths = stackalloc Vector512<double>[2 * Block];
        for (int first = 0; first < Count; first += Block * Vector512<double>.Count)
        {
            int vectors = Math.Min(Block, (Count - first + Vector512<double>.Count - 1) / Vector512<double>.Count);
            SquareLengths(lightBodyFixed, first, perLengths[..vectors]);
            SquareLengths(cameraBodyFixed, first, perLengths.Slice(vectors, vectors));
            LaneMath.InverseSqrt(perLengths[..(2 * vectors)]);
            FindAngles(lightBodyFixed, cameraBodyFixed, first, perLengths[..vectors], perLengths.Slice(vectors, vectors));
        }
    }

    /// <summary>Lengths of 1 m to 1e12 m: their squares neither overflow nor vanish.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would otherwise be shaded with unoptimised vectors
    private void SquareLengths(Vector3D to, int first, Span<Vector512<double>> squares)
    {
        for (int i = 0; i < squares.Length; i++)
        {
            int at = first + (i * Vector512<double>.Count);
            Vector512<double> x = Vector512.Create(to.X) - Load(X, at);
            Vector512<double> y = Vector512.Create(to.Y) - Load(Y, at);
            Vector512<double> z = Vector512.Create(to.Z) - Load(Z, at);
            squares[i] = (x * x) + (y * y) + (z * z);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private void FindAngles(
        Vector3D light, Vector3D camera, int first, ReadOnlySpan<Vector512<double>> perSuns, ReadOnlySpan<Vector512<double>> perViews)
    {
        Vector512<double> one = Vector512<double>.One;
        for (int i = 0; i < perSuns.Length; i++)
        {
            int at = first + (i * Vector512<double>.Count);
            Vector512<double> x = Load(X, at);
            Vector512<double> y = Load(Y, at);
            Vector512<double> z = Load(Z, at);
            Vector512<double> perSun = perSuns[i];
            Vector512<double> perView = perViews[i];
            Vector512<double> viewX = (Vector512.Create(camera.X) - x) * perView;
            Vector512<double> viewY = (Vector512.Create(camera.Y) - y) * perView;
            Vector512<double> viewZ = (Vector512.Create(camera.Z) - z) * perView;
            Vector512<double> cosEmission = (Load(NormalX, at) * viewX) + (Load(NormalY, at) * viewY) + (Load(NormalZ, at) * viewZ);
            Vector512<double> differenceX = ((Vector512.Create(light.X) - x) * perSun) - viewX;
            Vector512<double> differenceY = ((Vector512.Create(light.Y) - y) * perSun) - viewY;
            Vector512<double> differenceZ = ((Vector512.Create(light.Z) - z) * perSun) - viewZ;
            Vector512<double> haversine = Vector512.Create(0.25)
                * ((differenceX * differenceX) + (differenceY * differenceY) + (differenceZ * differenceZ));
            Vector512.MinNative(cosEmission, one).StoreTo(CosEmission, at);
            Vector512.MinNative(haversine, one).StoreTo(PhaseHaversine, at);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> Load(double[] values, int index) =>
        ArrayLanes.Load(values, index);
}
