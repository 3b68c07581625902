using Msisf.Core.Errors;
using Msisf.Core.Numerics;
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

    private SurfaceModel _surface;
    private CasterSearch _search;
    private readonly ReceiverSort _receivers = new();
    private readonly List<CasterScan> _scans = [];

    /// <summary>Makes a pass for a model.</summary>
    /// <param name="surface">The model.</param>
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
    public long ReplacedBytes => _receivers.Grid.ReplacedBytes;

    /// <summary>Marks the receivers that are in shadow.</summary>
    /// <param name="receivers">The points whose facet faces the Sun.</param>
    /// <param name="sunMoonMe">The Sun's centre, m, MOON_ME.</param>
    /// <param name="hidden">One value for each pixel, row by row: 1 if terrain hides the Sun, 0 if not or if there is no receiver.</param>
    /// <param name="threads">Maximum number of threads, at least 1.</param>
    /// <param name="cancellation">Cancels the work.</param>
    /// <exception cref="BadInputException">The Sun is not outside the terrain.</exception>
    public void Run(IReceiverRows receivers, Vector3D sunMoonMe, byte[] hidden, int threads, CancellationToken cancellation)
    {
        _search.Check(sunMoonMe);
        Array.Clear(hidden, 0, receivers.Rows * receivers.Width);
        while (_scans.Count < threads)
        {
            _scans.Add(new CasterScan(_surface));
        }

        foreach (CasterScan scan in _scans)
        {
            scan.Start();
        }

        LightSource sun = new(sunMoonMe, Slope: 0.0);
        NightZone night = new(_search.SolidRadius, sun.Slope);
        _receivers.Read(receivers, sun, night, pixel => hidden[pixel] = 1, threads, cancellation);
        IReadOnlyList<CellBlock> blocks = _receivers.Box.IsEmpty ? [] : _search.Find(_receivers, sun.Slope, threads, cancellation);
        if (blocks.Count <= FewBlocks)
        {
            WorkerTeam.Run(threads, blocks.Count, (worker, item) => _scans[worker].WantBins(blocks[item], _receivers), cancellation);
        }
        else
        {
            _receivers.Grid.WantAll();
        }

        _receivers.Sort(receivers, threads, cancellation);
        WorkerTeam.Run(threads, blocks.Count, (worker, item) => _scans[worker].Cast(blocks[item], _receivers, hidden), cancellation);
        Statistics = new ShadowStatistics(
            _receivers.Grid.Length, _search.Groups, blocks.Count, _scans.Sum(scan => scan.Strips), _scans.Sum(scan => scan.Tries));
    }
}
