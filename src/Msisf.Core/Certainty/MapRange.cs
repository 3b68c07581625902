using Msisf.Core.Camera;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Terrain;

namespace Msisf.Core.Certainty;

/// <summary>
/// Range of what a map multiplies a law's radiance factor by (<see cref="AlbedoSampler"/>) where a sample may lie anywhere in a ball. Keeps
/// buffers, so each thread needs its own object.
/// </summary>
/// <param name="camera">The camera.</param>
/// <param name="map">The map.</param>
/// <param name="options">How the image is drawn.</param>
/// <param name="uncertainty">The camera's limits.</param>
internal sealed class MapRange(FrameCamera camera, AlbedoMap map, NativeRenderOptions options, Uncertainty uncertainty)
{
    /// <summary>Cosine of the emission angle below which footprints grow no further (<see cref="FootprintLanes"/>).</summary>
    private const double LeastCosine = 1.0 / 64.0;

    /// <summary>Part by which a footprint may change: beyond, all levels count.</summary>
    private const double GreatestChange = 0.4;

    /// <summary>Pixels of a level along a side of what is looked at: beyond, the whole level counts.</summary>
    private const int MostPixels = 64;

    private readonly MapFootprints _footprints = new();
    private readonly SunlitPoints _points = new();
    private readonly Interval?[] _wholeLevels = new Interval?[map.Levels.Count];
    private readonly List<double> _xs = [];
    private readonly List<double> _ys = [];

    private readonly double _perReference = 1.0 / options.Reflectance.RadianceFactor(
        map.Reference.CosIncidence, map.Reference.CosEmission, map.Reference.PhaseHaversine);

    /// <summary>The range.</summary>
    /// <param name="centre">m, body-fixed.</param>
    /// <param name="radius">m.</param>
    public Interval Of(Vector3D centre, double radius)
    {
        _points.Clear(1);
        _points.Add(0, 1.0, centre, centre.Normalized(), 1.0);
        _footprints.Find(_points, camera, 1.0 / options.SubsamplesPerAxis, map);
        Vector3D toCamera = camera.PositionBodyFixed - centre;
        (double range, double fromCentre) = (toCamera.Length, centre.Length);
        double moved = radius + uncertainty.Position;
        double depth = -Vector3D.Dot(camera.ForwardBodyFixed, toCamera);
        double angle = BandSearch.AngleOf(radius, fromCentre);
        double cosLatitude = Math.Sqrt((centre.X * centre.X) + (centre.Y * centre.Y)) / fromCentre;
        double cosine = Math.Max(LeastCosine, Vector3D.Dot(centre, toCamera) / (range * fromCentre));
        double change = ((moved + (range * uncertainty.Turn)) / depth) + ((angle + (moved / range)) / cosine) + (2.0 * angle / cosLatitude);
        if (!(change < GreatestChange && depth > 0.0))
        {
            return Enumerable.Range(0, map.Levels.Count).Select(WholeLevel).Aggregate((a, b) => a.Hull(b));
        }

        double right = 1.01 * angle / cosLatitude * map.Levels[0].Width / map.Extent.Width; // the change bounds angle / cosLatitude
        double down = angle * map.Levels[0].Height / map.Extent.Height;
        double axis = (1.0 + change) / cosLatitude * double.Hypot(_footprints.AxisX[0], _footprints.AxisY[0]);
        if (axis <= 1.0)
        {
            // Smaller than a pixel of the finest level, whatever the change: it is read at one place.
            return InLevel(0, right, down);
        }

        int first = Math.Max(0, (int)_footprints.Levels[0] - 1);
        int last = Math.Min(map.Levels.Count - 1, (int)_footprints.Levels[0] + 2);
        Interval found = InLevel(first, right + (0.5 * axis), down + (0.5 * axis));
        for (int level = first + 1; level <= last; level++)
        {
            found = found.Hull(InLevel(level, right + (0.5 * axis), down + (0.5 * axis)));
        }

        return found;
    }

    /// <summary>The range of a level's values between its pixels, which are linear along both axes in each square of four.</summary>
    /// <param name="right">To each side of the footprint's middle, pixels of the finest level.</param>
    /// <param name="down">The same along columns.</param>
    private Interval InLevel(int level, double right, double down)
    {
        AlbedoMapLevel wanted = map.Levels[level];
        if (!Corners(_xs, _footprints.X[0], right, (double)wanted.Width / map.Levels[0].Width)
            || !Corners(_ys, _footprints.Y[0], down, (double)wanted.Height / map.Levels[0].Height))
        {
            return WholeLevel(level);
        }

        MapLevelReader reader = new(map, level);
        (double least, double greatest) = (double.PositiveInfinity, 0.0);
        foreach (double y in _ys)
        {
            foreach (double x in _xs)
            {
                double code = reader.At(x, y);
                (least, greatest) = (Math.Min(least, code), Math.Max(greatest, code));
            }
        }

        // Beside pixels without data the others count alone, in steps.
        return least > 0.0 && !HasGaps(level) ? ScaleOf(least, greatest) : WholeLevel(level);
    }

    private static bool Corners(List<double> corners, double middle, double reach, double scale)
    {
        corners.Clear();
        corners.Add(middle - reach);
        double first = Math.Ceiling(((middle - reach) * scale) - 0.5);
        double last = Math.Floor(((middle + reach) * scale) - 0.5);
        if (!(last - first < MostPixels))
        {
            return false;
        }

        for (double pixel = first; pixel <= last; pixel++)
        {
            corners.Add((pixel + 0.5) / scale);
        }

        corners.Add(middle + reach);
        return true;
    }

    private bool HasGaps(int level) => WholeLevel(level).Low == 0.0;

    /// <summary>The range of a whole level; from 0 on if it has pixels without data, where the law counts alone.</summary>
    private Interval WholeLevel(int level)
    {
        if (_wholeLevels[level] is { } known)
        {
            return known;
        }

        (int least, int greatest) = (int.MaxValue, 0);
        bool hasGaps = !(map.Extent.ReachesNorthPole && map.Extent.ReachesSouthPole);
        foreach (ushort code in map.Levels[level].Codes.Span)
        {
            (least, greatest, hasGaps) = (Math.Min(least, code == 0 ? least : code), Math.Max(greatest, code), hasGaps || code == 0);
        }

        Interval whole = ScaleOf(least, greatest);
        whole = hasGaps ? new Interval(0.0, Math.Max(1.0, whole.High)) : whole;
        _wholeLevels[level] = whole;
        return whole;
    }

    private Interval ScaleOf(double least, double greatest) =>
        _perReference * (map.Offset + (map.Step * new Interval(least, greatest)));
}
