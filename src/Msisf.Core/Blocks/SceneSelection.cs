using System.Runtime.InteropServices;
using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Render.Shadows;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Surface;

namespace Msisf.Core.Blocks;

/// <summary>How a scene groups the nodes of a surface: it includes all nodes of a group, or none.</summary>
/// <typeparam name="TGroup">What is included as a whole: a tile, or a block.</typeparam>
internal interface ISceneGroups<TGroup>
{
    /// <summary>The groups that have facets of a node.</summary>
    IEnumerable<TGroup> GroupsOf(SurfaceNode node);

    /// <summary>The nodes of which a group has facets.</summary>
    IEnumerable<SurfaceNode> NodesOf(TGroup whole);
}

/// <summary>Why a scene has something that the image may show, or has not.</summary>
internal enum SceneReason
{
    /// <summary>Left out: all of it that may be seen is certainly dark, as black as the sky.</summary>
    Night,

    /// <summary>Included: it may be seen in sunlight.</summary>
    Visible,

    /// <summary>Included: its shadow may fall on what is included.</summary>
    CastsShadow,

    /// <summary>Included: it is seen and dark, but without it something lit might show.</summary>
    DarkButCovering,
}

/// <summary>What all selections have in common.</summary>
internal static class SceneSelection
{
    /// <summary>px: margin around the image that contains all rays of antialiasing.</summary>
    public const double AntialiasingPixels = 1.0;

    /// <summary>rad: blocks that are wider are looked at node by node, or a scene would have much that the image does not need.</summary>
    private const double WidestBlock = 2.5 * Math.PI / 180.0;

    /// <summary>The level of the nodes of a patch that a selection looks at.</summary>
    public static int LevelOf(Patch patch) =>
        CellBlock.Size * patch.CellAngle > WidestBlock ? SquareLayout.PatchLevel : SquareLayout.CellBlockLevel;
}

