using System.Diagnostics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Surface;

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
    private int _seamFacets;

    /// <summary>Number of lines of vertices that are loaded.</summary>
    public int Lines { get; private set; }

    /// <summary>Number of vertices per line that are loaded; the elements after them, up to the end of the line, are undefined.</summary>
    public int Samples { get; private set; }

    /// <summary>The block's cells; not of a block of seams.</summary>
    public CellRange Cells { get; private set; }

    public CellBlock Block { get; private set; }

    /// <summary>Line of the cells of the southern fan; a number that no line has if there is none.</summary>
    public int SouthFanLine { get; private set; }

    /// <summary>Whether the block has facets of seams: only one half of the cells of <see cref="SeamPatch.CellsOfLine"/>.</summary>
    public bool IsOfSeams => _seamFacets > 0;

    /// <summary>Room for the radii of a line, for the patch that loads the block.</summary>
    internal Span<double> Radii => _radii;

    /// <summary>
    /// Coordinate of each vertex, m, body-fixed, relative to the origin of the last <see cref="Load"/>; line by line with
    /// <see cref="Stride"/> elements each.
    /// </summary>
    public double[] X { get; } = new double[Rows * Stride];

    /// <inheritdoc cref="X"/>
    public double[] Y { get; } = new double[Rows * Stride];

    /// <inheritdoc cref="X"/>
    public double[] Z { get; } = new double[Rows * Stride];

    /// <summary>Position of a vertex, m, body-fixed, relative to the origin of the last <see cref="Load"/>.</summary>
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

    /// <summary>Minimum third coordinate of the vertices, m.</summary>
    public double MinZ()
    {
        double min = double.PositiveInfinity;
        for (int line = 0; line < Lines; line++)
        {
            foreach (double z in Z.AsSpan(line * Stride, Samples))
            {
                min = Math.Min(min, z);
            }
        }

        return min;
    }

    /// <summary>The cells of a line that have facets, as bits from the left.</summary>
    public uint CellsOfLine(int line) => IsOfSeams ? SeamPatch.CellsOfLine(line, _seamFacets) : uint.MaxValue;

    /// <summary>Number of a facet of seams in <see cref="SeamPatch"/>.</summary>
    /// <param name="index">Index of the facet's first vertex.</param>
    public int SeamFacet(int index) => (Block.Column * SeamPatch.BlockFacets) + SeamPatch.FacetAt(index / Stride, index % Stride);

    /// <summary>Reads the vertices of a block.</summary>
    /// <param name="originBodyFixed">Origin, m, body-fixed; it is subtracted from each vertex with one rounding per component.</param>
    public void Load(SurfaceModel surface, CellBlock block, Vector3D originBodyFixed)
    {
        Block = block;
        surface.Patches[block.Part].Load(this, originBodyFixed);
    }

    /// <summary>Begins to load a block of cells.</summary>
    internal void Begin(CellRange cells, int southFanLine)
    {
        (Cells, SouthFanLine, _seamFacets) = (cells, southFanLine, 0);
        (Lines, Samples) = (cells.Lines + 1, cells.Samples + 1);
    }

    /// <summary>Begins to load a block of facets of seams.</summary>
    internal void Begin(int lines, int samples, int seamFacets) =>
        (Lines, Samples, Cells, SouthFanLine, _seamFacets) = (lines, samples, default, int.MaxValue, seamFacets);
}
