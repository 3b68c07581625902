using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Terrain;

namespace Msisf.Core.Surface;

/// <summary>
/// The mesh of a model in simple cylindrical projection; lines and samples count in the grid of the whole Moon. The vertices are those of
/// the pattern files (<see cref="LatticePoint.Nearest"/>): the same products in the same order, none of them fused. Those of maps whose
/// cells are narrower than 16 m lie on finer lattices (<see cref="PlaneGeometry.LatticeOf"/>).
/// </summary>
internal sealed class CylinderGeometry : MeshGeometry
{
    /// <summary>Maximum width, in degrees, of a rectangle that two planes through the axis can bound well.</summary>
    private const int WidestDegrees = 90;

    private readonly int _firstLine;
    private readonly int _firstSample;
    private readonly SineCosine[] _latitudes;
    private readonly double[] _longitudeSines;
    private readonly double[] _longitudeCosines;

    /// <summary>Computes the tables of a mesh.</summary>
    public CylinderGeometry(FacetMesh mesh)
    {
        int pixelsPerDegree = ((Equirectangular)mesh.Grid.Projection).PixelsPerDegree;
        CellAngle = Math.PI / 180.0 / pixelsPerDegree;
        Sagitta = MeshBounds.SagittaFactor(pixelsPerDegree);
        WidestColumns = WidestDegrees * pixelsPerDegree;
        StepsPerMetre = StepsOf(mesh);
        GridWindow window = mesh.Grid.Window;
        bool isPart = window.Samples < mesh.Samples;
        GridDirections directions = new(pixelsPerDegree, hasTable: !isPart);
        _firstLine = isPart ? window.FirstLine : -1;
        _latitudes = new SineCosine[(isPart ? window.EndLine : mesh.Lines + 1) - _firstLine];
        for (int i = 0; i < _latitudes.Length; i++)
        {
            _latitudes[i] = directions.Latitude(_firstLine + i);
        }

        // The last cell block is read in whole vectors, which extend beyond the prime meridian; so do maps across it.
        _firstSample = isPart ? window.FirstSample : 0;
        _longitudeSines = new double[(isPart ? window.Samples : mesh.Samples) + BlockVertices.Stride];
        _longitudeCosines = new double[_longitudeSines.Length];
        for (int i = 0; i < _longitudeSines.Length; i++)
        {
            (_longitudeSines[i], _longitudeCosines[i]) = directions.Longitude((_firstSample + i) % mesh.Samples);
        }
    }

    public override double StepsPerMetre { get; }

    public override double CellAngle { get; }

    public override double Sagitta { get; }

    public override int WidestColumns { get; }

    /// <summary>Latitude of a vertex line.</summary>
    /// <param name="line">-1 (north pole) to the mesh's lines (south pole).</param>
    public SineCosine Latitude(int line) => _latitudes[line - _firstLine];

    /// <summary>
    /// Longitude of a sample, from 0 to the mesh's number of samples, which is sample 0 again, and on to the end of the map.
    /// </summary>
    public SineCosine Longitude(int sample) =>
        new(_longitudeSines[sample - _firstSample], _longitudeCosines[sample - _firstSample]);

    public override Vector3D Vertex(int line, int sample, double radius) =>
        VertexAt(StepsPerMetre, Latitude(line), Longitude(sample), radius);

