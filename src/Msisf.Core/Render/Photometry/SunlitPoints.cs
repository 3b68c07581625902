using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Numerics;
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

    /// <summary>Number of pixels.</summary>
    public int Count { get; private set; }

    /// <summary>Column of each pixel, from 0.</summary>
    public int[] Columns { get; private set; } = [];

    /// <summary>Weight of each pixel's radiance factor in its mean.</summary>
    public double[] Weights { get; private set; } = [];

    /// <summary>Coordinate of each surface point, m, MOON_ME.</summary>
    public double[] X { get; private set; } = [];

    /// <inheritdoc cref="X"/>
    public double[] Y { get; private set; } = [];

    /// <inheritdoc cref="X"/>
    public double[] Z { get; private set; } = [];

    /// <summary>Component of each unit normal, MOON_ME.</summary>
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
        if (Columns.Length < size)
        {
            Columns = new int[size];
            (Weights, X, Y, Z) = (new double[size], new double[size], new double[size], new double[size]);
            (NormalX, NormalY, NormalZ) = (new double[size], new double[size], new double[size]);
            (CosIncidence, CosEmission, PhaseHaversine) = (new double[size], new double[size], new double[size]);
            (Factors, ReferenceFactors) = (new double[size], new double[size]);
        }
    }

    /// <summary>Adds a pixel.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Add(int column, double weight, Vector3D pointMoonMe, Vector3D normalMoonMe, double cosIncidence)
    {
        int i = Count++;
        Columns[i] = column;
        Weights[i] = weight;
        (X[i], Y[i], Z[i]) = (pointMoonMe.X, pointMoonMe.Y, pointMoonMe.Z);
        (NormalX[i], NormalY[i], NormalZ[i]) = (normalMoonMe.X, normalMoonMe.Y, normalMoonMe.Z);
        CosIncidence[i] = cosIncidence;
    }

    /// <summary>Adds pixels that follow each other in a row, each with the weight 1.</summary>
    /// <param name="row">The row.</param>
    /// <param name="cosIncidence">Cosines of the incidence angles of all its pixels.</param>
    /// <param name="first">The first pixel, from 0.</param>
    /// <param name="count">How many.</param>
    public void AddRun(SurfaceRow row, ReadOnlySpan<double> cosIncidence, int first, int count)
    {
        row.Columns.AsSpan(first, count).CopyTo(Columns.AsSpan(Count));
        row.X.AsSpan(first, count).CopyTo(X.AsSpan(Count));
        row.Y.AsSpan(first, count).CopyTo(Y.AsSpan(Count));
        row.Z.AsSpan(first, count).CopyTo(Z.AsSpan(Count));
        row.NormalX.AsSpan(first, count).CopyTo(NormalX.AsSpan(Count));
        row.NormalY.AsSpan(first, count).CopyTo(NormalY.AsSpan(Count));
        row.NormalZ.AsSpan(first, count).CopyTo(NormalZ.AsSpan(Count));
        cosIncidence.Slice(first, count).CopyTo(CosIncidence.AsSpan(Count));
        Weights.AsSpan(Count, count).Fill(1.0);
        Count += count;
    }

    /// <summary>Computes emission and phase angles of all pixels.</summary>
    /// <param name="lightMoonMe">Position of the Sun or lamp, m.</param>
    /// <param name="cameraMoonMe">Position of the camera, m.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would else be shaded with unoptimised vectors
    public void FindAngles(Vector3D lightMoonMe, Vector3D cameraMoonMe)
    {
        Vector512<double> one = Vector512<double>.One;
        for (int i = 0; i < Count; i += Vector512<double>.Count)
        {
            Vector512<double> x = Load(X, i);
            Vector512<double> y = Load(Y, i);
            Vector512<double> z = Load(Z, i);
            Vector512<double> sunX = Vector512.Create(lightMoonMe.X) - x;
            Vector512<double> sunY = Vector512.Create(lightMoonMe.Y) - y;
            Vector512<double> sunZ = Vector512.Create(lightMoonMe.Z) - z;
            Vector512<double> viewX = Vector512.Create(cameraMoonMe.X) - x;
            Vector512<double> viewY = Vector512.Create(cameraMoonMe.Y) - y;
            Vector512<double> viewZ = Vector512.Create(cameraMoonMe.Z) - z;

            // Lengths of 1 m to 1e12 m: their squares neither overflow nor vanish.
            Vector512<double> sunLength = Vector512.Sqrt((sunX * sunX) + (sunY * sunY) + (sunZ * sunZ));
            Vector512<double> viewLength = Vector512.Sqrt((viewX * viewX) + (viewY * viewY) + (viewZ * viewZ));
            Vector512<double> perLengths = one / (sunLength * viewLength);
            Vector512<double> perSun = viewLength * perLengths;
            Vector512<double> perView = sunLength * perLengths;
            Vector512<double> cosEmission = perView
                * ((Load(NormalX, i) * viewX) + (Load(NormalY, i) * viewY) + (Load(NormalZ, i) * viewZ));
            Vector512<double> differenceX = (sunX * perSun) - (viewX * perView);
            Vector512<double> differenceY = (sunY * perSun) - (viewY * perView);
            Vector512<double> differenceZ = (sunZ * perSun) - (viewZ * perView);
            Vector512<double> haversine = Vector512.Create(0.25)
                * ((differenceX * differenceX) + (differenceY * differenceY) + (differenceZ * differenceZ));
            Vector512.MinNative(cosEmission, one).StoreUnsafe(ref MemoryMarshal.GetArrayDataReference(CosEmission), (nuint)i);
            Vector512.MinNative(haversine, one).StoreUnsafe(ref MemoryMarshal.GetArrayDataReference(PhaseHaversine), (nuint)i);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> Load(double[] values, int index) =>
        Vector512.LoadUnsafe(ref MemoryMarshal.GetArrayDataReference(values), (nuint)index);
}
