using Msisf.Core.Parallel;
using Msisf.Core.Surface;

namespace Msisf.Core.Render.Shadows;

/// <summary>
/// Finds which points of the Sun's disc terrain hides from the points of an image; <see cref="ShadowPass"/> does the same for the Sun's
/// centre alone. A receiver far from any shadow costs no more than in <see cref="ShadowPass"/>. One object is used for many frames, one
/// at a time, and keeps its memory between them.
/// </summary>
internal sealed class PenumbraPass
{
    /// <summary>Number of receivers that a thread takes at a time.</summary>
    private const int Chunk = 4096;

    /// <summary>Part of the receivers of which zones hide less, so that they cost more than they save.</summary>
    private const double FewHidden = 0.05;

    /// <summary>Frames without zones after one in which they hid few receivers: the next ones mostly look alike.</summary>
    private const int FramesWithoutZones = 15;

    private readonly bool? _findsDarkZones;
    private int _framesWithoutZones;
    private SurfaceModel _surface;
    private CasterSearch _search;
    private readonly ReceiverSort _receivers = new();
    private DarkZoneSearch _darkZones;
    private readonly List<PenumbraScan> _scans = [];

    /// <summary>Makes a pass for a model.</summary>
    /// <param name="findsDarkZones">Whether <see cref="DarkZones"/> are found first; null where they save time.</param>
    public PenumbraPass(SurfaceModel surface, bool? findsDarkZones = null)
    {
        _findsDarkZones = findsDarkZones;
        _surface = surface;
        _search = new CasterSearch(surface);
        _darkZones = new DarkZoneSearch(surface);
    }

    /// <summary>Finds the shadows of another surface from the next frame on; the memory of receivers is kept.</summary>
    public void Show(SurfaceModel surface)
    {
        _surface = surface;
        _search = new CasterSearch(surface);
        _darkZones = new DarkZoneSearch(surface);
        _scans.Clear();
    }

    /// <summary>Bytes of the arrays of receivers that have been replaced since the first frame.</summary>
    public long ReplacedBytes => _receivers.ReplacedBytes;

    /// <summary>Whether zones were found for the last frame.</summary>
    public bool FoundZones { get; private set; }

    /// <summary>Marks the points of the disc that terrain hides from each receiver.</summary>
    /// <param name="receivers">The points whose facet faces a part of the disc (<see cref="SunDisc.MayLight"/>).</param>
    /// <param name="hidden">For each pixel, row by row, the mask of the disc's points that terrain hides; 0 without receiver.</param>
    /// <param name="threads">Maximum number of threads, at least 1.</param>
    /// <exception cref="BadInputException">The Sun is not outside the terrain.</exception>
    public void Run(IReceiverRows receivers, SunDisc disc, ulong[] hidden, int threads, CancellationToken cancellation)
    {
        _search.Check(disc.CentreBodyFixed);
        Array.Clear(hidden, 0, receivers.Rows * receivers.Width);
        while (_scans.Count < threads)
        {
            _scans.Add(new PenumbraScan(_surface));
        }

        LightSource sun = new(disc.CentreBodyFixed, disc.Slope);
        NightZone night = new(_search.SolidRadius, sun.Slope);
        ReceiverJob job = new(receivers, night, pixel => hidden[pixel] = SunDisc.All, threads, cancellation);
        PlacedReceivers placed = _receivers.Read(job, sun);
        IReadOnlyList<CellBlock> blocks = placed.Box.IsEmpty ? [] : _search.Find(placed, sun.Slope, threads, cancellation);
        int count = placed.Length;
        DarkZones? dark = _framesWithoutZones-- <= 0 && (_findsDarkZones ?? _darkZones.Pays(placed, sun.Slope, blocks.Count))
            ? _darkZones.Find(placed, sun.Slope, blocks.Count, threads, cancellation)
            : null;
        FoundZones = dark is not null;
        if (dark is not null)
        {
            placed = placed.LeaveOut(dark.Whole);
            _framesWithoutZones = placed.Length > (1.0 - FewHidden) * count ? FramesWithoutZones : 0;
        }

        SortedReceivers sorted = placed.Sort();
        if (sorted.Box.IsEmpty)
        {
            return;
        }

        DiscRays rays = new(disc, sorted.Frame);
        if (dark is not null)
        {
            MarkHiddenParts(sorted, dark, rays, hidden, threads, cancellation);
        }

        WorkerTeam.Run(
            threads,
            blocks.Count,
            (worker, item) => _scans[worker].Cast(blocks[item], sorted, rays, sun.Slope, hidden),
            cancellation);
    }

    /// <summary>Marks the points of the disc that the zones show to be hidden, so that few facets are left to be tested.</summary>
    private static void MarkHiddenParts(
        SortedReceivers grid, DarkZones dark, DiscRays rays, ulong[] hidden, int threads, CancellationToken cancellation)
    {
        WorkerTeam.Run(threads, (grid.Length + Chunk - 1) / Chunk, (_, chunk) =>
        {
            for (int i = chunk * Chunk; i < Math.Min((chunk + 1) * Chunk, grid.Length); i++)
            {
                double top = dark.HiddenUpTo(new Vector3D(grid.U[i], grid.V[i], grid.W[i]));
                hidden[grid.Pixels[i]] = rays.PointsUpTo(top);
            }
        }, cancellation);
    }
}
