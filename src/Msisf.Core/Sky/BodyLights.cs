using System.Collections.Concurrent;
using Msisf.Core.Camera;
using Msisf.Core.Detector;
using Msisf.Core.Parallel;
using Msisf.Core.Tracing;

namespace Msisf.Core.Sky;

/// <summary>
/// Planets, the Earth and the Sun in one image: discs whose points are looked for on a grid of the pixels, each with its own brightness and
/// hidden by its own ground. A disc that is smaller than a grid can tell is a point. Safe for several threads.
/// </summary>
/// <param name="axes">How the sky lies, for each band of the camera.</param>
/// <param name="tracer">Traces rays through the ground that the image shows.</param>
/// <param name="ofSunlight">What sunlight at 1 au counts: electrons per second and m^2, or radiance factors times steradians.</param>
public sealed class BodyLights(IReadOnlyList<SkyAxes> axes, ITerrainTracer tracer, double ofSunlight) : IPointLights
{
    /// <summary>px: discs of a smaller radius are points.</summary>
    private const double SmallestDisc = 0.05;

    /// <summary>Points of the grid over the radius of a disc, at least.</summary>
    private const double PointsOfRadius = 40.0;

    private const int MostSubsamples = 64;

    /// <summary>px: discs of a larger radius are sampled once a pixel.</summary>
    private const double LargeDisc = 100.0;

    /// <summary>px that a disc may move from one instant of an exposure to the next.</summary>
    private const double LongestStep = 0.25;

    /// <summary>px that ground may move in front of a disc from one instant of an exposure to the next.</summary>
    private const double LongestGroundStep = 1.0;

    private const int MaxInstants = 999;

    private readonly ConcurrentDictionary<string, ConcurrentBag<(double Middle, double Electrons)>> _electrons = [];

    /// <inheritdoc/>
    public void Collect(PointExposure exposure, CameraDetector detector, DetectorImage image, CancellationToken cancellation)
    {
        SkyAxes sky = AxesAt(exposure.Middle);
        FrameCamera middle = exposure.CameraAt(exposure.Middle);
        Vector3D velocity = exposure.Velocity;
        foreach (BodyPlace place in sky.Bodies)
        {
            int instants = InstantsOf(place);
            double added = 0.0;
            for (int instant = 0; instant < instants; instant++)
            {
                cancellation.ThrowIfCancellationRequested();
                double time = exposure.Middle + (exposure.Span * (((instant + 0.5) / instants) - 0.5));
                FrameCamera camera = instants == 1 ? middle : exposure.CameraAt(time);
                double share = place.OverSunlight * ofSunlight / instants;
                Sample(camera, sky, place, time, detector.PointReach + 1, (x, y, direction, part, isHidden) =>
                {
                    if (!isHidden)
                    {
                        added += detector.PointImage.Add(
                            image.Electrons, image.Width, (exposure.Rows.First, exposure.Rows.End), x, y + exposure.Rows.First,
                            detector.PointElectrons(part * share, camera, direction));
                    }
                });
            }

            _electrons.GetOrAdd(place.Body.Name, static _ => []).Add((exposure.Middle, added));
        }

        int InstantsOf(BodyPlace place)
        {
            if (exposure.Span == 0.0)
            {
                return 1;
            }

            double ofSky = exposure.AngularSpeed + sky.BodyRate + ((velocity.Length + place.VelocityJ2000.Length) / place.Distance);
            double ofGround = GroundAhead.Rate(
                middle.PositionBodyFixed, velocity, exposure.Span,
                sky.DrawnDirection(place.ApparentJ2000, middle.MoonFromCamera, exposure.Middle), place.AngularRadius, tracer.MaxRadius);
            double rate = Math.Max(ofSky / LongestStep, ofGround / LongestGroundStep);
            return (int)Math.Clamp(Math.Ceiling(rate * exposure.Span / middle.PixelTangent), 1.0, MaxInstants);
        }
    }

