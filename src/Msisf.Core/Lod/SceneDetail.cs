using Msisf.Core.Camera;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;

namespace Msisf.Core.Lod;

/// <summary>
/// Every frame shows several models, each at the coarsest level that is fine enough for its nearest ground. A model inside a coarser one
/// that is fine enough for it is left out.
/// </summary>
/// <remarks>
/// The nearest ground counts whether it is in the image or not: what lies beside the image throws shadows into it, and a camera that turns
/// needs no other levels. Ground is taken to be as far from the Moon's centre as that below the camera; only mountains can be nearer.
/// </remarks>
public sealed class SceneDetail : IFrameTerrain
{
    private readonly NestedLevels _levels;
    private readonly DetailRule[] _rules;

    /// <summary>Takes the models.</summary>
    /// <param name="errorPixels">px: how far a coarser level may move what is seen.</param>
    public SceneDetail(NestedLevels levels, double errorPixels)
    {
        _levels = levels;
        _rules = [.. levels.Models.Select(model => new DetailRule(model, errorPixels))];
    }

    /// <inheritdoc/>
    public ITerrain For(ICamera camera, int subsamplesPerAxis) =>
        _levels.Terrain(camera.Bands.Select(band => LevelsFor(band.Camera.Footprint, subsamplesPerAxis))
            .Aggregate((all, next) => [.. all.Zip(next, (one, other) => one is null || other < one ? other : one)]));

    /// <summary>The level of each model, the coarsest model first; null for one that is left out.</summary>
    /// <param name="footprint">Footprint of the image's pixels.</param>
    /// <param name="subsamplesPerAxis">Samples along a pixel's edge.</param>
    public IReadOnlyList<int?> LevelsFor(PixelFootprint footprint, int subsamplesPerAxis)
    {
        NestedTerrain scene = _levels.Scene;
        double distance = footprint.PositionBodyFixed.Length;
        Vector3D direction = footprint.PositionBodyFixed.Normalized();
        double ground = scene.GroundRadius(direction);
        int?[] levels = new int?[_rules.Length];
        for (int model = 0; model < levels.Length; model++)
        {
            double angle = scene.WholeParts[model].Mesh.IsClosed ? 0.0 : ModelReach.AngleTo(scene.WholeParts[model], direction);
            double half = Math.Sin(0.5 * Math.Min(angle, Math.PI));
            double away = Math.Max(0.0, distance - ground);
            double nearest = Math.Sqrt((away * away) + (4.0 * distance * ground * half * half));
            double widest = _rules[model].WidestCell(nearest * footprint.Tangent / subsamplesPerAxis);
            levels[model] = IsFineEnough(levels, model, widest) ? null : _rules[model].LevelOfCell(widest);
        }

        return levels;
    }

    /// <summary>Whether a coarser model that holds all of a model is fine enough for it.</summary>
    private bool IsFineEnough(int?[] levels, int model, double widest)
    {
        for (int coarser = 0; coarser < model; coarser++)
        {
            if (levels[coarser] is { } level && _rules[coarser].CellOf(level) <= widest && _levels.Covers(coarser, model))
            {
                return true;
            }
        }

        return false;
    }
}
