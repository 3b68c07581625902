using System.Diagnostics.CodeAnalysis;
using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Scene;
using Msisf.Core.Surface;
using Msisf.Core.Tracing;

namespace Msisf.Core.Sensitivity;

/// <summary>
/// How the border of a shadow moves in the image when the Sun moves: with its caster's distance, on the plane of the facet that it falls
/// on. Remembers the casters of the last shadows; for one thread.
/// </summary>
/// <param name="tracer">Finds the caster.</param>
/// <param name="cornersOf">The corners of a facet, m, body-fixed.</param>
/// <param name="camera">The camera of the image.</param>
/// <param name="light">The Sun.</param>
internal sealed class ShadowMotion(
    ITerrainTracer tracer, Func<FacetId, (Vector3D A, Vector3D B, Vector3D C)> cornersOf, FrameCamera camera, SceneLight light)
{
    /// <summary>
    /// Widths of a sample on the ground: two neighbours that are farther apart lie on both sides of a silhouette, where no shadow ends.
    /// </summary>
    private const double FarthestNeighbour = 4.0;

    /// <summary>Cosine of the emission angle below which ground counts as seen so: oblique ground is soon a silhouette itself.</summary>
    private const double LeastCosine = 0.25;

    /// <summary>Casters that are tried before a ray is traced.</summary>
    private const int Remembered = 8;

    /// <summary>Facets over which a way between two neighbouring samples is followed.</summary>
    private const int MaxFacets = 12;

    /// <summary>Part of a caster's height: a facet of this width is not followed, as it is off by less.</summary>
    private const double NarrowFacet = 0.03;

    /// <summary>The same along a sample's longer side.</summary>
    private const double LeastLongCosine = 0.01;

    /// <summary>Widths of a sample: the edges of wider facets say which way the border runs.</summary>
    private const double WideFacet = 4.0;

    /// <summary>Part of the way between two samples at which the ground behind an edge is looked at.</summary>
    private const double Beyond = 1e-3;

    private readonly Caster?[] _casters = new Caster?[Remembered];
    private readonly UnitQuaternion _cameraFromMoon = camera.MoonFromCamera.Conjugate;
    private readonly double _sampleTangent = camera.PixelTangent / SensitivityFinder.SamplesPerAxis;
    private int _next;

    /// <summary>Eastward at the subsolar point, body-fixed, length 1; at a pole along y.</summary>
    public Vector3D East { get; } = EastOf(light.PositionBodyFixed);

    /// <summary>Northward there.</summary>
    public Vector3D North { get; } = Vector3D.Cross(light.PositionBodyFixed.Normalized(), EastOf(light.PositionBodyFixed));

    /// <summary>
    /// The change of I/F between two samples that is the border of a shadow, times its speed in the image; 0 where there is no such border.
    /// </summary>
    /// <param name="line">The line of the left or upper sample.</param>
    /// <param name="column">Its place in the line.</param>
    /// <param name="nextLine">The line of the other.</param>
    /// <param name="nextColumn">Its place in the line.</param>
    /// <param name="scale">How places of the image move there.</param>
    public ShadowChange Between(SampleLine line, int column, SampleLine nextLine, int nextColumn, in ImageScale scale)
    {
        (int index, int nextIndex) = (line.IndexOf(column), nextLine.IndexOf(nextColumn));
        if (index < 0 || nextIndex < 0)
        {
            return default;
        }

        SurfaceHit hit = line.Truth.HitAt(index);
        SurfaceHit nextHit = nextLine.Truth.HitAt(nextIndex);
        if (!AreNeighbours(in hit, in nextHit))
        {
            return default;
        }

        bool isNextBrighter = line.Visible[column] < nextLine.Visible[nextColumn];
        (SurfaceHit dark, SurfaceHit bright) = isNextBrighter ? (hit, nextHit) : (nextHit, hit);
        Vector3D toSun = light.PositionBodyFixed - dark.PointBodyFixed;
        double distance = Math.Sqrt(toSun.LengthSquared);
        toSun = (1.0 / distance) * toSun;
        Vector3D normal = bright.NormalBodyFixed;
        double cosine = Vector3D.Dot(normal, toSun);
        if (!(cosine > 0.0) || !TryFindHeight(dark, bright.PointBodyFixed, toSun, out double height, out Vector3D edge))
        {
            return default;
        }

        double visible = isNextBrighter ? nextLine.Visible[nextColumn] : line.Visible[column];
        double ofLight = (isNextBrighter ? nextLine.Light[nextColumn] : line.Light[column]) / visible;
        double change = ofLight * (nextLine.Visible[nextColumn] - line.Visible[column]);
        double factor = -height * Math.Sqrt(light.PositionBodyFixed.LengthSquared) / distance;
        double depth = Vector3D.Dot(camera.ForwardBodyFixed, dark.PointBodyFixed - camera.PositionBodyFixed);
        (double edgeX, double edgeY) = InImage(edge - (Vector3D.Dot(normal, edge) / cosine * toSun), in scale);
        double square = (edgeX * edgeX) + (edgeY * edgeY);
        double perSquare = square > 0.0 ? 1.0 / square : 0.0;
        (double eastX, double eastY) = Speed(East, in scale);
        (double northX, double northY) = Speed(North, in scale);
        return new ShadowChange(change * eastX, change * eastY, change * northX, change * northY);

        (double X, double Y) Speed(Vector3D turn, in ImageScale scale)
        {
            // Across the Sun's ray, then along it back into the facet's plane.
            Vector3D across = turn - (Vector3D.Dot(turn, toSun) * toSun);
            (double x, double y) = InImage(factor * (across - (Vector3D.Dot(normal, across) / cosine * toSun)), in scale);

            // A border moves across itself only; along it, samples see steps.
            double along = ((x * edgeX) + (y * edgeY)) * perSquare;
            return (x - (along * edgeX), y - (along * edgeY));
        }

        (double X, double Y) InImage(Vector3D onGround, in ImageScale scale)
        {
            Vector3D moved = _cameraFromMoon * onGround;
            double right = (moved.Y + (scale.Right * moved.X)) / depth;
            double down = (-moved.Z + (scale.Down * moved.X)) / depth;
            return ((scale.XByRight * right) + (scale.XByDown * down), (scale.YByRight * right) + (scale.YByDown * down));
        }
    }

    /// <summary>
    /// Finds how far the caster is from the border of its shadow, where the ray grazes it. A ray from inside the shadow enters the caster
    /// before that: the way to the bright point, seen along the rays, is followed over facets until it leaves the last one.
    /// </summary>
    /// <param name="dark">A point in the shadow.</param>
    /// <param name="bright">A point beside it in the light.</param>
    /// <param name="toSun">Direction to the Sun, length 1.</param>
    /// <param name="height">m.</param>
    /// <param name="edge">m: the edge that casts the border; 0 if facets are too narrow to say.</param>
    private bool TryFindHeight(in SurfaceHit dark, Vector3D bright, Vector3D toSun, out double height, out Vector3D edge)
    {
        Vector3D start = dark.PointBodyFixed;
        Vector3D way = bright - start;
        height = 0.0;
        edge = default;
        if (!TryFindCaster(in dark, toSun, out Caster? caster))
        {
            return false;
        }

        double wide = WideFacet * WidthOf(in dark, LeastLongCosine);
        double part = 0.0;
        for (int step = 0; step < MaxFacets; step++)
        {
            if (!caster.TryLeave(start, toSun, way, ref part, out int left, out double there))
            {
                edge = default;
                return height > 0.0;
            }

            height = there;
            edge = caster.Width > wide ? caster.EdgeOf(left) : default;
            if ((caster.Width < NarrowFacet * height && edge == default) || caster.EndsAt[left])
            {
                return height > 0.0;
            }

            part += Beyond;
            Vector3D point = start + (part * way);
            if (part >= 1.0)
            {
                return height > 0.0;
            }

            if (!tracer.TryTrace(new Ray(point, toSun), out SurfaceHit hit))
            {
                caster.EndsAt[left] = true;
                return height > 0.0;
            }

            caster = Remember(hit.Facet);
        }

        edge = default;
        return height > 0.0;
    }

    /// <summary>Finds a facet between a dark point and the Sun.</summary>
    private bool TryFindCaster(in SurfaceHit dark, Vector3D toSun, [NotNullWhen(true)] out Caster? caster)
    {
        // Ground that faces away from the Sun is a caster itself: its shadow begins at its foot.
        (Vector3D a, Vector3D b, Vector3D c) = cornersOf(dark.Facet);
        if (Vector3D.Dot(Vector3D.Cross(b - a, c - a), toSun) <= 0.0)
        {
            caster = Remember(dark.Facet);
            return true;
        }

        foreach (Caster? remembered in _casters)
        {
            if (remembered is not null && remembered.Hides(dark.PointBodyFixed, toSun))
            {
                caster = remembered;
                return true;
            }
        }

        caster = tracer.TryTrace(new Ray(dark.PointBodyFixed, toSun), out SurfaceHit hit) ? Remember(hit.Facet) : null;
        return caster is not null;
    }

    private Caster Remember(FacetId facet)
    {
        foreach (Caster? remembered in _casters)
        {
            if (remembered is not null && remembered.Facet == facet)
            {
                return remembered;
            }
        }

        Caster caster = new(facet, cornersOf(facet));
        _casters[_next] = caster;
        _next = (_next + 1) % Remembered;
        return caster;
    }

    /// <summary>Whether the ground runs on from one sample to the next: their planes meet between them, or they are near.</summary>
    private bool AreNeighbours(in SurfaceHit hit, in SurfaceHit next)
    {
        if (hit.Facet == next.Facet)
        {
            return true;
        }

        Vector3D toHit = hit.PointBodyFixed - camera.PositionBodyFixed;
        Vector3D toNext = next.PointBodyFixed - camera.PositionBodyFixed;
        double there = Vector3D.Dot(hit.NormalBodyFixed, toHit) / Vector3D.Dot(hit.NormalBodyFixed, toNext);
        double here = Vector3D.Dot(next.NormalBodyFixed, toNext) / Vector3D.Dot(next.NormalBodyFixed, toHit);
        double reach = FarthestNeighbour * Math.Max(WidthOf(in hit, LeastCosine), WidthOf(in next, LeastCosine));
        return (there > 0.0 && here > 0.0 && (there - 1.0) * (here - 1.0) >= 0.0)
            || (hit.PointBodyFixed - next.PointBodyFixed).LengthSquared < reach * reach;
    }

    /// <summary>m: width of a sample on the ground along its longer side.</summary>
    private double WidthOf(in SurfaceHit hit, double leastCosine)
    {
        Vector3D toCamera = camera.PositionBodyFixed - hit.PointBodyFixed;
        double range = Math.Sqrt(toCamera.LengthSquared);
        return range * _sampleTangent / Math.Max(leastCosine, Vector3D.Dot(hit.NormalBodyFixed, toCamera) / range);
    }

    private static Vector3D EastOf(Vector3D sun)
    {
        Vector3D east = Vector3D.Cross(Vector3D.UnitZ, sun);
        return east.Length > Tolerances.ParallelSine * sun.Length ? east.Normalized() : Vector3D.UnitY;
    }
}

/// <summary>The change of I/F at a border of a shadow, times the border's speed in the image.</summary>
/// <param name="EastX">px/rad: speed to the right for a Sun that moves east.</param>
/// <param name="EastY">px/rad: speed down.</param>
/// <param name="NorthX">px/rad: for a Sun that moves north.</param>
/// <param name="NorthY">px/rad.</param>
internal readonly record struct ShadowChange(double EastX, double EastY, double NorthX, double NorthY);
