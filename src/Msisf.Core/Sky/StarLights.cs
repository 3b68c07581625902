using System.Collections.Concurrent;
using Msisf.Core.Camera;
using Msisf.Core.Detector;
using Msisf.Core.Detector.Psf;
using Msisf.Core.Navigation;
using Msisf.Core.Parallel;
using Msisf.Core.Tracing;

namespace Msisf.Core.Sky;

/// <summary>
/// The stars of one image: where they are, what hides them, and their light in the detector. A star is followed over each exposure; ground
/// in front of it takes its light just as long as it is there. Safe for several threads.
/// </summary>
/// <param name="sky">The sky of the image.</param>
/// <param name="tracer">Traces rays through the ground that the image shows.</param>
/// <param name="brightness">Electrons per second and m^2 of each star.</param>
public sealed class StarLights(FrameSky sky, ITerrainTracer tracer, StarBrightness brightness) : IPointLights
{
    /// <summary>px: along a segment of this length a path differs from its chord by less than 1e-6 px.</summary>
    private const double LongestSegment = 0.5;

    /// <summary>Maximum number of segments of an exposure.</summary>
    private const int MaxSegments = 8192;

    /// <summary>px that ground may move in front of a star from one look at it to the next.</summary>
    private const double LongestGroundStep = 0.5;

    /// <summary>Maximum number of looks at the ground in a segment.</summary>
    private const int MaxChecks = 1024;

    /// <summary>Half the distance of the points of Gauss's rule of two on a segment of length 1.</summary>
    private const double GaussOffset = 0.28867513459481287; // 0.5 / sqrt(3)

    private readonly ConcurrentDictionary<int, ConcurrentBag<StarExposure>> _exposures = [];

    /// <inheritdoc/>
    public void Collect(PointExposure exposure, CameraDetector detector, DetectorImage image, CancellationToken cancellation)
    {
        PointImage spread = detector.PointImage;
        SkyAxes axes = sky.AxesAt(exposure.Middle);
        double speed = exposure.Span == 0.0 ? 0.0 : exposure.AngularSpeed + axes.BodyRate;
        FrameCamera middle = exposure.CameraAt(exposure.Middle);
        double pixels = speed * exposure.Span / middle.PixelTangent;
        int segments = exposure.Span == 0.0
            ? 0
            : (int)Math.Clamp(Math.Ceiling(pixels / Math.Min(LongestSegment, spread.Scale)), 1.0, MaxSegments);
        double[] times = segments == 0
            ? [exposure.Middle]
            : [.. Enumerable.Range(0, segments + 1).Select(index => exposure.Middle + (exposure.Span * ((double)index / segments - 0.5)))];
        FrameCamera[] cameras = [.. times.Select(time => time == exposure.Middle ? middle : exposure.CameraAt(time))];
        double reach = Math.Atan(middle.Model.BorderTangent()) + (0.5 * speed * exposure.Span)
            + ((spread.Radius + 1.0) * Math.Sqrt(2.0) / Math.Min(middle.Model.FocalX, middle.Model.FocalY));
        double cosine = reach < Math.PI ? Trigonometry.Cos(reach) : -1.0;
        PointTrack track = new(exposure, axes, tracer, times, cameras);
        Vector3D velocity = exposure.Velocity;
        for (int index = 0; index < sky.Stars.Count; index++)
        {
            cancellation.ThrowIfCancellationRequested();
            Star star = sky.Stars[index];
            Vector3D apparent = axes.ApparentJ2000(star);
            Vector3D drawn = axes.DrawnDirection(apparent, middle.MoonFromCamera, exposure.Middle);
            if (Vector3D.Dot(drawn, middle.ForwardBodyFixed) < cosine || !track.Follow(apparent, spread.Radius))
            {
                continue;
            }

            // A body moves before the stars by little while a shutter is open.
            double electrons = axes.BodyIn(drawn, middle, exposure.Middle) is null
                ? detector.PointElectrons(brightness.Of(star), middle, drawn)
                : 0.0;
            double added = 0.0;
            double ofGround = GroundAhead.Rate(middle.PositionBodyFixed, velocity, exposure.Span, drawn, 0.0, tracer.MaxRadius)
                * exposure.Span / middle.PixelTangent;
            int checks = (int)Math.Clamp(Math.Ceiling(ofGround / (LongestGroundStep * Math.Max(1, segments))), 1.0, MaxChecks);
            foreach ((RenderingPoint from, RenderingPoint to, double share) in electrons == 0.0 ? [] : track.Visible(checks))
            {
                added += Expose(spread, image, exposure.Rows, from, to, share * electrons);
            }

            _exposures.GetOrAdd(index, static _ => []).Add(new StarExposure(exposure.Middle, added, track.InRows()));
        }
    }

