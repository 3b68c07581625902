namespace Msisf.Core.Surface;

/// <summary>The vertices of a block of cells, read from the model; one object is loaded for many blocks.</summary>
internal sealed class TerrainPatch(FacetMesh mesh)
{
    private double[] _radii = [];
    private (double Sin, double Cos)[] _longitudes = [];
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
            _longitudes = new (double, double)[Samples];
        }

        if (!mesh.IsClosed)
        {
            LoadMap(cells);
            return;
        }

        for (int sample = 0; sample < Samples; sample++)
        {
            _longitudes[sample] = Math.SinCos(FacetMesh.Longitude(cells.FirstSample + sample, mesh.Samples));
        }

        for (int line = 0; line < Lines; line++)
        {
            mesh.ReadRadii(cells.FirstLine + line, cells.FirstSample, _radii.AsSpan(0, Samples));
            (double sinLatitude, double cosLatitude) = Math.SinCos(FacetMesh.Latitude(cells.FirstLine + line, mesh.Lines));
            for (int sample = 0; sample < Samples; sample++)
            {
                double across = _radii[sample] * cosLatitude;
                _positions[(line * Samples) + sample] = new Vector3D(
                    across * _longitudes[sample].Cos, across * _longitudes[sample].Sin, _radii[sample] * sinLatitude);
            }
        }
    }

    private void LoadMap(CellRange cells)
    {
        for (int line = 0; line < Lines; line++)
        {
            mesh.ReadRadii(cells.FirstLine + line, cells.FirstSample, _radii.AsSpan(0, Samples));
            for (int sample = 0; sample < Samples; sample++)
            {
                _positions[(line * Samples) + sample] =
                    _radii[sample] * mesh.Grid.Projection.DirectionOf(cells.FirstLine + line, cells.FirstSample + sample);
            }
        }
    }
}
