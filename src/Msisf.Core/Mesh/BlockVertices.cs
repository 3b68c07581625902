using System.Diagnostics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Numerics;

namespace Msisf.Core.Mesh;

/// <summary>
/// The vertices of one cell block, with one array for each coordinate; one object is loaded for many blocks. The positions are bit for bit
/// those of <see cref="MeshGeometry.Vertex"/>, the scalar reference.
/// </summary>
/// <remarks>
/// Why reading without range checks is safe: a line has up to 33 vertices in <see cref="Stride"/> = 40 elements, so vectors of eight from
/// its vertices 0, 8, ... 32 end within it; and from the last of the 32 x 32 north-western corners (31 * 40 + 31) the vector from the
/// south-eastern one (41 further) ends with element 1319, the last of the array. <see cref="CornersFrom"/> asserts this for the kernels.
/// </remarks>
internal sealed class BlockVertices
{
    /// <summary>Number of array elements from one line of vertices to the next: 33, rounded up to whole vectors.</summary>
    public const int Stride = 40;

    private const int Rows = CellBlock.Size + 1;

    private readonly double[] _radii = new double[Stride];

    /// <summary>Number of lines of vertices that are loaded.</summary>
    public int Lines { get; private set; }

    /// <summary>Number of vertices per line that are loaded; the elements after them, up to the end of the line, are undefined.</summary>
    public int Samples { get; private set; }

    /// <summary>The block's cells.</summary>
    public CellRange Cells { get; private set; }

    /// <summary>
    /// Coordinate of each vertex, m, MOON_ME, relative to the origin of the last <see cref="Load"/>; line by line with <see cref="Stride"/>
    /// elements each.
    /// </summary>
    public double[] X { get; } = new double[Rows * Stride];

    /// <inheritdoc cref="X"/>
    public double[] Y { get; } = new double[Rows * Stride];

    /// <inheritdoc cref="X"/>
    public double[] Z { get; } = new double[Rows * Stride];

    /// <summary>Position of a vertex, m, MOON_ME, relative to the origin of the last <see cref="Load"/>.</summary>
    public Vector3D this[int line, int sample]
    {
        get
        {
            int index = (line * Stride) + sample;
            return new Vector3D(X[index], Y[index], Z[index]);
        }
    }

    /// <summary>
    /// Reference to a cell's north-western corner in an array as long as <see cref="X"/>; the corners of that cell and of the next seven
    /// may be read from there.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static ref double CornersFrom(double[] values, int northWest)
    {
        Debug.Assert(northWest >= 0
            && northWest + Stride + 1 + Vector512<double>.Count <= values.Length, "A cell reaches beyond its block.");
        return ref Unsafe.Add(ref MemoryMarshal.GetArrayDataReference(values), northWest);
    }

    /// <summary>Reads the vertices of a block.</summary>
    /// <param name="surface">The model.</param>
    /// <param name="block">The block.</param>
    /// <param name="originMoonMe">Origin, m, MOON_ME; it is subtracted from each vertex with one rounding per component.</param>
    public void Load(SurfaceModel surface, CellBlock block, Vector3D originMoonMe)
    {
        Cells = block.Cells(surface.Mesh);
        Lines = Cells.EndLine - Cells.FirstLine + 1;
        Samples = Cells.EndSample - Cells.FirstSample + 1;
        int whole = (Samples + Vector512<double>.Count - 1) / Vector512<double>.Count * Vector512<double>.Count;
        _radii.AsSpan(Samples).Fill(surface.Grid.ReferenceRadius);
        for (int line = 0; line < Lines; line++)
        {
            int start = line * Stride;
            surface.Mesh.ReadRadii(Cells.FirstLine + line, Cells.FirstSample, _radii.AsSpan(0, Samples));
            surface.Geometry.PlaceLine(
                Cells.FirstLine + line, Cells.FirstSample, _radii.AsSpan(0, whole), originMoonMe, X.AsSpan(start, whole),
                Y.AsSpan(start, whole), Z.AsSpan(start, whole));
        }
    }
}
