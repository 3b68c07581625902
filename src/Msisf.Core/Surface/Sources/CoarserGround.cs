namespace Msisf.Core.Surface.Sources;

/// <summary>The surface of the models coarser than one, in any direction. Safe for several threads.</summary>
internal sealed class CoarserGround
{
    private readonly FacetMesh[] _meshes;

    /// <summary>Takes the models.</summary>
    /// <param name="coarser">The models, the coarsest first; that is one of the whole Moon.</param>
    public CoarserGround(IEnumerable<GridPatch> coarser) =>
        _meshes = [.. coarser.Where(part => !part.IsLeftOut).Select(part => part.Mesh).Reverse()];

    /// <summary>Minimum and maximum radius of the models' samples, m.</summary>
    public (double Min, double Max) RadiusLimits =>
        (_meshes.Min(mesh => mesh.Grid.RadiusLimits.Min), _meshes.Max(mesh => mesh.Grid.RadiusLimits.Max));

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

        throw new InvalidOperationException($"The coarsest model has no facet in direction {direction}.");
    }

    /// <summary>rad: upper bound of the sides of a cell of the finest model in a direction.</summary>
    public double CellAngleAt(Vector3D direction) =>
        _meshes.First(mesh => TerrainHeight.RadiusOn(mesh, direction) is not null) is { } found
            ? found.Grid.Projection.Resolution.MetresPerPixel / Terrain.MoonConstants.ReferenceRadius
            : double.NaN;
}
