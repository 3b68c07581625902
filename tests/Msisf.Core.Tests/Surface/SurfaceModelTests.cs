using Msisf.Core.Numerics;
using Msisf.Core.Surface;
using Msisf.Core.Tiles;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Surface;

public sealed class SurfaceModelTests
{
    /// <summary>The facets of a tile in the order of the pattern format: north fan, cells, south fan.</summary>
    [Theory]
    [InlineData(85, 355)]
    [InlineData(0, 0)]
    [InlineData(-90, 180)]
    public void Corners_CellsOfATile_AreTheFacetsOfItsPattern(int southDegrees, int westDegrees)
    {
        FunctionGrid grid = FunctionGrid.Rough(4);
        SurfaceModel surface = new(grid);
        TileId tile = new(southDegrees, westDegrees);
        TileMeshBuilder builder = new(grid);
        TileMeshLayout layout = TileMeshLayout.For(tile, 4, 0);
        TileMesh mesh = builder.Build(layout, builder.ReadRadii(layout));
        List<(Vector3D, Vector3D, Vector3D)> facets = [];
        for (int line = southDegrees == 85 ? -1 : tile.FirstLine(4); line < tile.FirstLine(4) + 20; line++)
        {
            for (int sample = tile.FirstSample(4); sample < tile.FirstSample(4) + 20; sample++)
            {
                CellCorners corners = surface.Parts[0].Corners(line, sample);
                facets.AddRange(line == 719 ? [] : [corners.Facet(FacetHalf.SouthWest)]);
                facets.AddRange(line == -1 ? [] : [corners.Facet(FacetHalf.NorthEast)]);
            }
        }

        Vector3D[] vertices = [.. mesh.Faces.Select(vertex => mesh.Vertex(vertex).PositionBodyFixed)];
        Assert.Equal(vertices.Chunk(3).Select(corner => (corner[0], corner[1], corner[2])), facets);
    }
}
