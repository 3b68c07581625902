using System.Collections.Concurrent;
using Msisf.Core.Camera;
using Msisf.Core.Lod;
using Msisf.Core.Terrain;

namespace Msisf.Core.Tiles.Selection;

/// <summary>
/// Chooses the parts of the surface that an image needs, and how fine they are: parts of the tiles that <see cref="Dspsa"/> keeps, each
/// at the coarsest level of detail that the image does not show (docs/surface.md). Safe for several threads.
/// </summary>
public sealed class PartSelector
{
    private readonly LodLevels _levels;
    private readonly IGlobalGrid _grid;
    private readonly ElevationSummary _summary;
    private readonly DetailRule _rule;
    private readonly int _cells;
    private readonly ConcurrentDictionary<SurfacePart, double> _deviations = new();

    /// <summary>Takes the model.</summary>
    /// <param name="levels">The model and its levels of detail.</param>
    /// <param name="summary">Summary of the same model.</param>
    /// <param name="errorPixels">
    /// How far, in pixels, a coarser level may move visible ground or the edge of a shadow on it; 0 for the model itself everywhere.
    /// </param>
    /// <param name="cells">Number of cells along a part's edge.</param>
    /// <exception cref="BadInputException">The summary is of another model.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The error is negative or not finite, or there are no cells.</exception>
    public PartSelector(LodLevels levels, ElevationSummary summary, double errorPixels, int cells = SurfacePart.DefaultCells)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(cells, 1);
        if (!(errorPixels >= 0.0 && double.IsFinite(errorPixels)))
        {
            throw new ArgumentOutOfRangeException(
                nameof(errorPixels), errorPixels, "The error of levels of detail is finite and not below 0 px.");
        }

        summary.CheckFits(levels.Level(0));
        _levels = levels;
        _grid = levels.Level(0);
        _summary = summary;
        _rule = new DetailRule(levels, errorPixels);
        _cells = cells;
    }

    /// <summary>Selects the parts.</summary>
    /// <param name="camera">The camera, above the surface.</param>
    /// <param name="sunPositionBodyFixed">m, body-fixed; null if the light is at the camera, where it casts no visible shadow.</param>
    /// <param name="rows">The rows of the image that matter; null for all.</param>
    /// <exception cref="BadInputException">The camera is inside the Moon, or the Sun is no higher than the terrain.</exception>
    public PartSelection Select(FrameCamera camera, Vector3D? sunPositionBodyFixed, PixelRows? rows = null)
    {
        Dspsa.Check(camera, sunPositionBodyFixed, _grid, _summary);

        // Where all visible ground is drawn from the model itself, the selection is exact and needs no margin.
        bool isExact = CoarsestLevelInSight(camera.Footprint) == 0;
        ViewFrustum frame = new(camera, Dspsa.AntialiasingPixels + (isExact ? 0.0 : _rule.MarginPixels), rows);
        DspsaRun run = new(frame, sunPositionBodyFixed, _grid, _summary, isExact ? 0.0 : _rule.SlackPixels * camera.Footprint.Tangent);
        TileSelection tiles = run.Select();
        PartDivision division = new(
            run,
            _rule,
            camera.Footprint,
            _summary,
            level => SurfacePart.SubdivisionsAt(_grid.PixelsPerDegree >> level, _cells),
            DeviationOf);
        return new PartSelection(tiles, division.Divide(tiles));
    }

    /// <summary>The coarsest level that is allowed for any visible ground.</summary>
    internal int CoarsestLevelInSight(PixelFootprint footprint)
    {
        double distance = footprint.PositionBodyFixed.Length;
        double min = _summary.MinRadius;
        double toHorizon = Math.Sqrt(Math.Max(0.0, (distance - min) * (distance + min)));
        double behind = Math.Sqrt((_summary.MaxRadius - min) * (_summary.MaxRadius + min));
        return _rule.LevelOfPixel((toHorizon + behind) * footprint.Tangent);
    }

    private double DeviationOf(SurfacePart part) => _deviations.GetOrAdd(part, known => LevelDeviation.Of(_levels, known));
}

/// <summary>The pieces of surface that an image needs, each at a level of detail.</summary>
/// <param name="Tiles">The tiles from which they were taken.</param>
/// <param name="Parts">
/// By tile, then fineness, then place; they do not overlap, except for the additional rings of cells of coarser levels.
/// </param>
public sealed record PartSelection(TileSelection Tiles, IReadOnlyList<SurfacePart> Parts);
