using Msisf.Core.Mesh.Bounds;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;

namespace Msisf.Core.Mesh;

/// <summary>
/// An elevation model as the surface that is drawn and traced: the mesh of the pattern files with each vertex on their lattice, and tables
/// of the vertices' directions and of the surface's bounds. The model is read only where it is needed. Safe for several threads.
/// </summary>
internal sealed class SurfaceModel
{
    private readonly SineCosine[] _latitudes;

    /// <summary>Makes the surface of a model; nothing of the model is read yet.</summary>
    /// <param name="grid">The elevation model of the whole Moon.</param>
    public SurfaceModel(IElevationGrid grid)
    {
        Grid = grid;
        Mesh = new FacetMesh(grid);
        GridDirections directions = new(grid.PixelsPerDegree);
        _latitudes = new SineCosine[Mesh.Lines + 2];
        for (int line = -1; line <= Mesh.Lines; line++)
        {
            _latitudes[line + 1] = directions.Latitude(line);
        }

        // The last cell block is read in whole vectors, which extend beyond the prime meridian.
        LongitudeSines = new double[Mesh.Samples + BlockVertices.Stride];
        LongitudeCosines = new double[LongitudeSines.Length];
        for (int sample = 0; sample < LongitudeSines.Length; sample++)
        {
            (LongitudeSines[sample], LongitudeCosines[sample]) = directions.Longitude(sample % Mesh.Samples);
        }

        Bounds = new BoundsTree(new SquareLayout(Mesh), Mesh);
    }

    /// <summary>The model.</summary>
    public IElevationGrid Grid { get; }

    /// <summary>The mesh of the model's facets.</summary>
    public FacetMesh Mesh { get; }

    /// <summary>The surface's bounds in the nodes of <see cref="SquareLayout"/>, computed at the first request.</summary>
    public BoundsTree Bounds { get; }

    /// <summary>
    /// Sine of the longitude of each sample, and of <see cref="BlockVertices.Stride"/> more samples beyond the prime meridian.
    /// </summary>
    public double[] LongitudeSines { get; }

    /// <summary>Cosine of the longitude of each sample; as long as <see cref="LongitudeSines"/>.</summary>
    public double[] LongitudeCosines { get; }

    /// <summary>Latitude of a vertex line.</summary>
    /// <param name="line">-1 (north pole) to the mesh's lines (south pole).</param>
    public SineCosine Latitude(int line) => _latitudes[line + 1];

    /// <summary>Longitude of a sample, from 0 to the mesh's number of samples, which is sample 0 again.</summary>
    public SineCosine Longitude(int sample) => new(LongitudeSines[sample], LongitudeCosines[sample]);

    /// <summary>Position of a vertex whose radius is known, m, MOON_ME, on the lattice.</summary>
    /// <param name="line">-1 (north pole) to the mesh's lines (south pole).</param>
    /// <param name="sample">0 to the mesh's samples, which is 0 again.</param>
    /// <param name="radius">m.</param>
    public Vector3D Vertex(int line, int sample, double radius) =>
        LatticePoint.Nearest(radius, Latitude(line), Longitude(sample)).PositionMoonMe;

    /// <summary>The corners of a cell; lines count from -1.</summary>
    public CellCorners Corners(int line, int sample)
    {
        Span<double> radii = stackalloc double[4];
        ReadCorners(line, sample, radii);
        return Corners(line, sample, radii);
    }

    /// <summary>The corners of a cell whose radii are known in the order NW, NE, SW, SE.</summary>
    public CellCorners Corners(int line, int sample, ReadOnlySpan<double> radii) => new(
        Vertex(line, sample, radii[0]),
        Vertex(line, sample + 1, radii[1]),
        Vertex(line + 1, sample, radii[2]),
        Vertex(line + 1, sample + 1, radii[3]));

    /// <summary>The radii of a cell's corners, m, in the order NW, NE, SW, SE.</summary>
    public void ReadCorners(int line, int sample, Span<double> radii)
    {
        Mesh.ReadRadii(line, sample, radii[..2]);
        Mesh.ReadRadii(line + 1, sample, radii[2..]);
    }
}
