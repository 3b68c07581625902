using Msisf.Core.Terrain;

namespace Msisf.Core.Surface;

/// <summary>
/// What of a mesh depends on the map projection of its model: where the vertices lie, and planes and angles that bound cells. Immutable.
/// </summary>
internal abstract class MeshGeometry
{
    /// <summary>Steps of the lattice of vertices a metre, a power of two.</summary>
    public abstract double StepsPerMetre { get; }

    /// <summary>rad: upper bound of a cell's sides as seen from the Moon's centre.</summary>
    public abstract double CellAngle { get; }

    /// <summary>Ratio of a facet's minimum radius to its minimum vertex radius, at least.</summary>
    public abstract double Sagitta { get; }

    /// <summary>
    /// Maximum number of samples of a rectangle of cells for which <see cref="TryGetColumnBorders"/> and <see cref="LineBorders"/> have
    /// planes.
    /// </summary>
    public abstract int WidestColumns { get; }

    public static MeshGeometry Of(FacetMesh mesh) =>
        mesh.Grid.Projection is PolarStereographic polar ? new PlaneGeometry(polar, mesh) : new CylinderGeometry(mesh);

    /// <summary>Steps of the lattice of a mesh a metre.</summary>
    public static double StepsOf(FacetMesh mesh) => mesh.IsClosed
        ? LatticePoint.StepsPerMetre
        : Math.ScaleB(1.0, PlaneGeometry.LatticeOf(mesh.Grid.Projection.Resolution.MetresPerPixel));

    /// <summary>Position of a vertex whose radius is known, m, body-fixed, on the lattice.</summary>
    public abstract Vector3D Vertex(int line, int sample, double radius);

    /// <summary>
    /// Computes the positions of consecutive vertices of a line: bit for bit those of <see cref="Vertex"/>, less an origin.
    /// </summary>
    /// <param name="firstSample">Sample of the first vertex.</param>
    /// <param name="radii">m; as many as whole vectors of eight hold.</param>
    /// <param name="originBodyFixed">Is subtracted from each position with one rounding a component, m, body-fixed.</param>
    /// <param name="x">Receives m, as many as there are radii.</param>
    /// <param name="y">As <paramref name="x"/>.</param>
    /// <param name="z">As <paramref name="x"/>.</param>
    public abstract void PlaceLine(
        int line, int firstSample, ReadOnlySpan<double> radii, Vector3D originBodyFixed, Span<double> x, Span<double> y, Span<double> z);

    /// <summary>Gets two planes through the Moon's centre between which the vertices of a rectangle of cells lie, left to right.</summary>
    /// <param name="west">Inward normal at the left border, at most 1.5 long; vertices are inside up to the lattice's rounding.</param>
    /// <param name="east">The same at the right border.</param>
    /// <returns>False if the rectangle is wider than <see cref="WidestColumns"/>.</returns>
    public abstract bool TryGetColumnBorders(CellRange cells, out Vector3D west, out Vector3D east);

    /// <summary>
    /// Inward normals, at most 1.5 long, of two planes through the Moon's centre between which the vertices of a rectangle of cells lie,
    /// from top to bottom; the rectangle is at most <see cref="WidestColumns"/> wide.
    /// </summary>
    public abstract (Vector3D North, Vector3D South) LineBorders(CellRange cells);
}
