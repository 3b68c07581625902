using Msisf.Adapters.Tiles;
using Msisf.App.Preparation;
using Msisf.Core.Camera;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;
using Msisf.Core.Tiles;
using Msisf.Core.Tracing;

namespace Msisf.App.Rendering;

/// <summary>One model of the whole Moon, of which scenes include the thesis's tiles. Thread-safe.</summary>
/// <param name="repository">The folder of the patterns; disposed with this object.</param>
internal sealed class TileSurface(ElevationModel model, PatternRepository repository) : ISceneSurface
{
    private readonly ElevationModel _model = model;
    private readonly ReadyPatterns<TileId> _ready = new();

    public string Folder => repository.FolderOf(PixelsPerDegree);

    public string FolderName => PixelsPerDegree.ToString(CultureInfo.InvariantCulture);

    public int Count => _ready.Count;

    public ISceneMeshes Select(Frame frame, int threads, CancellationToken cancellation) =>
        new Meshes(this, [.. _model.Select(frame, threads, cancellation).Kept.Select(choice => choice.Tile)]);

    public void Dispose() => repository.Dispose();

    private int PixelsPerDegree => _model.WholeMoon.PixelsPerDegree;

    private int Ensure(IReadOnlyList<TileId> tiles, CancellationToken cancellation) => _ready.Ensure(
        tiles,
        unknown => repository.EnsurePatterns(
            unknown, _model.WholeMoon, default, Environment.ProcessorCount, cancellation: cancellation));

    private string NameOf(TileId tile) => Path.GetFileName(repository.PathOf(tile, PixelsPerDegree));

    private sealed class Meshes(TileSurface surface, IReadOnlyList<TileId> tiles) : ISceneMeshes
    {
        public IReadOnlyList<string> FileNames { get; } = [.. tiles.Select(surface.NameOf)];

        public long Faces => tiles.Sum(tile => (long)TileMeshLayout.For(tile, surface.PixelsPerDegree).FaceCount);

        public (GridResolution Finest, GridResolution Coarsest) Levels => (surface.PixelsPerDegree, surface.PixelsPerDegree);

        public IReadOnlyList<GridResolution?> PartResolutions => [];

        public SceneAxes Axes => SceneAxes.MoonKilometres;

        public GridResolution TracedResolution => surface.PixelsPerDegree;

        public ITerrainTracer Tracer => surface._model.Tracer;

        public int Ensure(CancellationToken cancellation) => surface.Ensure(tiles, cancellation);

        /// <remarks>Tiles are drawn in one strip.</remarks>
        public IReadOnlyList<string> FileNamesFor(PixelRows rows, CancellationToken cancellation) => FileNames;
    }
}
