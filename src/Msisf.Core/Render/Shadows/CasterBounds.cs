using Msisf.Core.Surface;

namespace Msisf.Core.Render.Shadows;

/// <summary>Tells from bounds alone which parts of the terrain may cast a shadow on a receiver.</summary>
internal sealed class CasterBounds
{
    private readonly LightFrame _frame;
    private readonly IReceiverBounds _receivers;
    private readonly double _slope;
    private readonly double _deepest;
    private readonly double _turnCosine;
    private readonly double _turnSine;

    /// <param name="slope">Radius of the Sun's disc over its distance; 0 for a point.</param>
    /// <param name="maxRadius">Upper bound of the terrain's distance from the Moon's centre, m; less than the Sun's distance.</param>
    public CasterBounds(IReceiverBounds receivers, double slope, double maxRadius)
    {
        _frame = receivers.Frame;
        _receivers = receivers;
        _slope = slope;
        _deepest = receivers.MaxDepth;

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
        if (!MayFaceAway(-Vector3D.Dot(node.Cap.Centre, _frame.AxisW), node.Cap, node.MaxSlope))
        {
            return false;
        }

        (LightBox box, double minDepth, _) = LightBounds.Of(_frame, node);
        LightBox shaded = LightBox.Intersection(_receivers.Box, box.Widened(_slope * Math.Max(0.0, _deepest - minDepth)));
        return !shaded.IsEmpty && minDepth < _receivers.MaxDepthIn(in shaded);
    }

    /// <summary>Whether, somewhere in a cap, the Sun may be low enough for a facet of the maximum slope to face away from it.</summary>
    private bool MayFaceAway(double zenithCosine, SphericalCap cap, double maxSlope)
    {
        double zenithSine = Math.Sqrt(Math.Max(0.0, (1.0 - zenithCosine) * (1.0 + zenithCosine)));
        double farCosine = (zenithCosine * cap.CosRadius) - (zenithSine * cap.SinRadius);
        double farSine = (zenithSine * cap.CosRadius) + (zenithCosine * cap.SinRadius);
        double minSine = (farCosine * _turnCosine) - (farSine * _turnSine) - LightBounds.Rounding;
        if (!(minSine > 0.0 && farSine >= 0.0))
        {
            return true;
        }

        // tan(elevation) > maxSlope, without the division.
        double elevationCosine = (farSine * _turnCosine) + (farCosine * _turnSine) + LightBounds.Rounding;
        return minSine <= maxSlope * elevationCosine;
    }
}
