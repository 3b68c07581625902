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
internal sealed class BlockSurface : ISceneSurface
{
    /// <summary>Bytes of memory that POV-Ray 3.7 needs for a triangle, measured (docs/performance.md).</summary>
    private const long PovRayBytesPerFace = 240;

    private readonly ITerrain _terrain;
    private readonly IFrameTerrain _detail;
    private readonly int _subsamplesPerAxis;
    private readonly PatternRepository _repository;
    private readonly ConditionalWeakTable<ITerrain, BlockLevel> _levels = [];
    private readonly ReadyPatterns<(string Level, SceneBlock Block)> _ready = new();

    /// <param name="terrain">The models themselves.</param>
    /// <param name="detail">Chooses the levels of a frame.</param>
    /// <param name="subsamplesPerAxis">Samples along a pixel's edge for which it does.</param>
    /// <param name="repository">The folder of the patterns; disposed with this object.</param>
    public BlockSurface(ITerrain terrain, IFrameTerrain detail, int subsamplesPerAxis, PatternRepository repository) =>
        (_terrain, _detail, _subsamplesPerAxis, _repository) = (terrain, detail, subsamplesPerAxis, repository);

    public string Folder => _repository.FolderOf(FolderName);

    public string FolderName => BlockPatterns.FolderNameOf(_terrain);

    public int Count => _ready.Count;

    /// <inheritdoc/>
    /// <exception cref="BadInputException">The scene needs more memory than there is.</exception>
    public ISceneMeshes Select(Frame frame, int threads, CancellationToken cancellation)
    {
        BlockLevel level = _levels.GetValue(
            _detail.For(frame.Camera, _subsamplesPerAxis), drawn => new BlockLevel(_terrain, drawn, _repository));
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
