using Msisf.Core.Camera;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;

namespace Msisf.Core.Tiles.Selection;

/// <summary>
/// The Dynamical Surface Pattern Selection Algorithm: which tiles an image needs (thesis chapter 8). The thesis intersects a ray for each
/// pixel with a sphere; this version works with bounds of the real surface and misses no tile (docs/surface.md).
/// </summary>
public static class Dspsa
{
    /// <summary>px: margin around the image that contains all rays of antialiasing.</summary>
    internal const double AntialiasingPixels = 1.0;

    /// <summary>Selects the tiles.</summary>
    /// <param name="camera">The camera, above the surface.</param>
    /// <param name="sunPositionBodyFixed">m, body-fixed; null if the light is at the camera, where it casts no visible shadow.</param>
    /// <param name="summary">Summary of the same model.</param>
    /// <exception cref="BadInputException">
    /// The camera is inside the Moon, the Sun is no higher than the terrain, or the summary is of another model.
    /// </exception>
    public static TileSelection Select(ICamera camera, Vector3D? sunPositionBodyFixed, IGlobalGrid grid, ElevationSummary summary)
    {
        Check(camera, sunPositionBodyFixed, grid, summary);
        TileSelection[] ofBands = [.. camera.Bounds(AntialiasingPixels).Zip(camera.Bands, (bounds, band) => new DspsaRun(
            bounds, sunPositionBodyFixed is null ? null : band.Camera.State.SunPositionBodyFixed ?? sunPositionBodyFixed,
            grid, summary).Select())];
        return ofBands is [TileSelection only]
            ? only
            : new TileSelection(ofBands.SelectMany(band => band.All).GroupBy(choice => choice.Tile).Select(
                tile => tile.OrderByDescending(choice => choice.IsKept).First()));
    }

    /// <summary>Refuses input for which no selection is possible.</summary>
    internal static void Check(ICamera camera, Vector3D? sunPositionBodyFixed, IGlobalGrid grid, ElevationSummary summary)
    {
        summary.CheckFits(grid);
        foreach (CameraBand band in camera.Bands)
        {
            TerrainHeight.RequireAbove(grid, band.Camera.PositionBodyFixed);
        }

        if (sunPositionBodyFixed is Vector3D sun && !(sun.IsFinite && sun.Length > summary.MaxRadius))
        {
            throw new BadInputException($"The Sun's position {sun} m is not above the Moon's highest terrain; give one that is.");
        }
    }
}
