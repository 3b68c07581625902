using Msisf.Core.Mesh.Bounds;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;

namespace Msisf.Core.Mesh;

/// <summary>
/// An elevation model as the renderer reads it: the mesh of the pattern files, with tables of the directions of its vertices and of
/// the bounds of its blocks. Nothing of the model but the two lines at the poles is read before it is needed. Safe for several threads.
/// </summary>
internal sealed class SurfaceModel
{
    private readonly SineCosine[] _latitudes;

    public SurfaceModel(IElevationGrid grid)
    {
        Grid = grid;
        Mesh = new FacetMesh(grid);
        GridDirections directions = new(grid.PixelsPerDegree);
        _latitudes = new SineCosine[Mesh.Lines + 2];
        _latitudes[0] = SineCosine.OfDegrees(90, 1);
        _latitudes[^1] = SineCosine.OfDegrees(-90, 1);
        for (int line = 0; line < Mesh.Lines; line++)
        {
            _latitudes[line + 1] = directions.Latitude(line);
        }

        // The last block reads on over the prime meridian, in whole vectors.
        LongitudeSines = new double[Mesh.Samples + BlockVertices.Stride];
        LongitudeCosines = new double[LongitudeSines.Length];
        for (int sample = 0; sample < LongitudeSines.Length; sample++)
        {
            (LongitudeSines[sample], LongitudeCosines[sample]) = directions.Longitude(sample % Mesh.Samples);
        }

        Bounds = new BlockBoundsTable(this);
    }

    /// <summary>The model.</summary>
    public IElevationGrid Grid { get; }

    /// <summary>Its facets.</summary>
    public FacetMesh Mesh { get; }

    /// <summary>Bounds of blocks, found when they are first asked for.</summary>
    public BlockBoundsTable Bounds { get; }

    /// <summary>Sine of the longitude of each sample, and of some more beyond the prime meridian.</summary>
    public double[] LongitudeSines { get; }

    /// <summary>The cosines.</summary>
    public double[] LongitudeCosines { get; }

    /// <summary>Sine and cosine of the latitude of a vertex line.</summary>
    /// <param name="line">-1 (north pole) to the mesh's lines (south pole).</param>
    public SineCosine Latitude(int line) => _latitudes[line + 1];
}
