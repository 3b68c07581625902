using Msisf.Core.Camera;
using Msisf.Core.Render.Options;

namespace Msisf.Core.Render.Indirect;

/// <summary>
/// Samples the light that ground throws on a group of points: far ground by points that stand for it, near ground by rays. Keeps buffers,
/// so each thread needs its own object.
/// </summary>
/// <param name="tree">The ground.</param>
/// <param name="lights">The points that stand for it.</param>
/// <param name="camera">The camera, by whose pixels maps are read.</param>
/// <param name="options">The settings of the renderer.</param>
internal sealed class LightGather(GroundTree tree, GroundLights lights, FrameCamera camera, NativeRenderOptions options)
{
    /// <summary>No bright point within so many times the reach of near ground: no near ground is bright.</summary>
    private const double MarginOfReach = 1.5;

    private readonly LightSamples _samples = new(tree.Surface, camera, options);
    private readonly GroupSight _sight = new(tree, lights);
    private FarLight? _far;
    private NearLight? _near;
    private int _nearest;

    /// <summary>The group; set before <see cref="Begin"/>.</summary>
    public Receivers Group => _sight.Group;

    /// <summary>The light of far ground on the group that was begun.</summary>
    public FarLight Far => _far ??= new FarLight(lights, _sight, _samples, options.Reflectance);

    /// <summary>Whether near ground may be bright.</summary>
    public bool HasNear { get; private set; }

    /// <summary>Prepares the group that was set.</summary>
    /// <param name="shared">What pixels of the image see that lie far apart; null if that is not known.</param>
    public void Begin(SharedSight? shared)
    {
        _sight.Begin();
        bool isSeen = camera.TryProjectPoint(Group.Middle, out RenderingPoint place);
        (_nearest, double distance) = Far.Begin(isSeen ? shared : null, place.X - 1.0, place.Y - 1.0);
        HasNear = distance < Group.Radius + (MarginOfReach * Group.MostReach);
    }

    /// <summary>Adds the light of near ground to the points of the group.</summary>
    /// <param name="rays">For each point, or a few less.</param>
    /// <param name="top">rad over the facet: how far up near ground was found; 0 if that is not known.</param>
    /// <param name="round">Tells rounds of samples apart.</param>
    /// <param name="found">Receives the light.</param>
    public void AddNear(int rays, double top, long round, GatheredLight found)
    {
        if (HasNear)
        {
            _near ??= new NearLight(tree, lights, _sight, _samples);
            _near.Add(rays, top, _nearest, round, found);
        }
    }
}
