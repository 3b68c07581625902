using Msisf.Core.Terrain;

namespace Msisf.Core.Surface;

/// <summary>The vertices of a block of cells, on the lattice, read from the model; one object is loaded for many blocks.</summary>
internal sealed class TerrainPatch(FacetMesh mesh)
{
    private readonly double _stepsPerMetre = MeshGeometry.StepsOf(mesh);
    private double[] _radii = [];
    private SineCosine[] _longitudes = [];
    private Vector3D[] _positions = [];

    /// <summary>Number of vertices from north to south.</summary>
    public int Lines { get; private set; }

    /// <summary>Number of vertices from west to east.</summary>
    public int Samples { get; private set; }

    /// <summary>Positions of the vertices, m, body-fixed, line by line.</summary>
    public ReadOnlySpan<Vector3D> Positions => _positions.AsSpan(0, Lines * Samples);

    /// <summary>Position of a vertex, m, body-fixed; the indices are within the patch.</summary>
    public Vector3D this[int line, int sample] => _positions[(line * Samples) + sample];

    /// <summary>Reads the vertices of the cells [firstLine, endLine) x [firstSample, endSample), borders included.</summary>
    public void Load(CellRange cells)
    {
        Lines = cells.EndLine - cells.FirstLine + 1;
        Samples = cells.EndSample - cells.FirstSample + 1;
        if (_positions.Length < Lines * Samples)
        {
            _positions = new Vector3D[Lines * Samples];
        }

        if (_radii.Length < Samples)
        {
            _radii = new double[Samples];
            _longitudes = new SineCosine[Samples];
        }

        if (mesh.Grid.Projection is Equirectangular(var pixelsPerDegree))
        {
            LoadCylinder(cells, new GridDirections(pixelsPerDegree, hasTable: false));
        }
        else
        {
            LoadPlane(cells, (PolarStereographic)mesh.Grid.Projection);
        }
    }

    private void LoadCylinder(CellRange cells, GridDirections directions)
    {
        for (int sample = 0; sample < Samples; sample++)
        {
            _longitudes[sample] = directions.Longitude((cells.FirstSample + sample + mesh.Samples) % mesh.Samples);
        }

        for (int line = 0; line < Lines; line++)
        {
            mesh.ReadRadii(cells.FirstLine + line, cells.FirstSample, _radii.AsSpan(0, Samples));
            SineCosine latitude = directions.Latitude(cells.FirstLine + line);
            for (int sample = 0; sample < Samples; sample++)
            {
                _positions[(line * Samples) + sample] =
                    CylinderGeometry.VertexAt(_stepsPerMetre, latitude, _longitudes[sample], _radii[sample]);
            }
        }
    }

    private void LoadPlane(CellRange cells, PolarStereographic plane)
    {
        for (int line = 0; line < Lines; line++)
        {
            mesh.ReadRadii(cells.FirstLine + line, cells.FirstSample, _radii.AsSpan(0, Samples));
            double b = plane.B(cells.FirstLine + line);
            for (int sample = 0; sample < Samples; sample++)
            {
                _positions[(line * Samples) + sample] =
                    PlaneGeometry.VertexAt(_stepsPerMetre, plane, plane.A(cells.FirstSample + sample), b, _radii[sample]);
            }
        }
    }
}
