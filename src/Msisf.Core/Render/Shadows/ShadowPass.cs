using Msisf.Core.Errors;
using Msisf.Core.Mesh;
using Msisf.Core.Numerics;

namespace Msisf.Core.Render.Shadows;

/// <summary>
/// Finds the points of an image that terrain hides from the Sun, exactly. The surface is closed, so a ray that leaves it towards the
/// Sun can meet it again only through a facet that faces away from the Sun: only these are looked at, and no point can hide itself.
/// One object serves frame after frame, one at a time, and keeps its memory.
/// </summary>
internal sealed class ShadowPass
{
    /// <summary>Up to so many blocks it pays to ask first which bins of receivers they may darken, and to sort these only.</summary>
    private const int FewBlocks = 128;

    private readonly SurfaceModel _surface;
    private readonly CasterSearch _search;
    private readonly ReceiverSort _receivers = new();
    private readonly List<CasterScan> _scans = [];

    /// <summary>Takes the model.</summary>
    /// <param name="surface">The model.</param>
    public ShadowPass(SurfaceModel surface)
    {
        _surface = surface;
        _search = new CasterSearch(surface);
    }

    /// <summary>What the last frame took.</summary>
    public ShadowStatistics Statistics { get; private set; }

    /// <summary>Marks the receivers that are in shadow.</summary>
    /// <param name="receivers">Points whose facet faces the Sun.</param>
    /// <param name="sunMoonMe">m, MOON_ME.</param>
    /// <param name="hidden">Of each pixel, row by row: becomes 1 if terrain hides the Sun, else 0; other pixels become 0.</param>
    /// <param name="threads">How many may work, at least 1.</param>
    /// <param name="cancellation">Ends the work.</param>
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
        _receivers.Read(receivers, sun, new NightZone(_search.SolidRadius, sun.Slope), threads, cancellation);
        IReadOnlyList<CellBlock> blocks = _receivers.Box.IsEmpty ? [] : _search.Find(_receivers, sun.Slope, threads, cancellation);
        if (blocks.Count <= FewBlocks)
        {
            WorkerTeam.Run(threads, blocks.Count, (worker, item) => _scans[worker].WantBins(blocks[item], _receivers), cancellation);
        }
        else
        {
            _receivers.Grid.WantAll();
        }

        _receivers.Sort(receivers, pixel => hidden[pixel] = 1, threads, cancellation);
        WorkerTeam.Run(threads, blocks.Count, (worker, item) => _scans[worker].Cast(blocks[item], _receivers, hidden), cancellation);
        Statistics = new ShadowStatistics(
            _receivers.Grid.Length, _search.Groups, blocks.Count, _scans.Sum(scan => scan.Strips), _scans.Sum(scan => scan.Tries));
    }
}
