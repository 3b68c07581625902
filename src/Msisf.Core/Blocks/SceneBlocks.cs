using Msisf.Core.Camera;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;

namespace Msisf.Core.Blocks;

/// <summary>
/// The surface of any terrain as blocks of facets for a scene of POV-Ray: which of them an image needs, and their meshes
/// (docs/pattern-format.md). Safe for several threads.
/// </summary>
public sealed class SceneBlocks : ISceneGroups<SceneBlock>
{
    /// <summary>
    /// rad: maximum width of a square, so that its vertices are less than <see cref="BlockMesh.OffsetLimit"/> steps of 2^-7 m from its
    /// middle.
    /// </summary>
    private const double MaxWidth = 5.0 * Math.PI / 180.0;

    private readonly SurfaceModel _surface;
    private readonly int[] _sides;

    /// <summary>Takes a terrain; of several models the seams are made if they were not yet.</summary>
    public SceneBlocks(ITerrain terrain)
    {
        _surface = SurfaceModel.Of(terrain);
        _sides = [.. _surface.Patches.Select(patch => SideOf(patch.CellAngle))];
    }

    /// <summary>Whether the surface goes around the whole Moon, so that no ray can meet it from below.</summary>
    public bool IsClosed => _surface.IsClosed;

    /// <summary>PRODUCT_ID of a block's model; null for seams.</summary>
    public string? ProductIdOf(SceneBlock block) => _surface.Patches[block.Part].ProductId;

    /// <summary>
    /// Selects the blocks that an image needs: all that may be seen in sunlight, all that may throw a shadow on these, and dark ones behind
    /// which something lit would show. A ray of the image, one pixel wider all around, first meets the same facet from outside as with the
    /// whole surface, and so does a ray from there to the Sun; dark ground may be missing where nothing but the sky is behind it.
    /// </summary>
    /// <param name="camera">The camera, without a lens.</param>
    /// <param name="sunPositionBodyFixed">m, body-fixed; null if the light is at the camera, where it casts no visible shadow.</param>
    /// <param name="rows">The rows of the image that matter; null for all.</param>
    /// <returns>The blocks in order.</returns>
    /// <exception cref="BadInputException">The Sun is not outside the terrain, or a model is damaged.</exception>
    public IReadOnlyList<SceneBlock> Select(
        ICamera camera, Vector3D? sunPositionBodyFixed, PixelRows? rows, int threads, CancellationToken cancellation)
    {
        IReadOnlyDictionary<SceneBlock, SceneReason> reasons = SceneSelection<SceneBlock>.Select(
            _surface, this, camera, sunPositionBodyFixed, rows, threads, cancellation);
        return [.. reasons.Where(block => block.Value != SceneReason.Night).Select(block => block.Key).Order()];
    }

    IEnumerable<SceneBlock> ISceneGroups<SceneBlock>.GroupsOf(SurfaceNode node)
    {
        Patch patch = _surface.Patches[node.Part];
        int side = _sides[node.Part];
        CellRange all = patch.Layout.AllCells;
        CellRange cells = patch.Layout.Cells(node.Place.Level, node.Place.Row, node.Place.Column);
        return
            from row in NumbersOf(cells.FirstLine - all.FirstLine, cells.EndLine - all.FirstLine, side)
            from column in NumbersOf(cells.FirstSample - all.FirstSample, cells.EndSample - all.FirstSample, side)
            let block = new SceneBlock(node.Part, row, column)
            where patch.Kept?.HasAny(CellsOf(block)) != false
            select block;
    }

    IEnumerable<SurfaceNode> ISceneGroups<SceneBlock>.NodesOf(SceneBlock block)
    {
        int level = SceneSelection.LevelOf(_surface.Patches[block.Part]);
        int side = SquareLayout.Side(level);
        CellRange all = _surface.Patches[block.Part].Layout.AllCells;
        CellRange cells = CellsOf(block);
        return
            from row in NumbersOf(cells.FirstLine - all.FirstLine, cells.EndLine - all.FirstLine, side)
            from column in NumbersOf(cells.FirstSample - all.FirstSample, cells.EndSample - all.FirstSample, side)
            select new SurfaceNode(block.Part, new NodePlace(level, row, column));
    }

