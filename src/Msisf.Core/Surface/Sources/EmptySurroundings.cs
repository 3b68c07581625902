using Msisf.Core.Terrain;

namespace Msisf.Core.Surface.Sources;

/// <summary>
/// The surroundings of several maps without a model of the whole Moon: a sphere whose cells end the gaps around the maps. It is the first
/// part while the gaps are filled; nothing of it stays in the surface. Immutable.
/// </summary>
internal sealed class EmptySurroundings(double referenceRadius) : IGlobalGrid
{
    /// <summary>
    /// Longest side of a facet between two maps, in cells of the coarser one. Gaps between cells are less than two cells wide, and a facet
    /// of them reaches over one cell of a border; wider ones lie between maps that do not touch.
    /// </summary>
    private const double MaxCells = 4.0;

    /// <inheritdoc/>
    public string ProductId => "nothing";

    /// <inheritdoc/>
    public int PixelsPerDegree => 1;

    /// <inheritdoc/>
    public MapProjection Projection { get; } = new Equirectangular(1);

    /// <inheritdoc/>
    public int Lines => 180;

    /// <inheritdoc/>
    public int Samples => 360;

    /// <inheritdoc/>
    public double ReferenceRadius => referenceRadius;

    /// <inheritdoc/>
    public void ReadRadii(int line, int firstSample, Span<double> radii) => radii.Fill(referenceRadius);

    /// <summary>Puts the surroundings before maps.</summary>
    /// <param name="maps">The maps with their cells.</param>
    public static IReadOnlyList<GridPatch> Before(IReadOnlyList<GridPatch> maps)
    {
        GridPatch around = new(new EmptySurroundings(maps[0].Grid.ReferenceRadius));
        return [around.WithCells(KeptCells.Of(around, [.. maps.Where(map => !map.IsLeftOut)])), .. maps];
    }

    /// <summary>
    /// The facets between maps that touch: without those at the surroundings, between maps that lie apart, and in holes of a map below
    /// which there is no other.
    /// </summary>
    /// <param name="parts">The surroundings, and the maps after them.</param>
    /// <param name="corners">Three indices of vertices for each facet.</param>
    public static int[] RemoveFrom(IReadOnlyList<GridPatch> parts, SeamVertex[] vertices, int[] corners)
    {
        UnionFind together = new(vertices.Length);
        List<int> near = [];
        for (int i = 0; i < corners.Length; i += 3)
        {
            int[] facet = corners[i..(i + 3)];
            if (facet.All(corner => vertices[corner].Part > 0) && IsNear(parts, vertices, facet))
            {
                near.AddRange(facet);
                together.Unite(facet[0], facet[1]);
                together.Unite(facet[0], facet[2]);
            }
        }

        const int Joined = -1;
        Dictionary<int, int> partOf = [];
        foreach (int corner in near)
        {
            int group = together.Of(corner);
            int part = vertices[corner].Part;
            bool isJoined = partOf.GetValueOrDefault(group, part) != part || IsOnAnother(parts, vertices[corner]);
            partOf[group] = isJoined ? Joined : part;
        }

        return [.. near.Where(corner => partOf[together.Of(corner)] == Joined)];
    }

    /// <summary>Whether another map lies below a corner: it fills a hole in which it has no room for a cell.</summary>
    private static bool IsOnAnother(IReadOnlyList<GridPatch> parts, SeamVertex vertex)
    {
        Vector3D direction = vertex.Position.Normalized();
        return parts.Skip(1).Where((part, number) => number + 1 != vertex.Part && !part.IsLeftOut)
            .Any(part => part.Mesh.PlaceOf(direction) is not null);
    }

    private static bool IsNear(IReadOnlyList<GridPatch> parts, SeamVertex[] vertices, int[] facet)
    {
        double longest = MaxCells * facet.Max(corner => parts[vertices[corner].Part].Grid.Projection.Resolution.MetresPerPixel);
        return Enumerable.Range(0, 3).All(
            side => (vertices[facet[side]].Position - vertices[facet[(side + 1) % 3]].Position).Length <= longest);
    }
}
