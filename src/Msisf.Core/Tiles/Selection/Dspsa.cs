using Msisf.Core.Blocks;
using Msisf.Core.Camera;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;

namespace Msisf.Core.Tiles.Selection;

/// <summary>
/// The Dynamical Surface Pattern Selection Algorithm: which tiles an image needs (thesis chapter 8). The thesis intersects a ray for each
/// pixel with a sphere (<see cref="SphereRays"/>). To these tiles come those whose relief is in view although no ray hits the sphere there,
/// and those that throw shadows into the image; tiles that are certainly dark or hidden are left out (docs/surface.md). Safe for several
/// threads.
/// </summary>
/// <param name="grid">The model.</param>
public sealed class Dspsa(IGlobalGrid grid)
{
    private readonly SurfaceModel _surface = SurfaceModel.Of(grid);

    /// <summary>Selects the tiles.</summary>
    /// <param name="camera">The camera, above the surface.</param>
    /// <param name="sunPositionBodyFixed">m, body-fixed; null if the light is at the camera, where it casts no visible shadow.</param>
    /// <exception cref="BadInputException">The camera is inside the Moon, or the Sun is not higher than the terrain.</exception>
    public TileSelection Select(ICamera camera, Vector3D? sunPositionBodyFixed, int threads = 1, CancellationToken cancellation = default)
    {
        foreach (CameraBand band in camera.Bands)
        {
            TerrainHeight.RequireAbove(grid, band.Camera.PositionBodyFixed);
        }

        TileGroups groups = new(_surface.Parts[0], grid.PixelsPerDegree);
        IReadOnlyDictionary<TileId, SceneReason> reasons = SceneSelection<TileId>.Select(
            _surface, groups, camera, sunPositionBodyFixed, rows: null, threads, cancellation);
        Lazy<IReadOnlySet<TileId>> inFrame = new(() => TilesInFrame(groups, camera));
        return new TileSelection(TileId.All.Select(tile => new TileChoice(tile, reasons.TryGetValue(tile, out SceneReason reason)
            ? ReasonOf(reason)
            : inFrame.Value.Contains(tile) ? TileReason.Hidden : TileReason.OutsideFrame)));
    }

    private static TileReason ReasonOf(SceneReason reason) => reason switch
    {
        SceneReason.Visible => TileReason.Visible,
        SceneReason.CastsShadow => TileReason.CastsShadow,
        SceneReason.DarkButCovering => TileReason.DarkButCovering,
        _ => TileReason.Night,
    };

    /// <summary>The tiles that would be in the image if nothing hid them and ground could have any height of the model.</summary>
    private HashSet<TileId> TilesInFrame(TileGroups groups, ICamera camera)
    {
        HashSet<TileId> tiles = [];
        foreach (ViewFrustum frustum in camera.Bounds(SceneSelection.AntialiasingPixels))
        {
            InFrame tester = new(frustum, _surface, groups, tiles);
            NodeWalk.All(_surface.Parts[0].Layout, ref tester);
        }

        return tiles;
    }

    private readonly struct InFrame(ViewFrustum frustum, SurfaceModel surface, TileGroups groups, HashSet<TileId> tiles) : INodeTester
    {
        public Visit Test(NodePlace node)
        {
            (double min, double max) = surface.RadiusLimits;
            if (!frustum.TryFindRows(surface.Parts[0].BoxOf(node, min, max).Box, out _))
            {
                return Visit.Skip;
            }

            if (node.Level > groups.Level)
            {
                return Visit.Descend;
            }

            tiles.UnionWith(groups.GroupsOf(new SurfaceNode(0, node)));
            return Visit.Skip;
        }
    }
}
