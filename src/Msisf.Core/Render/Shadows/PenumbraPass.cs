using Msisf.Core.Errors;
using Msisf.Core.Mesh;

namespace Msisf.Core.Render.Shadows;

/// <summary>
/// Finds which parts of the Sun's disc terrain hides from the points of an image: what <see cref="ShadowPass"/> does for the Sun's
/// centre, for each point of the disc. Points that no shadow comes near cost no more than there. One object serves frame after frame,
/// one at a time, and keeps its memory.
/// </summary>
internal sealed class PenumbraPass
{
    private readonly SurfaceModel _surface;
    private readonly CasterSearch _search;
    private readonly ReceiverSort _receivers = new();
    private readonly List<PenumbraScan> _scans = [];

    /// <summary>Takes the model.</summary>
    /// <param name="surface">The model.</param>
    public PenumbraPass(SurfaceModel surface)
    {
        _surface = surface;
        _search = new CasterSearch(surface);
    }

    /// <summary>Marks what of the disc is hidden.</summary>
    /// <param name="receivers">Points whose facet faces a part of the disc (<see cref="SunDisc.MayLight"/>).</param>
    /// <param name="disc">The Sun.</param>
    /// <param name="hidden">Of each pixel, row by row, a bit for each point of the disc that terrain hides; other pixels become 0.</param>
    /// <param name="threads">How many may work, at least 1.</param>
    /// <param name="cancellation">Ends the work.</param>
    /// <exception cref="BadInputException">The Sun is not outside the terrain.</exception>
    public void Run(IReceiverRows receivers, SunDisc disc, ulong[] hidden, int threads, CancellationToken cancellation)
    {
        _search.Check(disc.CentreMoonMe);
        Array.Clear(hidden, 0, receivers.Rows * receivers.Width);
        while (_scans.Count < threads)
        {
            _scans.Add(new PenumbraScan(_surface));
        }

        LightSource sun = new(disc.CentreMoonMe, disc.Slope);
        NightZone night = new(_search.SolidRadius, sun.Slope);
        _receivers.Read(receivers, sun, night, threads, cancellation);
        _receivers.Grid.WantAll();
        _receivers.Sort(receivers, pixel => hidden[pixel] = SunDisc.All, threads, cancellation);
        if (_receivers.Box.IsEmpty)
        {
            return;
        }

        DiscRays rays = new(disc, _receivers.Frame);
        IReadOnlyList<CellBlock> blocks = _search.Find(_receivers, sun.Slope, threads, cancellation);
        WorkerTeam.Run(
            threads, blocks.Count, (worker, item) => _scans[worker].Cast(blocks[item], _receivers, rays, sun.Slope, hidden), cancellation);
    }
}
