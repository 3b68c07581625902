using Msisf.Core.Camera;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;

namespace Msisf.Core.Navigation;

/// <summary>Finds the craters that an image shows, and how.</summary>
/// <param name="leastDiameter">px: smaller ones are only counted.</param>
public sealed class CraterFinder(CraterCatalogue catalogue, CraterRim rim, double leastDiameter)
{
    /// <summary>Points of a rim that is not an ellipse; a multiple of four, so that the ends of both axes are among them.</summary>
    private const int CurvePoints = 64;

    /// <summary>The same of craters on the terrain that are small in the image.</summary>
    private const int FewCurvePoints = 24;

    /// <summary>px: diameter from which a crater on the terrain has all points.</summary>
    private const double ManyPointsFrom = 40.0;

    /// <summary>The craters that a pinhole or another camera sees, without what only the drawn frame tells.</summary>
    public CratersOfFrame Find(ICamera camera, SceneLight light, ITerrain terrain)
    {
        List<CraterView> views = [];
        List<CraterLeftOut> leftOut = [];
        int tooSmall = 0;
        ImagePyramid? pyramid = camera is FrameCamera { Model.Lens: null } pinhole ? new ImagePyramid(pinhole) : null;
        foreach (int index in Candidates(camera, terrain))
        {
            Crater crater = catalogue.Craters[index];
            CraterDisc disc = catalogue.DiscOf(index, terrain);
            CraterShape shape = ShapeOf(camera, pyramid, disc, terrain);
            if (!shape.IsInView)
            {
                continue;
            }

            if (shape.LeftOut is { } reason)
            {
                leftOut.Add(new CraterLeftOut(crater, reason));
            }
            else if (2.0 * shape.Ellipse.SemiMajor < leastDiameter)
            {
                tooSmall++;
            }
            else
            {
                views.Add(View(camera, light, crater, disc, shape));
            }
        }

        return new CratersOfFrame(views, leftOut, tooSmall) { Rim = rim, LeastDiameter = leastDiameter };
    }

    private static CraterView View(ICamera camera, SceneLight light, Crater crater, in CraterDisc disc, in CraterShape shape)
    {
        ImageEllipse ellipse = shape.Ellipse;
        Vector3D eye = camera.BandAt(ellipse.Y).Camera.PositionBodyFixed;
        Vector3D source = light.At(camera, ellipse.Y).PositionBodyFixed;
        return new CraterView(crater, disc, ellipse)
        {
            Curve = shape.Curve,
            Residual = shape.Curve.Count > 0 ? shape.Residual : null,
            Inside = ellipse.AreaInside(camera.Width, camera.Height) / ellipse.Area,
            Emission = Vector3D.AngleBetween(disc.Up, eye - disc.Centre),
            Incidence = Vector3D.AngleBetween(disc.Up, source - disc.Centre),
            Covariance = crater.Errors is { } errors
                ? CraterCovariance.Of(moved => EllipseOf(camera, moved), crater, errors, disc.Centre.Length, ellipse)
                : null,
        };
    }

    /// <summary>The craters of which some part may lie in the image and face the camera; those are all, and few others.</summary>
    private List<int> Candidates(ICamera camera, ITerrain terrain)
    {
        (double lowest, double highest) = terrain.RadiusLimits;
        double middle = 0.5 * (lowest + highest);
        double slack = 0.5 * (highest - lowest);
        (Vector3D Eye, Vector3D Forward, double Sine, double Cosine)[] cones =
        [
            .. camera.Bands.Select(band =>
            {
                double tangent = band.Camera.Model.BorderTangent();
                double cosine = 1.0 / double.Hypot(1.0, tangent);
                return (band.Camera.PositionBodyFixed, band.Camera.ForwardBodyFixed, tangent * cosine, cosine);
            }),
        ];
        List<int> found = [];
        ReadOnlySpan<Vector3D> directions = catalogue.Directions;
        for (int index = 0; index < directions.Length; index++)
        {
            Vector3D direction = directions[index];
            double reach = slack + (0.5 * catalogue.Craters[index].Diameter);
            foreach ((Vector3D eye, Vector3D forward, double sine, double cosine) in cones)
            {
                if (Vector3D.Dot(eye, direction) <= lowest)
                {
                    continue;
                }

                Vector3D way = (middle * direction) - eye;
                double ahead = Vector3D.Dot(way, forward);
                double aside = Math.Sqrt(Math.Max(0.0, way.LengthSquared - (ahead * ahead)));
                if ((aside * cosine) - (ahead * sine) <= reach)
                {
                    found.Add(index);
                    break;
                }
            }
        }

        return found;
    }

