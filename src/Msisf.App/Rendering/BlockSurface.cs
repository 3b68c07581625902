using System.Globalization;
using Msisf.Adapters.Tiles;
using Msisf.App.Preparation;
using Msisf.Core.Blocks;
using Msisf.Core.Camera;
using Msisf.Core.Errors;
using Msisf.Core.Mesh.Nesting;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;

namespace Msisf.App.Rendering;

/// <summary>
/// A map of a part of the Moon, or several models, of which scenes include blocks, always of the models themselves. Thread-safe.
/// </summary>
internal sealed class BlockSurface : ISceneSurface
{
    /// <summary>Bytes of memory that POV-Ray 3.7 needs for a triangle, measured (docs/performance.md).</summary>
    private const long PovRayBytesPerFace = 240;

    private readonly ITerrain _terrain;
    private readonly SceneBlocks _blocks;
    private readonly PatternRepository _repository;
    private readonly BlockPatterns _patterns;
    private readonly ReadyPatterns<SceneBlock> _ready = new();

    /// <param name="terrain">The surface.</param>
    /// <param name="repository">The folder of the patterns; disposed with this object.</param>
    public BlockSurface(ITerrain terrain, PatternRepository repository)
    {
        _terrain = terrain;
        _repository = repository;
        _blocks = new SceneBlocks(terrain);
        _patterns = new BlockPatterns(repository, _blocks, terrain);
    }

    /// <inheritdoc/>
    public string Folder => _patterns.Folder;

    /// <inheritdoc/>
    public string FolderName => _patterns.FolderName;

    /// <inheritdoc/>
    public int Count => _ready.Count;

    /// <inheritdoc/>
    /// <exception cref="BadInputException">The scene needs more memory than there is.</exception>
    public ISceneMeshes Select(Frame frame, int threads, CancellationToken cancellation)
    {
        Meshes meshes = new(this, frame, BlocksOf(frame, null, threads, cancellation));
        long memory = GC.GetGCMemoryInfo().TotalAvailableMemoryBytes;
        return meshes.Faces * PovRayBytesPerFace <= memory ? meshes : throw new BadInputException(string.Create(
            CultureInfo.InvariantCulture,
            $"{frame.Name}: the scene has some {meshes.Faces / 1_000_000} million triangles, for which POV-Ray needs about "
                + $"{meshes.Faces * PovRayBytesPerFace >> 30} GiB of memory; {memory >> 30} are there. Take --renderer native, or models "
                + $"with wider cells."));
    }

    /// <inheritdoc/>
    public void Dispose() => _repository.Dispose();

    private IReadOnlyList<SceneBlock> BlocksOf(Frame frame, PixelRows? rows, int threads, CancellationToken cancellation)
    {
        Vector3D? sun = frame.Light.IsSun ? frame.Light.PositionMoonMe : null;
        return _blocks.Select(frame.Camera, sun, rows, threads, cancellation);
    }

    private sealed class Meshes(BlockSurface surface, Frame frame, IReadOnlyList<SceneBlock> blocks) : ISceneMeshes
    {
        public IReadOnlyList<string> FileNames { get; } = [.. blocks.Select(surface._patterns.FileNameOf)];

        public long Faces { get; } = surface._blocks.CountFaces(blocks);

        public (GridResolution Finest, GridResolution Coarsest) Levels => (surface._terrain.Resolution, surface._terrain.Resolution);

        public IReadOnlyList<GridResolution?> PartResolutions =>
            surface._terrain is NestedTerrain nested
                ? [.. nested.Models.Select(model => (GridResolution?)model.Projection.Resolution)]
                : [];

        public int Ensure(CancellationToken cancellation) => surface._ready.Ensure(
            blocks, unknown => surface._patterns.Ensure(unknown, Environment.ProcessorCount, cancellation));

        /// <summary>
        /// Either selection has all that the rows need, and the bounds of some blocks are tighter in one than in the other.
        /// </summary>
        public IReadOnlyList<string> FileNamesFor(PixelRows rows, CancellationToken cancellation)
        {
            HashSet<SceneBlock> ofRows = [.. surface.BlocksOf(frame, rows, threads: 1, cancellation)];
            return [.. blocks.Where(ofRows.Contains).Select(surface._patterns.FileNameOf)];
        }
    }
}
