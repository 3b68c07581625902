using Msisf.Core.Camera;
using Msisf.Core.Parallel;
using Msisf.Core.Surface;

namespace Msisf.Core.Render.Visibility;

/// <summary>
/// Finds the facet that each pixel's centre ray meets first. Blocks of cells that may be visible are projected, and their facets are drawn
/// with a depth buffer into bands of rows. Each band is a separate task. One object serves many frames, one at a time.
/// </summary>
internal sealed class VisibilityPass
{
    private SurfaceModel _surface;
    private BlockCuller _culler;
    private readonly VisibleSurface _result = new();
    private readonly List<BandWorker> _workers = [];
    private readonly LensCache _lenses;
    private readonly LensSamples _unshared = new();

    /// <param name="surface">The surface; blocks are read when they are first needed.</param>
    /// <param name="lenses">Samples of lenses that other passes use too; null for own ones.</param>
    public VisibilityPass(SurfaceModel surface, LensCache? lenses = null)
    {
        _lenses = lenses ?? new LensCache();
        _surface = surface;
        _culler = new BlockCuller(surface);
    }

    /// <summary>Draws another surface from the next frame on; the memory is kept.</summary>
    public void Show(SurfaceModel surface)
    {
        _surface = surface;
        _culler = new BlockCuller(surface);
        Blocks = [];
    }

    /// <summary>What the last frame shows.</summary>
    public VisibleSurface Surface => _result;

    /// <summary>The projection of the last frame.</summary>
    public ImageView View { get; private set; } = null!;

    /// <summary>The blocks that the last frame may show; valid until the next one.</summary>
    public IReadOnlyList<VisibleBlock> Blocks { get; private set; } = [];

    /// <summary>The samples of the last frame's lens; null for a pinhole.</summary>
    public LensSamples? Lens { get; private set; }

    /// <summary>Draws a frame.</summary>
    /// <param name="threads">Maximum number of threads; the result does not depend on it.</param>
    /// <param name="cancellation">Ends the work between two bands.</param>
    /// <returns>The same object each time; valid until the next call.</returns>
    /// <exception cref="OperationCanceledException">It was cancelled.</exception>
    /// <exception cref="Errors.BadInputException">The elevation model holds what can't be right.</exception>
    public VisibleSurface Run(FrameCamera camera, int threads, CancellationToken cancellation)
    {
        List<VisibleBlock> blocks = Prepare(camera, threads, cancellation);
        (ImageView view, LensSamples? lens) = (View, Lens);
        _result.Begin(view, lens);
        while (_workers.Count < threads)
        {
            _workers.Add(new BandWorker());
        }

        VisibilityCounts[] counts = new VisibilityCounts[_result.BandCount];
        WorkerTeam.Run(
            threads,
            counts.Length,
            (worker, band) => counts[band] = lens is null
                ? _workers[worker].Draw(_surface, view, blocks, _result.BeginBand(band))
                : _workers[worker].Draw(_surface, view, lens, band, blocks, _result.BeginBand(band)),
            cancellation);
        _result.End(counts.Aggregate(new VisibilityCounts(blocks.Count, 0, 0, 0), (sum, next) => sum + next));
        return _result;
    }

    /// <summary>Finds the blocks that a frame may show, without drawing it; parameters and errors are those of <see cref="Run"/>.</summary>
    public List<VisibleBlock> Prepare(FrameCamera camera, int threads, CancellationToken cancellation)
    {
        Lens = LensOf(camera, threads, cancellation);
        View = new ImageView(camera, Lens);
        List<VisibleBlock> blocks = _culler.Find(View.Frustum(), threads, cancellation);
        Blocks = blocks;
        return blocks;
    }

    /// <summary>Further samples of the last frame's lens; null for a pinhole, or if they would need too much memory.</summary>
    public LensSubsamples? FindLens(SamplePattern pattern, int threads, CancellationToken cancellation) =>
        Lens is null ? null : _lenses.FindFurther(View.Camera.Model, Lens, pattern, threads, cancellation);

    private LensSamples? LensOf(FrameCamera camera, int threads, CancellationToken cancellation)
    {
        if (camera.Model.Lens is null)
        {
            return null;
        }

        if (_lenses.Find(camera.Model, threads, cancellation) is { } shared)
        {
            return shared;
        }

        if (!_unshared.IsOf(camera.Model))
        {
            _unshared.Prepare(camera.Model, threads, cancellation);
        }

        return _unshared;
    }
}

/// <summary>Counts of the work for a frame; they do not depend on the number of threads.</summary>
/// <param name="VisibleBlocks">Number of blocks that may be visible.</param>
/// <param name="BlocksRead">Number of block reads; a block is read once for each band of rows that it touches.</param>
/// <param name="CellsSieved">Number of cells that were tested.</param>
/// <param name="FacetsDrawn">Number of facets that were the nearest one at some pixel, at least temporarily.</param>
internal readonly record struct VisibilityCounts(int VisibleBlocks, long BlocksRead, long CellsSieved, long FacetsDrawn)
{
    public static VisibilityCounts operator +(VisibilityCounts a, VisibilityCounts b) => new(
        a.VisibleBlocks + b.VisibleBlocks, a.BlocksRead + b.BlocksRead, a.CellsSieved + b.CellsSieved, a.FacetsDrawn + b.FacetsDrawn);
}
