using Msisf.Adapters.Tiles;
using Msisf.App.Preparation;
using Msisf.Core.Camera;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;
using Msisf.Core.Tiles;
using Msisf.Core.Tracing;

namespace Msisf.App.Rendering;

/// <summary>One model of the whole Moon, of which scenes include tiles or parts of tiles at levels of detail. Thread-safe.</summary>
/// <param name="errorPixels">px: how far levels of detail may shift a point in the image; null for whole tiles without levels.</param>
/// <param name="repository">The folder of the patterns; disposed with this object.</param>
internal sealed class TileSurface(ElevationModel model, double? errorPixels, PatternRepository repository) : ISceneSurface
{
    private readonly ElevationModel _model = model;
    private readonly double? _errorPixels = errorPixels;
    private readonly PatternRepository _repository = repository;
    private readonly LevelMeshBuilders _builders = new(model.WholeMoon, () => model.Levels);
    private readonly ReadyPatterns<SurfacePart> _ready = new();

    public string Folder => _repository.FolderOf(_builders.PixelsPerDegree);

    public string FolderName => _builders.PixelsPerDegree.ToString(CultureInfo.InvariantCulture);

    public int Count => _ready.Count;

    public ISceneMeshes Select(Frame frame, int threads, CancellationToken cancellation) =>
        new Meshes(this, frame, _model.SelectParts(frame, _errorPixels));

    public void Dispose() => _repository.Dispose();

    private sealed class Meshes(TileSurface surface, Frame frame, IReadOnlyList<SurfacePart> parts) : ISceneMeshes
    {
        public IReadOnlyList<string> FileNames { get; } = NamesOf(surface, parts);

        public long Faces =>
            parts.Sum(part => (long)TileMesh.CountsOf(TileMeshLayout.For(part, surface._builders.PixelsPerDegree)).Faces);

        public (GridResolution Finest, GridResolution Coarsest) Levels => (
            surface._builders.PixelsPerDegree >> parts.Select(part => part.Level).DefaultIfEmpty().Min(),
            surface._builders.PixelsPerDegree >> parts.Select(part => part.Level).DefaultIfEmpty().Max());

        public IReadOnlyList<GridResolution?> PartResolutions => [];

        public SceneAxes Axes => SceneAxes.MoonKilometres;

        public GridResolution TracedResolution => surface._model.Grid.Resolution;

        public ITerrainTracer Tracer => surface._model.Tracer;

        public int Ensure(CancellationToken cancellation) => surface._ready.Ensure(
            parts,
            unknown => surface._repository.EnsureParts(unknown, surface._builders, Environment.ProcessorCount, cancellation));

        /// <summary>
        /// Parts selected for the whole image: those selected for one strip could be coarser where shadows fall outside its rows, and the
        /// pixels would depend on the number of strips.
        /// </summary>
        public IReadOnlyList<string> FileNamesFor(PixelRows rows, CancellationToken cancellation)
        {
            PartArea area = new(surface._model.SelectParts(frame, surface._errorPixels, rows));
            return NamesOf(surface, parts.Where(area.Overlaps));
        }

        private static string[] NamesOf(TileSurface surface, IEnumerable<SurfacePart> parts) =>
            [.. parts.Select(part => Path.GetFileName(surface._repository.PathOf(part, surface._builders.PixelsPerDegree)))];
    }
}