    private CraterShape ShapeOf(ICamera camera, ImagePyramid? pyramid, in CraterDisc disc, ITerrain terrain)
    {
        if (pyramid is not { } ofPinhole || camera is not FrameCamera pinhole)
        {
            return CurveOf(camera, disc, terrain);
        }

        if (!disc.IsBelow(pinhole.PositionBodyFixed) || !ofPinhole.Shows(disc))
        {
            return default;
        }

        if (!disc.TryProject(pinhole, out ImageEllipse ellipse))
        {
            return new CraterShape(IsInView: true, default, [], 0.0, CraterLeftOutReason.Hyperbola);
        }

        return rim == CraterRim.Terrain && 2.0 * ellipse.SemiMajor >= leastDiameter
            ? CurveOf(camera, disc, terrain, ellipse)
            : new CraterShape(IsInView: true, ellipse, [], 0.0, null);
    }

    /// <summary>The ellipse of a disc, or the one that fits it.</summary>
    private static ImageEllipse? EllipseOf(ICamera camera, CraterDisc disc)
    {
        if (camera is FrameCamera { Model.Lens: null } pinhole)
        {
            return disc.TryProject(pinhole, out ImageEllipse ellipse) ? ellipse : null;
        }

        CraterShape shape = ProjectedCurve(camera, [.. RimPoints(disc)], disc);
        return shape is { IsInView: true, LeftOut: null } ? shape.Ellipse : null;
    }

    /// <summary>A rim that is not an ellipse in the image, and the one that fits it.</summary>
    private CraterShape CurveOf(ICamera camera, in CraterDisc disc, ITerrain terrain, ImageEllipse? known = null)
    {
        CraterShape shape = ProjectedCurve(camera, [.. RimPoints(disc)], disc);
        if (!shape.IsInView || rim == CraterRim.Disc || shape.LeftOut is not null || 2.0 * shape.Ellipse.SemiMajor < leastDiameter)
        {
            return shape;
        }

        int points = 2.0 * (known ?? shape.Ellipse).SemiMajor < ManyPointsFrom ? FewCurvePoints : CurvePoints;
        return ProjectedCurve(camera, TerrainRim.Of(disc, catalogue.GroundOf(terrain), points), disc);
    }

    private static IEnumerable<Vector3D> RimPoints(CraterDisc disc) =>
        Enumerable.Range(0, CurvePoints).Select(i => disc.RimAt(2.0 * Math.PI * i / CurvePoints));

    private static CraterShape ProjectedCurve(ICamera camera, Vector3D[] rim, in CraterDisc disc)
    {
        RenderingPoint[] curve = new RenderingPoint[rim.Length];
        int seen = 0;
        foreach (Vector3D point in rim)
        {
            if (camera.TryProjectOutline(point, out curve[seen]))
            {
                seen++;
            }
        }

        RenderingPoint[] shown = curve[..seen];
        bool isInView = seen > 0
            && CurvePolygon.Meets(shown, camera.Width, camera.Height)
            && disc.IsBelow(camera.BandAt(shown.Average(point => point.Y)).Camera.PositionBodyFixed);
        return !isInView ? default
            : seen == rim.Length && EllipseFit.TryFit(curve, out ImageEllipse ellipse, out double residual)
                ? new CraterShape(IsInView: true, ellipse, curve, residual, null)
                : new CraterShape(IsInView: true, default, [], 0.0, CraterLeftOutReason.NoEllipse);
    }

    /// <summary>How a rim is seen; <c>default</c> is not at all.</summary>
    private readonly record struct CraterShape(
        bool IsInView, ImageEllipse Ellipse, IReadOnlyList<RenderingPoint> Curve, double Residual, CraterLeftOutReason? LeftOut);
}

/// <summary>Finds the rim of a crater on the terrain: in each direction from its centre the highest ground near the disc's end.</summary>
internal static class TerrainRim
{
    /// <summary>Parts of the way to the disc's border between which the rim is looked for.</summary>
    private const double Nearest = 0.8;

    /// <inheritdoc cref="Nearest"/>
    private const double Farthest = 1.2;

    /// <summary>Places on this way: steps of a 20th of the radius.</summary>
    private const int Places = 9;

    /// <summary>The rim, m, body-fixed.</summary>
    public static Vector3D[] Of(in CraterDisc disc, GroundBelow ground, int directions)
    {
        Vector3D[] rim = new Vector3D[directions];
        for (int i = 0; i < directions; i++)
        {
            Vector3D way = disc.RimAt(2.0 * Math.PI * i / directions) - disc.Centre;
            double highest = double.NegativeInfinity;
            for (int place = 0; place < Places; place++)
            {
                double part = Nearest + ((Farthest - Nearest) * place / (Places - 1));
                Vector3D direction = (disc.Centre + (part * way)).Normalized();
                double radius = ground.RadiusAt(direction);
                if (radius > highest)
                {
                    (highest, rim[i]) = (radius, radius * direction);
                }
            }
        }

        return rim;
    }
}