    /// <summary>The stars of the image, when all exposures are collected.</summary>
    /// <param name="camera">The camera of the image.</param>
    /// <param name="hasDetector">Whether electrons were collected.</param>
    /// <param name="threads">Number of threads; the result does not depend on it.</param>
    public StarsOfFrame Find(ICamera camera, bool hasDetector, int threads, CancellationToken cancellation)
    {
        List<StarView>[] views = [.. sky.Stars.Select(_ => new List<StarView>())];
        foreach ((PixelRows rows, FrameCamera band) in camera.Bands)
        {
            SkyAxes axes = sky.AxesAt(band.State.Seconds);
            double reach = Math.Atan(band.Model.BorderTangent());
            double cosine = Trigonometry.Cos(reach);
            WorkerTeam.Run(threads, sky.Stars.Count, (_, index) =>
            {
                Vector3D apparent = axes.ApparentJ2000(sky.Stars[index]);
                Vector3D drawn = axes.DrawnDirection(apparent, band.MoonFromCamera, band.State.Seconds);
                if (Vector3D.Dot(drawn, band.ForwardBodyFixed) >= cosine && band.TryProject(drawn, out RenderingPoint point)
                    && IsInside(band, point))
                {
                    views[index].Add(View(index, band, rows, point, apparent, drawn, hasDetector) with
                    {
                        Behind = axes.BodyIn(drawn, band, band.State.Seconds),
                    });
                }
            }, cancellation);
        }

        return new StarsOfFrame([.. views.SelectMany(list => list)]);
    }

    private StarView View(
        int index, FrameCamera band, PixelRows rows, RenderingPoint point, Vector3D apparent, Vector3D drawn, bool hasDetector)
    {
        bool isHidden = tracer.TryTrace(new Ray(band.PositionBodyFixed, drawn), out SurfaceHit hit);
        StarExposure[] exposures = [.. (_exposures.GetValueOrDefault(index) ?? []).OrderBy(exposure => exposure.Middle)];
        (RenderingPoint Start, RenderingPoint End)[] ways =
            [.. exposures.Select(exposure => exposure.Way).OfType<(RenderingPoint, RenderingPoint)>()];
        PixelDerivatives by = PixelDerivatives.At(band, band.PositionBodyFixed + drawn);
        return new StarView(sky.Stars[index], point.X, point.Y + rows.First, apparent, isHidden ? hit.Facet : null)
        {
            Electrons = hasDetector ? exposures.Sum(exposure => exposure.Electrons) : null,
            Streak = ways.Length == 0 ? null : (ways[0].Start, ways[^1].End),
            ByTurn = (by.XByTurn, by.YByTurn),
        };
    }

    /// <summary>Adds the light of a point that moves on a straight line.</summary>
    /// <returns>What falls on the rows.</returns>
    private static double Expose(
        PointImage spread, DetectorImage image, PixelRows rows, RenderingPoint from, RenderingPoint to, double electrons)
    {
        if (from == to)
        {
            return AddAt(0.0, electrons);
        }

        if (!spread.IsPoint)
        {
            return AddAt(0.5 - GaussOffset, 0.5 * electrons) + AddAt(0.5 + GaussOffset, 0.5 * electrons);
        }

        double added = 0.0;
        double last = 0.0;
        foreach (double border in PointTrack.PixelBorders(from, to))
        {
            added += AddAt(0.5 * (last + border), (border - last) * electrons);
            last = border;
        }

        return added;

        double AddAt(double part, double light) => spread.Add(
            image.Electrons, image.Width, (rows.First, rows.End), from.X + (part * (to.X - from.X)),
            from.Y + (part * (to.Y - from.Y)) + rows.First, light);
    }

    private static bool IsInside(FrameCamera camera, RenderingPoint point) =>
        point.X >= 0.5 && point.X < camera.Width + 0.5 && point.Y >= 0.5 && point.Y < camera.Height + 0.5;

    /// <summary>What one exposure has of a star.</summary>
    /// <param name="Middle">s after the image's time.</param>
    /// <param name="Electrons">In its rows.</param>
    /// <param name="Way">Where the star is at the begin and at the end, of its way over the rows; null if there is none.</param>
    private readonly record struct StarExposure(double Middle, double Electrons, (RenderingPoint Start, RenderingPoint End)? Way);
}
