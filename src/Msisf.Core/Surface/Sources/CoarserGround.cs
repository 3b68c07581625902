namespace Msisf.Core.Surface.Sources;

/// <summary>The surface of the models coarser than one, in any direction. Safe for several threads.</summary>
internal sealed class CoarserGround
{
    private readonly FacetMesh[] _meshes;
    private readonly double _referenceRadius;

    /// <summary>Takes the models.</summary>
    /// <param name="coarser">The models, the coarsest first.</param>
    /// <param name="referenceRadius">m: the sphere that counts where there is no model.</param>
    public CoarserGround(IEnumerable<GridPatch> coarser, double referenceRadius)
    {
        _meshes = [.. coarser.Where(part => !part.IsLeftOut).Select(part => part.Mesh).Reverse()];
        _referenceRadius = referenceRadius;
    }

    /// <summary>Minimum and maximum radius of the models' samples, m, and of the sphere if the models leave a part of it.</summary>
    public (double Min, double Max) RadiusLimits
    {
        get
        {
            IEnumerable<(double Min, double Max)> limits = _meshes.Select(mesh => mesh.Grid.RadiusLimits);
            limits = _meshes.Any(mesh => mesh.IsClosed) ? limits : limits.Append((_referenceRadius, _referenceRadius));
            return (limits.Min(limit => limit.Min), limits.Max(limit => limit.Max));
        }
    }

    /// <summary>Distance from the Moon's centre to the facet in a direction, of the finest model there, m.</summary>
    public double RadiusAt(Vector3D direction)
    {
        foreach (FacetMesh mesh in _meshes)
        {
            if (TerrainHeight.RadiusOn(mesh, direction) is { } radius)
            {
                return radius;
            }
        }

        return _referenceRadius;
    }

    /// <summary>rad: upper bound of the sides of a cell of the finest model in a direction.</summary>
    public double CellAngleAt(Vector3D direction) =>
        _meshes.First(mesh => TerrainHeight.RadiusOn(mesh, direction) is not null) is { } found
            ? found.Grid.Projection.Resolution.MetresPerPixel / Terrain.MoonConstants.ReferenceRadius
            : double.NaN;
}