    /// <summary>The bodies that the image shows, and without a detector what they add to pixels.</summary>
    /// <param name="camera">The camera of the image.</param>
    /// <param name="hasDetector">Whether electrons were collected.</param>
    /// <param name="factors">Gets the radiance factors that they add to pixels, at 1 au from the Sun; null for nobody.</param>
    public BodiesOfFrame Find(ICamera camera, bool hasDetector, Dictionary<int, double>? factors, CancellationToken cancellation)
    {
        Dictionary<string, (BodyView View, double Distance, double Light, double Shown)> found = [];
        foreach ((PixelRows rows, FrameCamera band) in camera.Bands)
        {
            cancellation.ThrowIfCancellationRequested();
            SkyAxes sky = AxesAt(band.State.Seconds);
            foreach (BodyPlace place in sky.Bodies)
            {
                double light = 0.0;
                double shown = 0.0;
                Sample(band, sky, place, band.State.Seconds, 0, (x, y, direction, part, isHidden) =>
                {
                    int column = (int)Math.Floor(x + 0.5) - 1;
                    int row = (int)Math.Floor(y + 0.5) - 1;
                    if (column < 0 || column >= band.Width || row < 0 || row >= band.Height)
                    {
                        return;
                    }

                    light += part;
                    shown += isHidden ? 0.0 : part;
                    if (factors is not null && !isHidden)
                    {
                        int pixel = ((row + rows.First) * camera.Width) + column;
                        factors[pixel] = factors.GetValueOrDefault(pixel)
                            + (part * place.OverSunlight * ofSunlight / band.SolidAngle(direction));
                    }
                });
                if (light > 0.0)
                {
                    Join(found, place, band, rows, sky, light, shown);
                }
            }
        }

        return new BodiesOfFrame([.. found.Values.Select(one => one.View with
        {
            Visible = one.Shown / one.Light,
            Electrons = hasDetector
                ? (_electrons.GetValueOrDefault(one.View.Place.Body.Name) ?? []).OrderBy(part => part.Middle).Sum(part => part.Electrons)
                : null,
        })]);
    }

    /// <summary>Keeps of several bands the view of that which has the body's centre nearest.</summary>
    private static void Join(
        Dictionary<string, (BodyView View, double Distance, double Light, double Shown)> found, BodyPlace place, FrameCamera band,
        PixelRows rows, SkyAxes sky, double light, double shown)
    {
        Vector3D centre = sky.DrawnDirection(place.ApparentJ2000, band.MoonFromCamera, band.State.Seconds);
        if (!band.TryProject(centre, out RenderingPoint point))
        {
            return;
        }

        double distance = Math.Max(0.0, Math.Abs(point.Y - (0.5 * (1.0 + band.Height))) - (0.5 * band.Height));
        double radius = Trigonometry.Sin(place.AngularRadius) / Math.Sqrt(band.SolidAngle(centre));
        BodyView view = new(place, point.X, point.Y + rows.First, radius, 0.0);
        (double before, double seen) = (0.0, 0.0);
        if (found.TryGetValue(place.Body.Name, out (BodyView View, double Distance, double Light, double Shown) other))
        {
            (before, seen) = (other.Light, other.Shown);
            (view, distance) = other.Distance <= distance ? (other.View, other.Distance) : (view, distance);
        }

        found[place.Body.Name] = (view, distance, before + light, seen + shown);
    }

