using Msisf.Core.Numerics;
using Msisf.Core.Terrain;

namespace Msisf.Core.Render.Shadows;

/// <summary>Tells which parts of the terrain can throw a shadow on a receiver, from bounds alone.</summary>
internal sealed class CasterBounds
{
    /// <summary>1: for the rounding of directions, cosines and products of three of them, and of what the light frame makes of them.</summary>
    private const double Rounding = 1e-12;

    private readonly LightFrame _frame;
    private readonly ReceiverGrid _grid;
    private readonly LightBox _receivers;
    private readonly double _slope;
    private readonly double _deepest;
    private readonly double _turnCosine;
    private readonly double _turnSine;

    /// <param name="receivers">The receivers.</param>
    /// <param name="slope">Of the Sun's disc.</param>
    /// <param name="greatestRadius">m; below the Sun's distance.</param>
    public CasterBounds(ReceiverSort receivers, double slope, double greatestRadius)
    {
        _frame = receivers.Frame;
        _grid = receivers.Grid;
        _receivers = receivers.Box;
        _slope = slope;
        _deepest = receivers.Grid.GreatestDepth();

        // The direction from a point to a part of the Sun differs from that from the centre to the Sun's centre by an angle with at most
        // this sine: the parallax, and what the disc adds to it.
        double sine = Math.Min(1.0, (greatestRadius + (slope * _frame.SunDistance)) / (_frame.SunDistance - greatestRadius));
        _turnSine = sine;
        _turnCosine = Math.Sqrt((1.0 - sine) * (1.0 + sine));
    }

    /// <summary>Whether a facet that faces away from the Sun may lie in front of a receiver.</summary>
    /// <param name="cap">Holds the facets.</param>
    /// <param name="least">m: no facet is lower.</param>
    /// <param name="greatest">m: no facet is higher.</param>
    /// <param name="steepness">Tangent of an angle that no facet's slope exceeds; infinite if it is not known.</param>
    public bool MayCast(SphericalCap cap, double least, double greatest, double steepness)
    {
        double w = Vector3D.Dot(cap.Centre, _frame.AxisW);
        if (!MayFaceAway(-w, cap, steepness))
        {
            return false;
        }

        (double leastW, double greatestW) = Component(w, cap, least, greatest);
        double leastScale = _frame.SunDistance / (_frame.SunDistance + greatestW);
        double greatestScale = _frame.SunDistance / (_frame.SunDistance + leastW);
        (double leastU, double greatestU) = Component(Vector3D.Dot(cap.Centre, _frame.AxisU), cap, least, greatest);
        (double leastV, double greatestV) = Component(Vector3D.Dot(cap.Centre, _frame.AxisV), cap, least, greatest);
        LightBox box = new(
            leastU * (leastU < 0.0 ? greatestScale : leastScale),
            greatestU * (greatestU < 0.0 ? leastScale : greatestScale),
            leastV * (leastV < 0.0 ? greatestScale : leastScale),
            greatestV * (greatestV < 0.0 ? leastScale : greatestScale));
        double leastDepth = leastW * greatestScale;
        LightBox shaded = LightBox.Intersection(_receivers, box.Widened(_slope * Math.Max(0.0, _deepest - leastDepth)));
        return !shaded.IsEmpty && leastDepth < _grid.GreatestDepth(_grid.BinsOf(in shaded));
    }

    /// <summary>Bounds of one component of the points between two spheres in the direction of a cap.</summary>
    private static (double Least, double Greatest) Component(double cosine, SphericalCap cap, double least, double greatest)
    {
        double across = cap.SinRadius * Math.Sqrt(Math.Max(0.0, (1.0 - cosine) * (1.0 + cosine)));
        double along = cosine * cap.CosRadius;
        double low = (cosine <= -cap.CosRadius ? -1.0 : along - across) - Rounding;
        double high = (cosine >= cap.CosRadius ? 1.0 : along + across) + Rounding;
        return (low * (low < 0.0 ? greatest : least), high * (high < 0.0 ? least : greatest));
    }

    /// <summary>Whether the Sun is anywhere lower than the steepest slope.</summary>
    private bool MayFaceAway(double zenithCosine, SphericalCap cap, double steepness)
    {
        double zenithSine = Math.Sqrt(Math.Max(0.0, (1.0 - zenithCosine) * (1.0 + zenithCosine)));
        double farCosine = (zenithCosine * cap.CosRadius) - (zenithSine * cap.SinRadius);
        double farSine = (zenithSine * cap.CosRadius) + (zenithCosine * cap.SinRadius);
        double leastSine = (farCosine * _turnCosine) - (farSine * _turnSine) - Rounding;
        if (!(leastSine > 0.0 && farSine >= 0.0))
        {
            return true;
        }

        // tan(elevation) > steepness, without the division.
        double elevationCosine = (farSine * _turnCosine) + (farCosine * _turnSine) + Rounding;
        return leastSine <= steepness * elevationCosine;
    }
}
