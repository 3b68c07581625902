using Msisf.Core.Camera;
using Msisf.Core.Detector;
using Msisf.Core.Tracing;

namespace Msisf.Core.Sky;

/// <summary>
/// The way of one star after another over the rows of an exposure: straight segments between the times at which the camera is known. Not
/// thread-safe.
/// </summary>
/// <param name="exposure">The exposure.</param>
/// <param name="axes">How the sky lies.</param>
/// <param name="tracer">Traces rays through the ground that the image shows.</param>
/// <param name="times">s after the image's time, rising; one for an instant.</param>
/// <param name="cameras">At these times.</param>
internal sealed class PointTrack(
    PointExposure exposure, SkyAxes axes, ITerrainTracer tracer, double[] times, FrameCamera[] cameras)
{
    /// <summary>Halvings of a segment in which a star sets or rises: 1e-7 of it is left.</summary>
    private const int Halvings = 24;

    private readonly RenderingPoint?[] _points = new RenderingPoint?[times.Length];
    private Vector3D _apparent;

    /// <summary>Follows a star.</summary>
    /// <param name="apparentJ2000">Where the camera sees it.</param>
    /// <param name="margin">px: how far beyond the rows its light reaches.</param>
    /// <returns>Whether its light may reach the rows.</returns>
    public bool Follow(Vector3D apparentJ2000, double margin)
    {
        _apparent = apparentJ2000;
        bool isNear = false;
        for (int i = 0; i < times.Length; i++)
        {
            _points[i] = cameras[i].TryProject(DirectionAt(cameras[i], times[i]), out RenderingPoint point) ? point : null;
            isNear |= i == 0 || _points[i - 1] is not { } before || _points[i] is not { } after
                ? _points[i] is { } only && Reaches(only, only, margin)
                : Reaches(before, after, margin);
        }

        return isNear;
    }

    /// <summary>The pieces of the way on which no ground hides the star, with their parts of the exposure.</summary>
    /// <param name="checks">How often in each segment the ground is looked for, at least 1.</param>
    public IEnumerable<(RenderingPoint From, RenderingPoint To, double Share)> Visible(int checks)
    {
        if (times.Length == 1)
        {
            return _points[0] is { } only && !IsHidden(cameras[0], times[0]) ? [(only, only, 1.0)] : [];
        }

        return Pieces(checks);
    }

    /// <summary>Where the star enters and leaves the rows; null for an instant, and for a star that does not come over them.</summary>
    /// <returns>Rendering coordinates of the image.</returns>
    public (RenderingPoint Start, RenderingPoint End)? InRows()
    {
        RenderingPoint? start = null;
        RenderingPoint? end = null;
        for (int i = 1; i < times.Length; i++)
        {
            if (_points[i - 1] is { } from && _points[i] is { } to && Clip(from, to) is var (first, last))
            {
                start ??= Between(from, to, first);
                end = Between(from, to, last);
            }
        }

        return start is { } a && end is { } b ? (OfImage(a), OfImage(b)) : null;
    }

    /// <summary>The parts of a segment at which it leaves pixels, rising, and its end.</summary>
    public static IEnumerable<double> PixelBorders(RenderingPoint from, RenderingPoint to) =>
        Crossings(from.X, to.X).Concat(Crossings(from.Y, to.Y)).Append(1.0).Order();

    private static IEnumerable<double> Crossings(double from, double to)
    {
        (double low, double high) = from < to ? (from, to) : (to, from);
        for (double border = Math.Floor(low + 0.5) + 0.5; border < high; border += 1.0)
        {
            yield return (border - from) / (to - from);
        }
    }

    private IEnumerable<(RenderingPoint From, RenderingPoint To, double Share)> Pieces(int checks)
    {
        bool wasHidden = IsHidden(cameras[0], times[0]);
        for (int i = 1; i < times.Length; i++)
        {
            double seenFrom = 0.0; // part of the segment
            for (int check = 1; check <= checks; check++)
            {
                bool isHidden = check == checks ? IsHidden(cameras[i], times[i]) : IsHiddenIn(i, (double)check / checks);
                if (isHidden != wasHidden)
                {
                    double change = ChangeIn(i, ((check - 1.0) / checks, (double)check / checks), wasHidden);
                    if (isHidden && Piece(i, seenFrom, change) is { } seen)
                    {
                        yield return seen;
                    }

                    seenFrom = change;
                }

                wasHidden = isHidden;
            }

            if (!wasHidden && Piece(i, seenFrom, 1.0) is { } last)
            {
                yield return last;
            }
        }
    }

    /// <summary>A piece of a segment; null where the camera can't have it.</summary>
    private (RenderingPoint From, RenderingPoint To, double Share)? Piece(int segment, double start, double end) =>
        _points[segment - 1] is { } from && _points[segment] is { } to
            ? (Between(from, to, start), Between(from, to, end), (end - start) / (times.Length - 1))
            : null;

    /// <summary>The part of a segment, within two others, after which ground hides the star, or no longer does.</summary>
    private double ChangeIn(int segment, (double Before, double After) within, bool wasHidden)
    {
        (double before, double after) = within;
        for (int i = 0; i < Halvings; i++)
        {
            double middle = 0.5 * (before + after);
            (before, after) = IsHiddenIn(segment, middle) == wasHidden ? (middle, after) : (before, middle);
        }

        return 0.5 * (before + after);
    }

    private bool IsHiddenIn(int segment, double part)
    {
        double time = times[segment - 1] + (part * (times[segment] - times[segment - 1]));
        return IsHidden(exposure.CameraAt(time), time);
    }

    private bool IsHidden(FrameCamera camera, double time) =>
        tracer.TryTrace(new Ray(camera.PositionBodyFixed, DirectionAt(camera, time)), out _);

    private Vector3D DirectionAt(FrameCamera camera, double time) => axes.DrawnDirection(_apparent, camera.MoonFromCamera, time);

    private bool Reaches(RenderingPoint a, RenderingPoint b, double margin)
    {
        FrameCamera camera = cameras[0];
        double border = margin + 0.5;
        return Math.Max(a.X, b.X) >= 1.0 - border && Math.Min(a.X, b.X) <= camera.Width + border
            && Math.Max(a.Y, b.Y) >= 1.0 - border && Math.Min(a.Y, b.Y) <= camera.Height + border;
    }

    /// <summary>The part of a segment that lies over the rows; null for none.</summary>
    private (double First, double Last)? Clip(RenderingPoint from, RenderingPoint to)
    {
        (double first, double last) = (0.0, 1.0);
        foreach ((double start, double way, double size) in (ReadOnlySpan<(double, double, double)>)[
            (from.X, to.X - from.X, cameras[0].Width), (from.Y, to.Y - from.Y, cameras[0].Height)])
        {
            double enter = (0.5 - start) / way;
            double leave = (size + 0.5 - start) / way;
            if (way == 0.0)
            {
                (enter, leave) = start >= 0.5 && start <= size + 0.5 ? (0.0, 1.0) : (1.0, 0.0);
            }

            first = Math.Max(first, Math.Min(enter, leave));
            last = Math.Min(last, way == 0.0 ? leave : Math.Max(enter, leave));
        }

        return first < last ? (first, last) : null;
    }

    private static RenderingPoint Between(RenderingPoint from, RenderingPoint to, double part) =>
        new(from.X + (part * (to.X - from.X)), from.Y + (part * (to.Y - from.Y)));

    private RenderingPoint OfImage(RenderingPoint point) => point with { Y = point.Y + exposure.Rows.First };
}
