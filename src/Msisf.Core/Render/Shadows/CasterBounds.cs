using Msisf.Core.Mesh.Bounds;
using Msisf.Core.Numerics;

namespace Msisf.Core.Render.Shadows;

/// <summary>Tells from bounds alone which parts of the terrain may cast a shadow on a receiver.</summary>
internal sealed class CasterBounds
{
    /// <summary>
    /// Dimensionless margin for the rounding errors of directions, of cosines, of products of up to three of them, and of light space.
    /// </summary>
    private const double Rounding = 1e-12;

    private readonly LightFrame _frame;
    private readonly ReceiverGrid _grid;
    private readonly LightBox _receivers;
    private readonly double _slope;
    private readonly double _deepest;
    private readonly double _turnCosine;
    private readonly double _turnSine;

    /// <param name="receivers">The receivers.</param>
    /// <param name="slope">Radius of the Sun's disc over its distance; 0 for a point.</param>
    /// <param name="maxRadius">Upper bound of the terrain's distance from the Moon's centre, m; less than the Sun's distance.</param>
    public CasterBounds(ReceiverSort receivers, double slope, double maxRadius)
    {
        _frame = receivers.Frame;
        _grid = receivers.Grid;
        _receivers = receivers.Box;
        _slope = slope;
        _deepest = receivers.Grid.MaxDepth();

        // Upper bound of the sine of the angle between the direction from a point of the terrain to a point of the Sun and the direction
        // from the Moon's centre to the Sun's centre: the parallax plus the angular radius of the disc.
        double sine = Math.Min(1.0, (maxRadius + (slope * _frame.SunDistance)) / (_frame.SunDistance - maxRadius));
        _turnSine = sine;
        _turnCosine = Math.Sqrt((1.0 - sine) * (1.0 + sine));
    }

    /// <summary>Whether a facet of a node may face away from the Sun and hide a receiver.</summary>
    /// <param name="node">Bounds of the facets; the slope is infinite if it is not known.</param>
    public bool MayCast(in TerrainNode node)
    {
        (SphericalCap cap, double min, double max, double maxSlope) = node;
        double w = Vector3D.Dot(cap.Centre, _frame.AxisW);
        if (!MayFaceAway(-w, cap, maxSlope))
        {
            return false;
        }

        (double minW, double maxW) = Component(w, cap, min, max);
        double minScale = _frame.SunDistance / (_frame.SunDistance + maxW);
        double maxScale = _frame.SunDistance / (_frame.SunDistance + minW);
        (double minU, double maxU) = Component(Vector3D.Dot(cap.Centre, _frame.AxisU), cap, min, max);
        (double minV, double maxV) = Component(Vector3D.Dot(cap.Centre, _frame.AxisV), cap, min, max);
        LightBox box = new(
            minU * (minU < 0.0 ? maxScale : minScale),
            maxU * (maxU < 0.0 ? minScale : maxScale),
            minV * (minV < 0.0 ? maxScale : minScale),
            maxV * (maxV < 0.0 ? minScale : maxScale));
        double minDepth = minW * maxScale;
        LightBox shaded = LightBox.Intersection(_receivers, box.Widened(_slope * Math.Max(0.0, _deepest - minDepth)));
        return !shaded.IsEmpty && minDepth < _grid.MaxDepth(_grid.BinsOf(in shaded));
    }

    /// <summary>Bounds, m, of one coordinate of all points between two spheres whose direction is in a cap.</summary>
    private static (double Min, double Max) Component(double cosine, SphericalCap cap, double min, double max)
    {
        double across = cap.SinRadius * Math.Sqrt(Math.Max(0.0, (1.0 - cosine) * (1.0 + cosine)));
        double along = cosine * cap.CosRadius;
        double low = (cosine <= -cap.CosRadius ? -1.0 : along - across) - Rounding;
        double high = (cosine >= cap.CosRadius ? 1.0 : along + across) + Rounding;
        return (low * (low < 0.0 ? max : min), high * (high < 0.0 ? min : max));
    }

    /// <summary>Whether, somewhere in a cap, the Sun may be low enough for a facet of the maximum slope to face away from it.</summary>
    private bool MayFaceAway(double zenithCosine, SphericalCap cap, double maxSlope)
    {
        double zenithSine = Math.Sqrt(Math.Max(0.0, (1.0 - zenithCosine) * (1.0 + zenithCosine)));
        double farCosine = (zenithCosine * cap.CosRadius) - (zenithSine * cap.SinRadius);
        double farSine = (zenithSine * cap.CosRadius) + (zenithCosine * cap.SinRadius);
        double minSine = (farCosine * _turnCosine) - (farSine * _turnSine) - Rounding;
        if (!(minSine > 0.0 && farSine >= 0.0))
        {
            return true;
        }

        // tan(elevation) > maxSlope, without the division.
        double elevationCosine = (farSine * _turnCosine) + (farCosine * _turnSine) + Rounding;
        return minSine <= maxSlope * elevationCosine;
    }
}
