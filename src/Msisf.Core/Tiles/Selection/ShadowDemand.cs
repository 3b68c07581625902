using Msisf.Core.Camera;
using Msisf.Core.Lod;
using Msisf.Core.Surface;

namespace Msisf.Core.Tiles.Selection;

/// <summary>
/// Tells whether the shadow of ground outside the image may fall on visible ground, and how coarse the level of that ground may be: on
/// level ground the edge of a shadow moves by the error in the caster's height divided by the tangent of the Sun's elevation.
/// </summary>
/// <param name="sun">The Moon from the Sun.</param>
/// <param name="summary">Bounds of the terrain.</param>
/// <param name="patch">Buffer for reading terrain.</param>
/// <param name="rule">Gives the level that is allowed for visible ground.</param>
internal sealed class ShadowDemand(
    SunView sun, ElevationSummary summary, TerrainPatch patch, DetailRule rule, PixelFootprint footprint)
{
    private readonly BackFaces _facets = new(sun.Table, summary, sun.Position, patch);
    private readonly AzimuthIndex<Target> _index = new(bins: 720);

    /// <summary>Notes a place that is seen.</summary>
    public void AddTarget(in TerrainNode node)
    {
        PolarBounds bounds = sun.View.Bounds(node);
        if (_facets.AreAllOf(node, bounds))
        {
            return; // black without any shadow
        }

        Vector3D toSun = sun.Position - (node.MaxRadius * node.Cap.Centre);
        double sin = Vector3D.Dot(toSun, node.Cap.Centre) / toSun.Length;
        double tanElevation = Math.Max(0.0, sin) / Math.Sqrt((1.0 - sin) * (1.0 + sin));
        double metresPerPixel = footprint.MinWidth(node.Ball());
        _index.Add(new Target(bounds, rule.WidestCell(metresPerPixel), rule.MaxShift(metresPerPixel) * tanElevation), bounds);
    }

    /// <summary>How coarse a piece of the surface that is not seen itself may be.</summary>
    /// <returns>
    /// Null if its shadow cannot fall on visible ground; otherwise the maximum cell width and the maximum error in height, m.
    /// </returns>
    public (double WidestCell, double MaxDeviation)? Of(in TerrainNode node)
    {
        PolarBounds bounds = sun.View.Bounds(node);
        if (!_facets.MayBeIn(node, bounds))
        {
            return null;
        }

        bool isNeeded = false;
        double cell = double.PositiveInfinity;
        double deviation = double.PositiveInfinity;
        foreach (int bin in _index.Bins(bounds))
        {
            foreach (Target target in _index[bin])
            {
                if (bounds.Near < target.Bounds.Far && bounds.CanShareRayWith(target.Bounds))
                {
                    isNeeded = true;
                    cell = Math.Min(cell, target.WidestCell);
                    deviation = Math.Min(deviation, target.MaxDeviation);
                }
            }
        }

        return isNeeded ? (cell, deviation) : null;
    }

    private readonly record struct Target(PolarBounds Bounds, double WidestCell, double MaxDeviation);
}
