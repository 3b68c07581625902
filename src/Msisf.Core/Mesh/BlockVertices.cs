using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;

namespace Msisf.Core.Mesh;

/// <summary>
/// The vertices of one block of cells, one array for each coordinate; one object is loaded again and again. The positions are those of
/// <see cref="LatticePoint.Nearest"/>, the scalar reference, bit for bit: the same products in the same order, none of them fused.
/// </summary>
internal sealed class BlockVertices
{
    /// <summary>Elements from one line of vertices to the next: 33, rounded up to whole vectors.</summary>
    public const int Stride = 40;

    private const int Rows = CellBlock.Size + 1;

    private readonly double[] _radii = new double[Stride];

    /// <summary>Lines of vertices that are loaded.</summary>
    public int Lines { get; private set; }

    /// <summary>Vertices a line that are loaded; the elements behind them repeat the last one's neighbours and mean nothing.</summary>
    public int Samples { get; private set; }

    /// <summary>The block's cells.</summary>
    public CellRange Cells { get; private set; }

    /// <summary>m, MOON_ME from the origin of the last <see cref="Load"/>; line by line, <see cref="Stride"/> elements each.</summary>
    public double[] X { get; } = new double[Rows * Stride];

    /// <inheritdoc cref="X"/>
    public double[] Y { get; } = new double[Rows * Stride];

    /// <inheritdoc cref="X"/>
    public double[] Z { get; } = new double[Rows * Stride];

    /// <summary>Position of a vertex, m, MOON_ME from the origin.</summary>
    public Vector3D this[int line, int sample]
    {
        get
        {
            int index = (line * Stride) + sample;
            return new Vector3D(X[index], Y[index], Z[index]);
        }
    }

    /// <summary>Reads the vertices of a block.</summary>
    /// <param name="surface">The model.</param>
    /// <param name="block">Which.</param>
    /// <param name="originMoonMe">m, MOON_ME; is subtracted from each vertex, one rounding a component.</param>
    public void Load(SurfaceModel surface, CellBlock block, Vector3D originMoonMe)
    {
        Cells = block.Cells(surface.Mesh);
        Lines = Cells.EndLine - Cells.FirstLine + 1;
        Samples = Cells.EndSample - Cells.FirstSample + 1;
        _radii.AsSpan(Samples).Fill(MoonConstants.ReferenceRadius);
        for (int line = 0; line < Lines; line++)
        {
            surface.Mesh.ReadRadii(Cells.FirstLine + line, Cells.FirstSample, _radii.AsSpan(0, Samples));
            PlaceLine(surface, surface.Latitude(Cells.FirstLine + line), line * Stride, originMoonMe);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would else read with unoptimised vectors
    private void PlaceLine(SurfaceModel surface, SineCosine latitude, int start, Vector3D origin)
    {
        ref double sines = ref Unsafe.Add(ref MemoryMarshal.GetArrayDataReference(surface.LongitudeSines), Cells.FirstSample);
        ref double cosines = ref Unsafe.Add(ref MemoryMarshal.GetArrayDataReference(surface.LongitudeCosines), Cells.FirstSample);
        Vector512<double> stepsPerMetre = Vector512.Create((double)LatticePoint.StepsPerMetre);
        Vector512<double> metresPerStep = Vector512.Create(1.0 / LatticePoint.StepsPerMetre);
        Vector512<double> half = Vector512.Create(0.5);
        Vector512<double> sinLatitude = Vector512.Create(latitude.Sine);
        Vector512<double> cosLatitude = Vector512.Create(latitude.Cosine);
        for (int i = 0; i < Samples; i += Vector512<double>.Count)
        {
            Vector512<double> steps = stepsPerMetre * Vector512.LoadUnsafe(ref _radii[0], (nuint)i);
            Vector512<double> equatorial = steps * cosLatitude;
            Vector512<double> x = Vector512.Floor((equatorial * Vector512.LoadUnsafe(ref cosines, (nuint)i)) + half) * metresPerStep;
            Vector512<double> y = Vector512.Floor((equatorial * Vector512.LoadUnsafe(ref sines, (nuint)i)) + half) * metresPerStep;
            Vector512<double> z = Vector512.Floor((steps * sinLatitude) + half) * metresPerStep;
            (x - Vector512.Create(origin.X)).StoreUnsafe(ref X[0], (nuint)(start + i));
            (y - Vector512.Create(origin.Y)).StoreUnsafe(ref Y[0], (nuint)(start + i));
            (z - Vector512.Create(origin.Z)).StoreUnsafe(ref Z[0], (nuint)(start + i));
        }
    }
}