    /// <summary>Number of facets of blocks; at poles, and beside finer models, an upper bound.</summary>
    public long CountFaces(IEnumerable<SceneBlock> blocks) =>
        blocks.Sum(block => _surface.Patches[block.Part].CountFacets(CellsOf(block)));

    /// <summary>The meshes of a block: one, or several where facets of seams reach far.</summary>
    /// <exception cref="BadInputException">The model can't be read, or a mesh is too large for its lattice.</exception>
    public IReadOnlyList<BlockMesh> MeshesOf(SceneBlock block) => _surface.Patches[block.Part] is GridPatch part
        ? [MeshOfCells(part, CellsOf(block))]
        : [.. MeshesOfSeams(block.Column * SeamPatch.BlockFacets, _surface.Seams.FacetsOf(block.Column))];

    private static int SideOf(double cellAngle)
    {
        int side = CellBlock.Size;
        while (side > 1 && side * cellAngle > MaxWidth)
        {
            side /= 2;
        }

        return side;
    }

    /// <summary>The numbers of the intervals of a length that have a part of a range.</summary>
    private static IEnumerable<int> NumbersOf(int first, int end, int length) =>
        Enumerable.Range(first / length, ((end - 1) / length) - (first / length) + 1);

    private CellRange CellsOf(SceneBlock block)
    {
        CellRange all = _surface.Patches[block.Part].Layout.AllCells;
        int side = _sides[block.Part];
        return new CellRange(
            all.FirstLine + (block.Row * side),
            Math.Min(all.FirstLine + ((block.Row + 1) * side), all.EndLine),
            all.FirstSample + (block.Column * side),
            Math.Min(all.FirstSample + ((block.Column + 1) * side), all.EndSample));
    }

    private static BlockMesh MeshOfCells(GridPatch part, CellRange cells)
    {
        BlockMeshBuilder mesh = new(part.Geometry.StepsPerMetre);
        double[] radii = new double[cells.Samples + 1];
        Vector3D[] north = [];
        for (int line = cells.FirstLine; line <= cells.EndLine; line++)
        {
            part.Mesh.ReadRadii(line, cells.FirstSample, radii);
            Vector3D[] south = new Vector3D[radii.Length];
            for (int i = 0; i < radii.Length; i++)
            {
                south[i] = part.Vertex(line, cells.FirstSample + i, radii[i]);
            }

            for (int i = 0; line > cells.FirstLine && i < cells.Samples; i++)
            {
                if (part.Has(line - 1, cells.FirstSample + i))
                {
                    CellCorners corners = new(north[i], north[i + 1], south[i], south[i + 1]);
                    mesh.Add(corners.Facet(FacetHalf.SouthWest));
                    mesh.Add(corners.Facet(FacetHalf.NorthEast));
                }
            }

            north = south;
        }

        return mesh.Build();
    }

    /// <summary>The meshes of some facets of seams, each of as many as its lattice can hold.</summary>
    private IEnumerable<BlockMesh> MeshesOfSeams(int first, int count)
    {
        SeamPatch seams = _surface.Seams;
        double stepsPerMetre = 0.0;
        for (int corner = 3 * first; corner < 3 * (first + count); corner++)
        {
            SeamVertex vertex = seams.VertexOf(corner / 3, corner % 3);
            stepsPerMetre = Math.Max(stepsPerMetre, _surface.Parts[vertex.Part].Geometry.StepsPerMetre);
        }

        BlockMeshBuilder mesh = new(stepsPerMetre);
        for (int facet = first; facet < first + count; facet++)
        {
            mesh.Add(seams.CornersOf(facet));
        }

        return mesh.IsInReach || count == 1
            ? [mesh.Build()]
            : MeshesOfSeams(first, count / 2).Concat(MeshesOfSeams(first + (count / 2), count - (count / 2)));
    }
}

/// <summary>
/// A piece of a surface that a scene includes as one mesh: a square of cells of a model, or some facets of the seams between models.
/// </summary>
/// <param name="Part">Number of the model; the number of models stands for the seams.</param>
/// <param name="Row">Row of the square from the top; 0 for seams.</param>
/// <param name="Column">Column of the square from the left; of seams their number.</param>
public readonly record struct SceneBlock(int Part, int Row, int Column) : IComparable<SceneBlock>
{
    /// <summary>By model, then place.</summary>
    public int CompareTo(SceneBlock other) => (Part, Row, Column).CompareTo((other.Part, other.Row, other.Column));
}
