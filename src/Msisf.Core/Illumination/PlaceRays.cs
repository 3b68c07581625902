using Msisf.Core.Camera;
using Msisf.Core.Surface;
using Msisf.Core.Tracing;

namespace Msisf.Core.Illumination;

/// <summary>
/// Asks the exact tracer which directions from a place are free of ground. It keeps the facets that its rays met: a direction through one
/// of them needs no other ray. For one thread.
/// </summary>
public sealed class PlaceRays
{
    /// <summary>Facets that are kept; a new one replaces the oldest.</summary>
    private const int MaxFacets = 32;

    /// <summary>rad: nearer to a facet's edge a ray decides.</summary>
    private const double EdgeMargin = 1e-9;

    /// <summary>rad: a facet that is seen narrower is not kept, since rounding would turn its sides.</summary>
    private const double LeastWidth = 1e-6;

    /// <summary>rad: a horizon is found to this.</summary>
    private const double HorizonError = 1e-8;

    private readonly ITerrainTracer _tracer;
    private readonly SurfaceModel _surface;

    /// <summary>Normals, length 1, of the planes through the place and a facet's sides, outward.</summary>
    private readonly List<(Vector3D A, Vector3D B, Vector3D C)> _facets = [];

    /// <summary>Facets that were kept so far.</summary>
    private int _count;

    /// <summary>The kept facet that was in the way last; -1 if a ray met one that is not kept.</summary>
    private int _last = -1;

    internal PlaceRays(ITerrainTracer tracer, SurfaceModel surface, LocalFrame frame) =>
        (_tracer, _surface, Frame) = (tracer, surface, frame);

    /// <summary>The place, above the ground.</summary>
    public LocalFrame Frame { get; }

    /// <summary>Whether no ground is in a direction.</summary>
    /// <param name="direction">Body-fixed, of any length.</param>
    public bool IsFree(Vector3D direction)
    {
        double margin = -EdgeMargin * direction.Length;
        for (int i = 0; i < _facets.Count; i++)
        {
            int at = _last >= 0 ? (_last + i) % _facets.Count : i;
            (Vector3D a, Vector3D b, Vector3D c) = _facets[at];
            if (Vector3D.Dot(a, direction) < margin && Vector3D.Dot(b, direction) < margin && Vector3D.Dot(c, direction) < margin)
            {
                _last = at;
                return false;
            }
        }

        if (!_tracer.TryTrace(new Ray(Frame.PositionBodyFixed, direction), out SurfaceHit hit))
        {
            return true;
        }

        _last = Keep(hit.Facet);
        return false;
    }

    /// <summary>The horizon in one direction, between a ray that meets the ground and one that does not, up to 1.5 rad.</summary>
    /// <param name="azimuth">rad, from north over east.</param>
    /// <param name="guess">rad: an elevation near it.</param>
    /// <returns>The elevation, rad, and where a ray just below it meets the ground; <c>default</c> if there is none.</returns>
    public (double Elevation, SurfaceHit Hit) HorizonAt(double azimuth, double guess)
    {
        const double Steepest = 1.5; // rad
        double step = 2.0 * double.DegreesToRadians(HorizonSurvey.ErrorDegrees);
        (double low, double high) = (guess - step, Math.Min(guess + step, Steepest));
        double top = double.NaN;
        for (; low > -Steepest; step *= 2.0)
        {
            if (!IsFree(Frame.DirectionOf(azimuth, low)))
            {
                top = TopOfLast(azimuth);
                break;
            }

            (low, high) = (Math.Max(low - step, -Steepest), low);
        }

        for (; high < Steepest && !IsFree(Frame.DirectionOf(azimuth, high)); step *= 2.0)
        {
            (low, high, top) = (high, Math.Min(high + step, Steepest), TopOfLast(azimuth));
        }

        // Mostly the facet that is met is on the horizon: a ray over its top is free. If not, the next one halves.
        for (bool isOverTop = true; high - low > HorizonError; isOverTop = !isOverTop)
        {
            double above = top + (0.4 * HorizonError);
            bool takesTop = isOverTop && above > low && above < high;
            double elevation = takesTop ? above : 0.5 * (low + high);
            if (!IsFree(Frame.DirectionOf(azimuth, elevation)))
            {
                (low, top) = (elevation, TopOfLast(azimuth));
            }
            else
            {
                (low, high) = (takesTop ? Math.Max(low, top - (0.4 * HorizonError)) : low, elevation);
            }
        }

        _tracer.TryTrace(new Ray(Frame.PositionBodyFixed, Frame.DirectionOf(azimuth, low)), out SurfaceHit hit);
        return (0.5 * (low + high), hit);
    }

    /// <summary>Elevation, rad, of the upper side of the facet that was in the way last; not a number if it is not kept.</summary>
    private double TopOfLast(double azimuth)
    {
        if (_last < 0)
        {
            return double.NaN;
        }

        Vector3D ahead = Frame.DirectionOf(azimuth, 0.0);
        (Vector3D a, Vector3D b, Vector3D c) = _facets[_last];
        double Tangent(Vector3D side) => Vector3D.Dot(side, Frame.Up) is > 0.0 and var up
            ? -Vector3D.Dot(side, ahead) / up
            : double.PositiveInfinity;
        return Math.Atan(Math.Min(Tangent(a), Math.Min(Tangent(b), Tangent(c))));
    }

    private int Keep(FacetId facet)
    {
        (Vector3D a, Vector3D b, Vector3D c) = _surface.CornersOf(facet);
        (a, b, c) = (
            (a - Frame.PositionBodyFixed).Normalized(), (b - Frame.PositionBodyFixed).Normalized(),
            (c - Frame.PositionBodyFixed).Normalized());
        (Vector3D A, Vector3D B, Vector3D C) sides = (Vector3D.Cross(a, b), Vector3D.Cross(b, c), Vector3D.Cross(c, a));
        if (Math.Min(sides.A.Length, Math.Min(sides.B.Length, sides.C.Length)) < LeastWidth)
        {
            return -1;
        }

        int at = _count++ % MaxFacets;
        if (at == _facets.Count)
        {
            _facets.Add(default);
        }

        _facets[at] = (sides.A.Normalized(), sides.B.Normalized(), sides.C.Normalized());
        return at;
    }
}
