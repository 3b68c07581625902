using Msisf.Core.Terrain;

namespace Msisf.Core.Surface.Sources;

/// <summary>The facets of one model as it is, where it has data. Safe for several threads.</summary>
internal sealed class RawGround
{
    /// <summary>Samples around a cell that <see cref="TerrainHeight"/> may read.</summary>
    private const int Around = 1;

    private readonly FacetMesh _mesh;

    /// <summary>Takes a model; nothing is read yet.</summary>
    public RawGround(ITerrainGrid grid) => _mesh = new FacetMesh(grid);

    /// <summary>The model.</summary>
    public ITerrainGrid Grid => _mesh.Grid;

    /// <summary>m: distance from the Moon's centre to the facet in a direction; null where the model has none.</summary>
    /// <param name="direction">Unit vector, body-fixed.</param>
    public double? RadiusAt(Vector3D direction) =>
        _mesh.Grid.MayHaveGaps && !HasData(direction, Around) ? null : TerrainHeight.RadiusOn(_mesh, direction);

    /// <summary>Whether a model has data in a direction, and some samples around it.</summary>
    /// <param name="direction">Unit vector, body-fixed.</param>
    /// <param name="margin">Samples around the cell.</param>
    public bool HasData(Vector3D direction, int margin)
    {
        if (_mesh.IsClosed)
        {
            return true;
        }

        if (_mesh.PlaceOf(direction) is not (double line, double sample))
        {
            return false;
        }

        (int first, int left) = ((int)line - margin, (int)sample - margin);
        CellRange all = _mesh.Cells;
        bool isRing = _mesh.SamplesOfTurn == all.Samples;
        int side = (2 * margin) + 2;
        if (margin > Around && (first < all.FirstLine || first + side > all.EndLine + 1
            || (!isRing && (left < all.FirstSample || left + side > all.EndSample + 1))))
        {
            return false;
        }

        if (!Grid.MayHaveGaps)
        {
            return true;
        }

        Span<bool> gap = stackalloc bool[1];
        for (int i = 0; i < side * side; i++)
        {
            (int row, int column) = (first + (i / side), left + (i % side));
            column = isRing ? (column + _mesh.Samples) % _mesh.Samples : Math.Clamp(column, all.FirstSample, all.EndSample);
            Grid.ReadGaps(Math.Clamp(row, all.FirstLine, all.EndLine), column, gap);
            if (gap[0])
            {
                return false;
            }
        }

        return true;
    }
}
