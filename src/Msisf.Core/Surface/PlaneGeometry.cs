using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Terrain;

namespace Msisf.Core.Surface;

/// <summary>
/// The mesh of a model in polar stereographic projection. A vertex is floor(2^k radius direction + 1/2) in steps of 2^-k m, with the
/// direction (b, a, +-(1 - s)) / (1 + s) of <see cref="PolarStereographic"/>: f = 2^k radius / (1 + s), then f b, f a and +-(f (1 - s)),
/// each with one rounding an operation and none of them fused.
/// </summary>
internal sealed class PlaneGeometry : MeshGeometry
{
    private readonly PolarStereographic _projection;
    private readonly double[] _a;

    /// <summary>Computes the tables of a mesh.</summary>
    public PlaneGeometry(PolarStereographic projection, FacetMesh mesh)
    {
        _projection = projection;
        StepsPerMetre = StepsOf(mesh);
        CellAngle = projection.MetresPerPixel / MoonConstants.ReferenceRadius;
        Sagitta = MeshBounds.SagittaOf(CellAngle);
        Nodes = new PlaneNodes(projection);
        _a = new double[mesh.Samples + BlockVertices.Stride];
        for (int sample = 0; sample < _a.Length; sample++)
        {
            _a[sample] = projection.A(sample);
        }
    }

    public override double StepsPerMetre { get; }

    public override double CellAngle { get; }

    public override double Sagitta { get; }

    public override int WidestColumns => int.MaxValue;

    /// <summary>Bounds of rectangles of cells.</summary>
    public PlaneNodes Nodes { get; }

    /// <summary>
    /// k of the lattice of 2^-k m for cells of a width in m: a step is at most a 2048th of a cell, and never above 2^-7 m, so that the
    /// lattices of coarse models are subsets of those of fine ones.
    /// </summary>
    public static int LatticeOf(double cell) => Math.Max(7, (int)Math.Ceiling(Math.Log2(2048.0 / cell)));

    public override Vector3D Vertex(int line, int sample, double radius) =>
        VertexAt(StepsPerMetre, _projection, _a[sample], _projection.B(line), radius);

    /// <summary>Position of a vertex on a lattice, m, body-fixed.</summary>
    /// <param name="a">X / R of its sample.</param>
    /// <param name="b">Y / R of its line.</param>
    public static Vector3D VertexAt(double stepsPerMetre, PolarStereographic projection, double a, double b, double radius)
    {
        double s = 0.25 * ((a * a) + (b * b));
        double f = (stepsPerMetre * radius) / (1.0 + s);
        return projection.ToBodyFixed(new Vector3D(
            Math.Floor((f * b) + 0.5) / stepsPerMetre,
            Math.Floor((f * a) + 0.5) / stepsPerMetre,
            Math.Floor((projection.PoleSign * (f * (1.0 - s))) + 0.5) / stepsPerMetre));
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would otherwise read with unoptimised vectors
    public override void PlaceLine(
        int line, int firstSample, ReadOnlySpan<double> radii, Vector3D originBodyFixed, Span<double> x, Span<double> y, Span<double> z)
    {
        ReadOnlySpan<double> ofSamples = _a;
        Vector3D origin = _projection.ToMap(originBodyFixed);
        Span<double> toX = _projection.Turn switch { 1 => y, 2 => z, _ => x };
        Span<double> toY = _projection.Turn switch { 1 => z, 2 => x, _ => y };
        Span<double> toZ = _projection.Turn switch { 1 => x, 2 => y, _ => z };
        Vector512<double> stepsPerMetre = Vector512.Create(StepsPerMetre);
        Vector512<double> metresPerStep = Vector512.Create(1.0 / StepsPerMetre);
        Vector512<double> half = Vector512.Create(0.5);
        Vector512<double> one = Vector512<double>.One;
        Vector512<double> quarter = Vector512.Create(0.25);
        Vector512<double> sign = Vector512.Create(_projection.PoleSign);
        Vector512<double> b = Vector512.Create(_projection.B(line));
        Vector512<double> squaredB = b * b;
        for (int i = 0; i < radii.Length; i += Vector512<double>.Count)
        {
            Vector512<double> a = ArrayLanes.Load(ofSamples, firstSample + i);
            Vector512<double> s = quarter * ((a * a) + squaredB);
            Vector512<double> f = (stepsPerMetre * ArrayLanes.Load(radii, i)) / (one + s);
            Vector512<double> px = Vector512.Floor((f * b) + half) * metresPerStep;
            Vector512<double> py = Vector512.Floor((f * a) + half) * metresPerStep;
            Vector512<double> pz = Vector512.Floor((sign * (f * (one - s))) + half) * metresPerStep;
            (px - Vector512.Create(origin.X)).StoreTo(toX, i);
            (py - Vector512.Create(origin.Y)).StoreTo(toY, i);
            (pz - Vector512.Create(origin.Z)).StoreTo(toZ, i);
        }
    }

    public override bool TryGetColumnBorders(CellRange cells, out Vector3D west, out Vector3D east)
    {
        double v0 = 0.5 * _projection.B(cells.FirstLine);
        double v1 = 0.5 * _projection.B(cells.EndLine);
        PlaneBorder below = PlaneBorder.Below(0.5 * _a[cells.FirstSample], v0, v1);
        PlaneBorder above = PlaneBorder.Above(0.5 * _a[cells.EndSample], v0, v1);
        west = _projection.ToBodyFixed(new Vector3D(below.Along, below.Across, _projection.PoleSign * below.Up));
        east = _projection.ToBodyFixed(new Vector3D(above.Along, above.Across, _projection.PoleSign * above.Up));
        return true;
    }

    public override (Vector3D North, Vector3D South) LineBorders(CellRange cells)
    {
        double u0 = 0.5 * _a[cells.FirstSample];
        double u1 = 0.5 * _a[cells.EndSample];
        double first = 0.5 * _projection.B(cells.FirstLine);
        double last = 0.5 * _projection.B(cells.EndLine);
        PlaneBorder north = _projection.IsSouth ? PlaneBorder.Above(first, u0, u1) : PlaneBorder.Below(first, u0, u1);
        PlaneBorder south = _projection.IsSouth ? PlaneBorder.Below(last, u0, u1) : PlaneBorder.Above(last, u0, u1);
        return (
            _projection.ToBodyFixed(new Vector3D(north.Across, north.Along, _projection.PoleSign * north.Up)),
            _projection.ToBodyFixed(new Vector3D(south.Across, south.Along, _projection.PoleSign * south.Up)));
    }
}
