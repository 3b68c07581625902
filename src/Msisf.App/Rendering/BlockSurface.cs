using System.Runtime.CompilerServices;
using Msisf.Adapters.Tiles;
using Msisf.App.Preparation;
using Msisf.Core.Blocks;
using Msisf.Core.Camera;
using Msisf.Core.Lod;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;
using Msisf.Core.Tracing;

namespace Msisf.App.Rendering;

/// <summary>
/// A map of a part of the Moon, or several models, of which scenes include blocks, of the same levels of detail as the native renderer
/// draws. Thread-safe.
/// </summary>
/// <param name="terrain">The models themselves.</param>
/// <param name="detail">Chooses the levels of a frame.</param>
/// <param name="subsamplesPerAxis">Samples along a pixel's edge for which it does.</param>
/// <param name="repository">The folder of the patterns; disposed with this object.</param>
internal sealed class BlockSurface(ITerrain terrain, IFrameTerrain detail, int subsamplesPerAxis, PatternRepository repository)
    : ISceneSurface
{
    /// <summary>Bytes of memory that POV-Ray 3.7 needs for a triangle, measured (docs/performance.md).</summary>
    private const long PovRayBytesPerFace = 240;

    private readonly ITerrain _terrain = terrain;
    private readonly PatternRepository _repository = repository;
    private readonly ConditionalWeakTable<ITerrain, BlockLevel> _levels = [];
    private readonly ReadyPatterns<(string Level, SceneBlock Block)> _ready = new();

    public string Folder => _repository.FolderOf(FolderName);

    public string FolderName => BlockPatterns.FolderNameOf(_terrain);

    public int Count => _ready.Count;

    /// <inheritdoc/>
    /// <exception cref="BadInputException">The scene needs more memory than there is.</exception>
    public ISceneMeshes Select(Frame frame, int threads, CancellationToken cancellation)
    {
        BlockLevel level = _levels.GetValue(
            detail.For(frame.Camera, subsamplesPerAxis), drawn => new BlockLevel(_terrain, drawn, _repository));
        Meshes meshes = new(this, level, frame, BlocksOf(level, frame, null, threads, cancellation));
        long memory = GC.GetGCMemoryInfo().TotalAvailableMemoryBytes;
        return meshes.Faces * PovRayBytesPerFace <= memory ? meshes : throw new BadInputException(Invariant(
            $"{frame.Name}: the scene has some {meshes.Faces / 1_000_000} million triangles, for which POV-Ray needs about "
                + $"{meshes.Faces * PovRayBytesPerFace >> 30} GiB of memory; {memory >> 30} are there. Take --renderer native, or models "
                + $"with wider cells."));
    }

    public void Dispose() => _repository.Dispose();

    private static IReadOnlyList<SceneBlock> BlocksOf(
        BlockLevel level, Frame frame, PixelRows? rows, int threads, CancellationToken cancellation)
    {
        Vector3D? sun = frame.Light.IsSun ? frame.Light.PositionBodyFixed : null;
        return level.Blocks.Select(frame.Camera, sun, rows, threads, cancellation);
    }

    private sealed class Meshes(BlockSurface surface, BlockLevel level, Frame frame, IReadOnlyList<SceneBlock> blocks) : ISceneMeshes
    {
        public IReadOnlyList<string> FileNames { get; } = [.. blocks.Select(level.Patterns.FileNameOf)];

        public long Faces { get; } = level.Blocks.CountFaces(blocks);

        public (GridResolution Finest, GridResolution Coarsest) Levels => (level.Resolution, level.Resolution);

        public IReadOnlyList<GridResolution?> PartResolutions => level.PartResolutions;

        public SceneAxes Axes { get; } = SceneAxes.For(
            frame.Camera.PositionBodyFixed, surface._terrain.RadiusLimits.Max, level.Resolution.MetresPerPixel);

        public GridResolution TracedResolution => level.Resolution;

        public ITerrainTracer Tracer => level.Tracer;

        public int Ensure(CancellationToken cancellation) => surface._ready.Ensure(
            blocks.Select(block => (level.Name, block)),
            unknown => level.Patterns.Ensure(unknown.Select(wanted => wanted.Block), Environment.ProcessorCount, cancellation));

        /// <summary>
        /// Either selection has all that the rows need, and the bounds of some blocks are tighter in one than in the other.
        /// </summary>
        public IReadOnlyList<string> FileNamesFor(PixelRows rows, CancellationToken cancellation)
        {
            HashSet<SceneBlock> ofRows = [.. BlocksOf(level, frame, rows, threads: 1, cancellation)];
            return [.. blocks.Where(ofRows.Contains).Select(level.Patterns.FileNameOf)];
        }
    }
}

/// <summary>A surface as frames show it, at one level of each model, as blocks with their patterns. Thread-safe.</summary>
internal sealed class BlockLevel
{
    private readonly Lazy<TerrainTracer> _tracer;

    /// <param name="models">The models themselves.</param>
    /// <param name="drawn">They at the levels that are drawn.</param>
    /// <param name="repository">The folder of the patterns.</param>
    public BlockLevel(ITerrain models, ITerrain drawn, PatternRepository repository)
    {
        Name = NameOf(ResolutionsOf(models), ResolutionsOf(drawn));
        Resolution = drawn.Resolution;
        PartResolutions = drawn.DrawnResolutions;
        Blocks = new SceneBlocks(drawn);
        Patterns = new BlockPatterns(repository, Blocks, drawn, Name);
        _tracer = new Lazy<TerrainTracer>(() => new TerrainTracer(drawn));
    }

    /// <summary>The level of each model, "x" for one that is left out; empty for the models themselves.</summary>
    public string Name { get; }

    /// <summary>Resolution of the finest model that is drawn.</summary>
    public GridResolution Resolution { get; }

    /// <summary>Resolution at which each of several models is drawn; null for one that is left out. Empty for one model.</summary>
    public IReadOnlyList<GridResolution?> PartResolutions { get; }

    public SceneBlocks Blocks { get; }

    public BlockPatterns Patterns { get; }

    /// <summary>Traces single rays; created on first use.</summary>
    public ITerrainTracer Tracer => _tracer.Value;

    private static IReadOnlyList<GridResolution?> ResolutionsOf(ITerrain terrain) =>
        terrain.DrawnResolutions is { Count: > 0 } several ? several : [terrain.Resolution];

    private static string NameOf(IReadOnlyList<GridResolution?> models, IReadOnlyList<GridResolution?> drawn)
    {
        int?[] levels = [.. models.Zip(drawn, (model, level) => level is { } there ? model!.Value.HalvingsTo(there) : (int?)null)];
        return levels.All(level => level == 0)
            ? string.Empty
            : string.Join('-', levels.Select(level => level?.ToString(CultureInfo.InvariantCulture) ?? "x"));
    }
}
