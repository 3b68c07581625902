using Msisf.Core.Mesh;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;

namespace Msisf.Core.Tracing;

/// <summary>
/// The surface of <see cref="FacetMesh"/> with each vertex on the lattice of the pattern files, read sample by sample where it is
/// wanted. Safe for several threads.
/// </summary>
internal sealed class LatticeMesh
{
    private readonly FacetMesh _mesh;
    private readonly GridDirections _directions;

    /// <summary>Takes the model; reads its first and last line for the poles.</summary>
    public LatticeMesh(IElevationGrid grid)
    {
        _mesh = new FacetMesh(grid);
        _directions = new GridDirections(grid.PixelsPerDegree);
        PixelsPerDegree = grid.PixelsPerDegree;
    }

    /// <summary>Samples a degree.</summary>
    public int PixelsPerDegree { get; }

    /// <summary>Lines of samples; vertex lines go from -1 (north pole) to this number (south pole).</summary>
    public int Lines => _mesh.Lines;

    /// <summary>Samples a line.</summary>
    public int Samples => _mesh.Samples;

    /// <summary>Latitude of a vertex line, the poles included.</summary>
    public SineCosine Latitude(int line)
    {
        if (line < 0)
        {
            return new SineCosine(1.0, 0.0);
        }

        return line < Lines ? _directions.Latitude(line) : new SineCosine(-1.0, 0.0);
    }

    /// <summary>Longitude of a sample, 0 to <see cref="Samples"/>, which is 0 again.</summary>
    public SineCosine Longitude(int sample) => _directions.Longitude(sample == Samples ? 0 : sample);

    /// <summary>Radii of consecutive vertices of a line (<see cref="FacetMesh.ReadRadii"/>), m.</summary>
    public void ReadRadii(int line, int firstSample, Span<double> radii) => _mesh.ReadRadii(line, firstSample, radii);

    /// <summary>The corners of a cell, m, MOON_ME; line from -1 on.</summary>
    public CellCorners Corners(int line, int sample)
    {
        Span<double> radii = stackalloc double[4];
        ReadRadii(line, sample, radii[..2]);
        ReadRadii(line + 1, sample, radii[2..]);
        return Corners(line, sample, radii);
    }

    /// <summary>The corners of a cell whose radii are known in the order NW, NE, SW, SE.</summary>
    public CellCorners Corners(int line, int sample, ReadOnlySpan<double> radii)
    {
        SineCosine north = Latitude(line);
        SineCosine south = Latitude(line + 1);
        SineCosine west = Longitude(sample);
        SineCosine east = Longitude(sample + 1);
        return new CellCorners(
            LatticePoint.Nearest(radii[0], north, west).PositionMoonMe,
            LatticePoint.Nearest(radii[1], north, east).PositionMoonMe,
            LatticePoint.Nearest(radii[2], south, west).PositionMoonMe,
            LatticePoint.Nearest(radii[3], south, east).PositionMoonMe);
    }
}
