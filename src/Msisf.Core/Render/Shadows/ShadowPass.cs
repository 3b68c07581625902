using Msisf.Core.Parallel;
using Msisf.Core.Surface;

namespace Msisf.Core.Render.Shadows;

/// <summary>
/// Finds exactly which points of an image terrain hides from the Sun. The surface is closed, so a ray that leaves it towards the Sun
/// first meets it again at a facet that faces away from the Sun. Only these facets are tested, so no point can hide itself.
/// One object is used for many frames, one at a time, and keeps its memory between them.
/// </summary>
internal sealed class ShadowPass
{
    /// <summary>Maximum number of blocks for which sorting only the bins that they may darken is faster than sorting all bins.</summary>
    private const int FewBlocks = 128;

    /// <summary>Number of bins along each edge of the grid of casters: about the pixels of an image.</summary>
    private const int CasterBins = 1024;

    private SurfaceModel _surface;
    private CasterSearch _search;
    private readonly ReceiverSort _receivers = new();
    private readonly CasterDepths _casters = new();
    private readonly List<CasterScan> _scans = [];

    /// <summary>Makes a pass for a model.</summary>
    public ShadowPass(SurfaceModel surface)
    {
        _surface = surface;
        _search = new CasterSearch(surface);
    }

    /// <summary>Finds the shadows of another surface from the next frame on; the memory of receivers is kept.</summary>
    public void Show(SurfaceModel surface)
    {
        _surface = surface;
        _search = new CasterSearch(surface);
        _scans.Clear();
    }

    /// <summary>Counts of the work for the last frame.</summary>
    public ShadowStatistics Statistics { get; private set; }

    /// <summary>Bytes of the arrays of receivers that have been replaced since the first frame.</summary>
    public long ReplacedBytes => _receivers.ReplacedBytes;

    /// <summary>Marks the receivers that are in shadow.</summary>
    /// <param name="receivers">The points whose facet faces the Sun.</param>
    /// <param name="sunBodyFixed">The Sun's centre, m, body-fixed.</param>
    /// <param name="hidden">One value for each pixel, row by row: 1 if terrain hides the Sun, 0 if not or if there is no receiver.</param>
    /// <param name="threads">Maximum number of threads, at least 1.</param>
    /// <exception cref="BadInputException">The Sun is not outside the terrain.</exception>
    public void Run(IReceiverRows receivers, Vector3D sunBodyFixed, byte[] hidden, int threads, CancellationToken cancellation)
    {
        Start(sunBodyFixed, threads);
        Array.Clear(hidden, 0, receivers.Rows * receivers.Width);

        LightSource sun = new(sunBodyFixed, Slope: 0.0);
        NightZone night = new(_search.SolidRadius, sun.Slope);
        ReceiverJob job = new(receivers, night, pixel => hidden[pixel] = 1, threads, cancellation);
        PlacedReceivers placed = _receivers.Read(job, sun);
        IReadOnlyList<CellBlock> blocks = placed.Box.IsEmpty ? [] : _search.Find(placed, sun.Slope, threads, cancellation);
        bool areFew = blocks.Count <= FewBlocks;
        if (areFew)
        {
            WorkerTeam.Run(threads, blocks.Count, (worker, item) => _scans[worker].WantBins(blocks[item], placed), cancellation);
        }

        SortedReceivers sorted = areFew ? placed.SortMarked() : placed.Sort();
        WorkerTeam.Run(threads, blocks.Count, (worker, item) => _scans[worker].Cast(blocks[item], sorted, hidden), cancellation);
        Statistics = new ShadowStatistics(
            placed.Length, _search.Groups, blocks.Count, _scans.Sum(scan => scan.Strips), _scans.Sum(scan => scan.Tries));
    }

    /// <summary>Prepares to tell the light of pieces of facets, without looking at their points one by one.</summary>
    /// <param name="blocks">The blocks in which the facets lie.</param>
    /// <param name="sunBodyFixed">The Sun's centre, m, body-fixed.</param>
    /// <param name="threads">Maximum number of threads, at least 1.</param>
    /// <param name="slope">Radius of the Sun's disc over its distance; 0 for a point.</param>
    /// <returns>Valid until the next call.</returns>
    public SureLight FindCasters(
        IEnumerable<CellBlock> blocks, Vector3D sunBodyFixed, double slope, int threads, CancellationToken cancellation)
    {
        Start(sunBodyFixed, threads);
        BlockReceivers receivers = new(_surface, blocks.Select(block => block.SurfaceNode), sunBodyFixed, _search.SolidRadius);
        _casters.Lay(receivers.Box, CasterBins);
        IReadOnlyList<CellBlock> found = receivers.Box.IsEmpty ? [] : _search.Find(receivers, slope, threads, cancellation);
        WorkerTeam.Run(
            threads, found.Count, (worker, item) => _scans[worker].Find(found[item], receivers, slope, _casters), cancellation);
        _casters.Finish();
        return new SureLight(receivers.Frame, _search.SolidRadius, slope, _casters);
    }

    private void Start(Vector3D sunBodyFixed, int threads)
    {
        _search.Check(sunBodyFixed);
        while (_scans.Count < threads)
        {
            _scans.Add(new CasterScan(_surface));
        }

        foreach (CasterScan scan in _scans)
        {
            scan.Start();
        }
    }
}

/// <summary>Counts of the work that the shadows of a frame took.</summary>
/// <param name="Receivers">Points that were tested; points in the night zone are not counted.</param>
/// <param name="Groups">Groups of blocks that bounds could not rule out.</param>
/// <param name="Blocks">Blocks that were read cell by cell.</param>
/// <param name="Strips">Strips of eight cells with facets that face away from the Sun and may have a receiver behind them.</param>
/// <param name="Tries">Vectors of eight receivers that were tested against a strip or a facet.</param>
internal readonly record struct ShadowStatistics(int Receivers, int Groups, int Blocks, int Strips, long Tries);