    /// <summary>Looks at the points of a disc that lie in the image or near it.</summary>
    /// <param name="margin">px.</param>
    /// <param name="take">Gets place, direction, part of the body's light, and whether ground hides it.</param>
    private void Sample(
        FrameCamera camera, SkyAxes sky, BodyPlace body, double seconds, int margin,
        Action<double, double, Vector3D, double, bool> take)
    {
        BodyPlace place = sky.Seen(body, camera.PositionBodyFixed, seconds);
        Vector3D Drawn(Vector3D inJ2000) => sky.DrawnDirection(inJ2000, camera.MoonFromCamera, seconds);
        Vector3D centre = Drawn(place.ApparentJ2000);
        double cosine = Vector3D.Dot(centre, camera.ForwardBodyFixed);
        double reach = Math.Atan(camera.Model.BorderTangent()) + place.AngularRadius
            + ((margin + 1.0) * Math.Sqrt(2.0) / Math.Min(camera.Model.FocalX, camera.Model.FocalY));
        if (cosine <= 0.0 || cosine < Trigonometry.Cos(Math.Min(reach, 0.5 * Math.PI))
            || !camera.TryProject(centre, out RenderingPoint middle))
        {
            return;
        }

        double radius = Trigonometry.Sin(place.AngularRadius) / Math.Sqrt(camera.SolidAngle(centre));
        if (radius < SmallestDisc)
        {
            if (middle.X > 0.5 - margin && middle.X < camera.Width + 0.5 + margin
                && middle.Y > 0.5 - margin && middle.Y < camera.Height + 0.5 + margin)
            {
                take(middle.X, middle.Y, centre, 1.0, IsHidden(centre));
            }

            return;
        }

        BodyDisc disc = new(place, centre, Drawn);
        int perPixel = radius > LargeDisc ? 1 : (int)Math.Clamp(Math.Ceiling(PointsOfRadius / radius), 2.0, MostSubsamples);
        Box box = Box.Of(camera, centre, place.AngularRadius, margin);
        for (int row = box.Top * perPixel; row < (box.Bottom + 1) * perPixel; row++)
        {
            for (int column = box.Left * perPixel; column < (box.Right + 1) * perPixel; column++)
            {
                double x = ((column + 0.5) / perPixel) - 0.5;
                double y = ((row + 0.5) / perPixel) - 0.5;
                Vector3D direction = camera.RayThrough(x, y).Direction.Normalized();
                double light = disc.LightFrom(direction);
                if (light > 0.0)
                {
                    take(x, y, direction, light * camera.SolidAngle(direction) / (perPixel * perPixel), IsHidden(direction));
                }
            }
        }

        bool IsHidden(Vector3D direction) => tracer.TryTrace(new Ray(camera.PositionBodyFixed, direction), out _);
    }

    private SkyAxes AxesAt(double seconds) => axes.MinBy(one => Math.Abs(one.Seconds - seconds))!;

    /// <summary>Pixels around a disc, from 1, cut off some pixels outside the image.</summary>
    private readonly record struct Box(int Left, int Top, int Right, int Bottom)
    {
        /// <summary>Points of the outline that are projected.</summary>
        private const int Outline = 32;

        public static Box Of(FrameCamera camera, Vector3D centre, double radius, int margin)
        {
            Vector3D across = Vector3D.Cross(centre, Math.Abs(centre.X) < 0.9 ? Vector3D.UnitX : Vector3D.UnitY).Normalized();
            Vector3D along = Vector3D.Cross(centre, across);
            (double left, double top, double right, double bottom) =
                (double.PositiveInfinity, double.PositiveInfinity, double.NegativeInfinity, double.NegativeInfinity);
            (double sine, double cosine) = Trigonometry.SinCos(radius * 1.01); // the outline between its points
            bool isWhole = true;
            for (int i = 0; i < Outline; i++)
            {
                (double v, double u) = Trigonometry.SinCos(2.0 * Math.PI * i / Outline);
                Vector3D edge = (cosine * centre) + (sine * ((u * across) + (v * along)));
                if (!camera.TryProject(edge, out RenderingPoint point))
                {
                    isWhole = false;
                    continue;
                }

                (left, right) = (Math.Min(left, point.X), Math.Max(right, point.X));
                (top, bottom) = (Math.Min(top, point.Y), Math.Max(bottom, point.Y));
            }

            if (!isWhole)
            {
                (left, top, right, bottom) = (-margin, -margin, camera.Width + 1.0 + margin, camera.Height + 1.0 + margin);
            }

            return new Box(
                (int)Math.Clamp(Math.Floor(left), 1.0 - margin, camera.Width + 1.0 + margin),
                (int)Math.Clamp(Math.Floor(top), 1.0 - margin, camera.Height + 1.0 + margin),
                (int)Math.Clamp(Math.Ceiling(right), -margin, camera.Width + margin),
                (int)Math.Clamp(Math.Ceiling(bottom), -margin, camera.Height + margin));
        }
    }
}
