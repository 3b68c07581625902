using Msisf.Core.Surface;

namespace Msisf.Core.Render.Visibility;

/// <summary>
/// Tells which parts of the Moon a camera cannot see: those behind the limb of the largest sphere inside the Moon, and blocks whose facets
/// all face away.
/// </summary>
internal sealed class MoonHorizon
{
    private readonly double _innerRadius;
    private readonly double _distance;
    private readonly Vector3D _toCamera;
    private readonly bool _isOutside;
    private readonly SineCosine _limb;

    /// <param name="positionBodyFixed">Camera position, m, body-fixed.</param>
    /// <param name="innerRadius">m: minimum radius of the surface; 0 if it is not closed, so that nothing of it hides by itself.</param>
    public MoonHorizon(Vector3D positionBodyFixed, double innerRadius)
    {
        _innerRadius = innerRadius;
        _distance = positionBodyFixed.Length;
        _isOutside = _distance > innerRadius;
        if (_isOutside)
        {
            _toCamera = positionBodyFixed / _distance;
            _limb = AngleOfCosine(innerRadius / _distance);
        }
    }

    /// <summary>Whether the inner sphere hides everything in a box, up to a radius in m.</summary>
    public bool Hides(in NodeBox box, double maxRadius)
    {
        if (!_isOutside)
        {
            return false;
        }

        SineCosine reach = Sum(Sum(_limb, AngleOfCosine(_innerRadius / (maxRadius + Tolerances.VertexLattice))), box.CapRadius);
        bool isBelowPi = reach.Sine > 0.0;
        return isBelowPi && Vector3D.Dot(_toCamera, box.Up) < reach.Cosine;
    }

    /// <summary>Whether all facets within a box face away from the camera.</summary>
    /// <param name="minRadius">m: minimum radius of the facets in the box.</param>
    /// <param name="maxSlope">Tangent of the maximum slope of the facets in the box.</param>
    public bool IsTurnedAway(in NodeBox box, double minRadius, double maxSlope)
    {
        if (!_isOutside)
        {
            return false;
        }

        double cosine = Vector3D.Dot(_toCamera, box.Up);
        double sine = Math.Sqrt(Math.Max(0.0, (1.0 - cosine) * (1.0 + cosine)));
        SineCosine nearest = new(
            (sine * box.CapRadius.Cosine) - (cosine * box.CapRadius.Sine), (cosine * box.CapRadius.Cosine) + (sine * box.CapRadius.Sine));
        return GroundFacing.IsTurnedAway(nearest, _distance, minRadius, maxSlope);
    }

    /// <summary>Whether all facets of a node face away from the camera.</summary>
    /// <remarks>From a facet's middle to its corners, up turns by less than the angle of a cell.</remarks>
    public bool IsTurnedAway(Patch patch, in NodeBox box, NodeBounds bounds) => IsTurnedAway(
        box, (bounds.Min * patch.Sagitta) - Tolerances.VertexLattice, bounds.MaxSlope + patch.CellAngle);

    /// <summary>Whether all facets of a node face the camera: it is higher over their horizon than they are steep.</summary>
    public bool IsTurnedTo(Patch patch, in NodeBox box, NodeBounds bounds)
    {
        if (!_isOutside)
        {
            return false;
        }

        double cosine = Vector3D.Dot(_toCamera, box.Up);
        SineCosine farthest = Sum(new SineCosine(Math.Sqrt(Math.Max(0.0, (1.0 - cosine) * (1.0 + cosine))), cosine), box.CapRadius);
        double highest = bounds.Max + Tolerances.VertexLattice;
        return farthest.Sine >= 0.0
            && (_distance * farthest.Cosine) - highest > (bounds.MaxSlope + patch.CellAngle) * _distance * farthest.Sine;
    }

    /// <summary>The angle from 0 to pi/2 that has a cosine; 0 for a cosine above 1.</summary>
    private static SineCosine AngleOfCosine(double cosine)
    {
        double held = Math.Min(1.0, cosine);
        return new SineCosine(Math.Sqrt((1.0 - held) * (1.0 + held)), held);
    }

    private static SineCosine Sum(SineCosine a, SineCosine b) => new(
        (a.Sine * b.Cosine) + (a.Cosine * b.Sine), (a.Cosine * b.Cosine) - (a.Sine * b.Sine));
}