/// <summary>
/// Selects what a scene needs for an image: what may be seen in sunlight, what may throw a shadow on it, and dark ground behind which
/// something lit would show. With it alone every ray of the image, one pixel wider all around, has the same light as with all of the
/// surface: it meets the same facet, or dark ground instead of which there is nothing.
/// </summary>
/// <remarks>
/// Where dark ground is left out, a ray may go on to something that is included. The bounds of distance in <see cref="CoverGrid"/> rule
/// that out, unless what lies there is dark too. Its outside is dark if all its facets face away from the Sun, or if it is seen, so that
/// what throws shadows on it is included. A ray that went underground may meet its inside. POV-Ray lights an inside on which the Sun
/// shines, and ground between it and the Sun may be left out; so an inside is dark only if no facet faces away from camera and Sun.
/// </remarks>
/// <typeparam name="TGroup">What is included as a whole.</typeparam>
internal sealed class SceneSelection<TGroup>
    where TGroup : struct
{
    private readonly SurfaceModel _surface;
    private readonly ISceneGroups<TGroup> _groups;
    private readonly MoonHorizon? _fromSun;
    private readonly Dictionary<SurfaceNode, Light> _seen = [];
    private readonly Dictionary<TGroup, SceneReason> _reasons = [];
    private List<TGroup> _newlyIncluded = [];

    private SceneSelection(SurfaceModel surface, ISceneGroups<TGroup> groups, Vector3D? sunPositionBodyFixed)
    {
        (_surface, _groups) = (surface, groups);
        _fromSun = sunPositionBodyFixed is Vector3D sun ? new MoonHorizon(sun, surface.SolidRadius(surface.RadiusLimits.Min)) : null;
    }

    private enum Light
    {
        Lit,

        /// <summary>Dark because the Moon is between it and the Sun.</summary>
        Shaded,

        /// <summary>Dark by itself: all facets face away from the Sun.</summary>
        TurnedAway,
    }

    /// <summary>Selects the groups.</summary>
    /// <param name="groups">How the surface is divided.</param>
    /// <param name="camera">The camera, without a lens.</param>
    /// <param name="sunPositionBodyFixed">m, body-fixed; null if the light is at the camera, where it casts no visible shadow.</param>
    /// <param name="rows">The rows of the image that matter; null for all.</param>
    /// <returns>The groups that may be seen or are included, with the reason.</returns>
    /// <exception cref="BadInputException">The Sun is not outside the terrain, or a model is damaged.</exception>
    public static IReadOnlyDictionary<TGroup, SceneReason> Select(
        SurfaceModel surface,
        ISceneGroups<TGroup> groups,
        ICamera camera,
        Vector3D? sunPositionBodyFixed,
        PixelRows? rows,
        int threads,
        CancellationToken cancellation)
    {
        SceneSelection<TGroup> selection = new(surface, groups, sunPositionBodyFixed);
        CasterSearch search = new(surface);
        if (sunPositionBodyFixed is Vector3D light)
        {
            search.Check(light);
        }

        ViewFrustum[] bands = [.. camera.Bounds(SceneSelection.AntialiasingPixels, rows)];
        List<SurfaceNode>[] dark = [.. bands.Select(band => selection.FindSeen(band, threads, cancellation))];
        if (sunPositionBodyFixed is Vector3D sun)
        {
            CoverGrid[] covers = [.. bands.Select(band => new CoverGrid(band))];
            MoonHorizon[] viewpoints = [.. bands.Select(band => new MoonHorizon(band.CameraBodyFixed, innerRadius: 0.0))];
            while (selection.TakeNewlyIncluded() is { Length: > 0 } nodes)
            {
                selection.IncludeCasters(search, sun, nodes, threads, cancellation);
                for (int band = 0; band < bands.Length; band++)
                {
                    selection.IncludeCovering(covers[band], viewpoints[band], dark[band], nodes);
                }
            }
        }

        return selection._reasons;
    }

    /// <summary>Includes what an image may show, and returns the nodes of it that are dark.</summary>
    private List<SurfaceNode> FindSeen(ViewFrustum frustum, int threads, CancellationToken cancellation)
    {
        BlockCuller culler = new(_surface);
        BlockCuller.InImage bounds = culler.BoundsOf(frustum);
        List<SurfaceNode> dark = [];
        foreach (VisibleBlock block in culler.Find(frustum, threads, cancellation))
        {
            foreach (SurfaceNode node in NodesOf(block.Block, (patch, place) => bounds.MaySee(patch, place)))
            {
                Light light = LightOf(node);
                _seen[node] = light;
                if (light == Light.Lit)
                {
                    Include(node, SceneReason.Visible);
                    continue;
                }

                dark.Add(node);
                foreach (TGroup group in _groups.GroupsOf(node))
                {
                    _reasons.TryAdd(group, SceneReason.Night);
                }
            }
        }

        return dark;
    }

    /// <summary>Includes what throws shadows on nodes that are seen.</summary>
    private void IncludeCasters(
        CasterSearch search, Vector3D sunBodyFixed, IEnumerable<SurfaceNode> nodes, int threads, CancellationToken cancellation)
    {
        BlockReceivers receivers = new(
            _surface,
            nodes.Where(node => _seen.TryGetValue(node, out Light light) && light != Light.TurnedAway),
            sunBodyFixed,
            solidRadius: 0.0);
        if (receivers.Box.IsEmpty)
        {
            return;
        }

        CasterBounds bounds = search.BoundsOf(receivers, slope: 0.0);
        foreach (CellBlock block in search.Find(receivers, slope: 0.0, threads, cancellation))
        {
            foreach (SurfaceNode node in NodesOf(block, (patch, place) => bounds.MayCast(patch.NodeOf(place, patch.BoundsOf(place)))))
            {
                Include(node, SceneReason.CastsShadow);
            }
        }
    }

    /// <summary>Includes dark ground without which an image might show one of some nodes.</summary>
    private void IncludeCovering(CoverGrid cover, MoonHorizon fromCamera, List<SurfaceNode> dark, IEnumerable<SurfaceNode> nodes)
    {
        foreach (SurfaceNode node in nodes)
        {
            bool isDark = _seen.TryGetValue(node, out Light light) ? light != Light.Lit : LightOf(node) == Light.TurnedAway;
            if (!isDark || (!IsTurnedTo(fromCamera, node) && !IsTurnedTo(_fromSun!, node)))
            {
                cover.Add(BoxOf(node));
            }
        }

        dark.RemoveAll(node => _groups.GroupsOf(node).All(IsIncluded));
        foreach (SurfaceNode node in dark.Where(node => cover.IsAnyBehind(BoxOf(node))))
        {
            Include(node, SceneReason.DarkButCovering);
        }
    }

    /// <summary>The nodes of a block that pass a test; of a coarse model they are smaller than blocks.</summary>
    private IEnumerable<SurfaceNode> NodesOf(CellBlock block, Func<Patch, NodePlace, bool> isWanted)
    {
        Patch patch = _surface.Patches[block.Part];
        if (SceneSelection.LevelOf(patch) == SquareLayout.CellBlockLevel)
        {
            return [block.SurfaceNode];
        }

        NodeRange children = patch.Layout.ChildrenOf(SquareLayout.CellBlockLevel, block.Row, block.Column);
        return
            from row in Enumerable.Range(children.FirstRow, children.EndRow - children.FirstRow)
            from column in Enumerable.Range(children.FirstColumn, children.EndColumn - children.FirstColumn)
            let place = new NodePlace(SquareLayout.PatchLevel, row, column)
            where isWanted(patch, place)
            select new SurfaceNode(block.Part, place);
    }

    private Light LightOf(SurfaceNode node)
    {
        if (_fromSun is not { } horizon)
        {
            return Light.Lit;
        }

        (Patch patch, NodeBounds bounds, NodeBox box) = Look(node);
        return horizon.IsTurnedAway(patch, box, bounds) ? Light.TurnedAway : horizon.Hides(box, bounds.Max) ? Light.Shaded : Light.Lit;
    }

    private bool IsTurnedTo(MoonHorizon viewpoint, SurfaceNode node)
    {
        (Patch patch, NodeBounds bounds, NodeBox box) = Look(node);
        return viewpoint.IsTurnedTo(patch, box, bounds);
    }

    private OrientedBox BoxOf(SurfaceNode node) => Look(node).Box.Box;

    private (Patch Patch, NodeBounds Bounds, NodeBox Box) Look(SurfaceNode node)
    {
        Patch patch = _surface.Patches[node.Part];
        NodeBounds bounds = patch.BoundsOf(node.Place);
        return (patch, bounds, patch.BoxOf(node.Place, bounds.Min, bounds.Max));
    }

    private bool IsIncluded(TGroup group) => _reasons.TryGetValue(group, out SceneReason reason) && reason != SceneReason.Night;

    private void Include(SurfaceNode node, SceneReason reason)
    {
        foreach (TGroup group in _groups.GroupsOf(node))
        {
            ref SceneReason known = ref CollectionsMarshal.GetValueRefOrAddDefault(_reasons, group, out _);
            if (known == SceneReason.Night)
            {
                known = reason;
                _newlyIncluded.Add(group);
            }
        }
    }

    private SurfaceNode[] TakeNewlyIncluded()
    {
        List<TGroup> taken = _newlyIncluded;
        _newlyIncluded = [];
        return [.. taken.SelectMany(_groups.NodesOf).Distinct()];
    }
}