    /// <summary>Position of a vertex on a lattice, m, body-fixed.</summary>
    public static Vector3D VertexAt(double stepsPerMetre, SineCosine latitude, SineCosine longitude, double radius)
    {
        double steps = stepsPerMetre * radius;
        double equatorial = steps * latitude.Cosine;
        return new Vector3D(
            Math.Floor((equatorial * longitude.Cosine) + 0.5) / stepsPerMetre,
            Math.Floor((equatorial * longitude.Sine) + 0.5) / stepsPerMetre,
            Math.Floor((steps * latitude.Sine) + 0.5) / stepsPerMetre);
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would otherwise read with unoptimised vectors
    public override void PlaceLine(
        int line, int firstSample, ReadOnlySpan<double> radii, Vector3D originBodyFixed, Span<double> x, Span<double> y, Span<double> z)
    {
        SineCosine latitude = Latitude(line);
        ReadOnlySpan<double> sines = _longitudeSines;
        ReadOnlySpan<double> cosines = _longitudeCosines;
        int start = firstSample - _firstSample;
        Vector512<double> stepsPerMetre = Vector512.Create(StepsPerMetre);
        Vector512<double> metresPerStep = Vector512.Create(1.0 / StepsPerMetre);
        Vector512<double> half = Vector512.Create(0.5);
        Vector512<double> sinLatitude = Vector512.Create(latitude.Sine);
        Vector512<double> cosLatitude = Vector512.Create(latitude.Cosine);
        for (int i = 0; i < radii.Length; i += Vector512<double>.Count)
        {
            Vector512<double> steps = stepsPerMetre * ArrayLanes.Load(radii, i);
            Vector512<double> equatorial = steps * cosLatitude;
            Vector512<double> px = Vector512.Floor((equatorial * ArrayLanes.Load(cosines, start + i)) + half) * metresPerStep;
            Vector512<double> py = Vector512.Floor((equatorial * ArrayLanes.Load(sines, start + i)) + half) * metresPerStep;
            Vector512<double> pz = Vector512.Floor((steps * sinLatitude) + half) * metresPerStep;
            (px - Vector512.Create(originBodyFixed.X)).StoreTo(x, i);
            (py - Vector512.Create(originBodyFixed.Y)).StoreTo(y, i);
            (pz - Vector512.Create(originBodyFixed.Z)).StoreTo(z, i);
        }
    }

    /// <inheritdoc/>
    /// <remarks>The borders are meridian planes.</remarks>
    public override bool TryGetColumnBorders(CellRange cells, out Vector3D west, out Vector3D east)
    {
        if (cells.Samples > WidestColumns)
        {
            (west, east) = (default, default);
            return false;
        }

        SineCosine atWest = Longitude(cells.FirstSample);
        SineCosine atEast = Longitude(cells.EndSample);
        west = new Vector3D(-atWest.Sine, atWest.Cosine, 0.0);
        east = new Vector3D(atEast.Sine, -atEast.Cosine, 0.0);
        return true;
    }

    /// <inheritdoc/>
    /// <remarks>
    /// The vertices of a parallel do not lie in one plane through the centre. So the border is the plane through the two corners on one
    /// side of the equator, and the plane that touches the parallel in the middle on the other. With half the rectangle's width D and the
    /// longitude d from its middle, a vertex at latitude p is north of the plane with slope q if tan p >= cos d tan q, and
    /// cos D &lt;= cos d &lt;= 1.
    /// </remarks>
    public override (Vector3D North, Vector3D South) LineBorders(CellRange cells)
    {
        SineCosine west = Longitude(cells.FirstSample);
        SineCosine east = Longitude(cells.EndSample);

        // Direction of the rectangle's middle. Its length is the cosine of half the rectangle's width, which shortens the normals below by
        // the same factor.
        double x = 0.5 * (west.Cosine + east.Cosine);
        double y = 0.5 * (west.Sine + east.Sine);
        double squaredCosine = (x * x) + (y * y);
        double cosine = Math.Sqrt(squaredCosine);
        SineCosine north = Latitude(cells.FirstLine);
        SineCosine south = Latitude(cells.EndLine);
        double northZ = north.Cosine * (north.Sine >= 0.0 ? squaredCosine : cosine);
        double southZ = south.Cosine * (south.Sine >= 0.0 ? cosine : squaredCosine);
        return (
            new Vector3D(north.Sine * x, north.Sine * y, -northZ),
            new Vector3D(-south.Sine * x, -south.Sine * y, southZ));
    }
}
