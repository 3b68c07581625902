using Msisf.Core.Ephemeris;
using Msisf.Core.Parallel;
using Msisf.Core.Time;

namespace Msisf.Core.Illumination;

/// <summary>Finds the light of places over an interval from their horizons. Safe for several threads.</summary>
public sealed class LightSurvey
{
    private readonly HorizonSurvey _horizons;
    private readonly LightConditions _conditions;
    private readonly LightTimes _sun;
    private readonly LightTimes _earth;
    private readonly ExactLight _exact;

    /// <summary>Prepares an interval.</summary>
    /// <param name="horizons">How horizons were found.</param>
    /// <param name="conditions">The bodies' places and what is asked for.</param>
    public LightSurvey(HorizonSurvey horizons, LightConditions conditions)
    {
        (_horizons, _conditions) = (horizons, conditions);
        double radius = conditions.IsPoint ? 0.0 : AstronomicalConstants.SunRadius;
        _sun = new LightTimes(conditions.SunBodyFixed, radius);
        _earth = new LightTimes(conditions.EarthBodyFixed, AstronomicalConstants.EarthRadius);
        _exact = new ExactLight(conditions.SunBodyFixed, radius);
    }

    /// <summary>The light of places; <c>default</c> of those without ground.</summary>
    /// <param name="directions">MOON_ME, length 1.</param>
    /// <param name="horizons">Their horizons.</param>
    /// <param name="threads">How many work at once.</param>
    /// <param name="advanced">Called with the number of places done since the last call, from any thread.</param>
    /// <param name="cancellation">Stops the work.</param>
    public PlaceLight[] Of(
        IReadOnlyList<Vector3D> directions, PlaceHorizons horizons, int threads, Action<int>? advanced, CancellationToken cancellation)
    {
        const int PerItem = 128;
        int items = (directions.Count + PerItem - 1) / PerItem;
        PlaceLight[] lights = new PlaceLight[directions.Count];
        LightFinder[] finders = new LightFinder[Math.Max(1, Math.Min(threads, items))];
        WorkerTeam.Run(finders.Length, items, (worker, item) =>
        {
            LightFinder finder = finders[worker] ??= NewFinder(null);
            finder.Forget();
            int end = Math.Min(directions.Count, (item + 1) * PerItem);
            for (int place = item * PerItem; place < end; place++)
            {
                lights[place] = horizons.HasGround(place) ? Of(finder, directions, horizons, place) : default;
            }

            advanced?.Invoke(end - (item * PerItem));
        }, cancellation);
        return lights;
    }

    /// <summary>The light of one place with the visible part of the Sun's disc at each step, by area; above 0 where any is seen.</summary>
    /// <param name="directions">MOON_ME, length 1.</param>
    /// <param name="horizons">Their horizons.</param>
    /// <param name="place">Which of them.</param>
    public (PlaceLight Light, float[] Parts) At(IReadOnlyList<Vector3D> directions, PlaceHorizons horizons, int place)
    {
        float[] parts = new float[_sun.X.Length];
        PlaceLight light = Of(NewFinder(parts), directions, horizons, place);
        return (light, parts[.._sun.Count]);
    }

    /// <summary>Finds by rays of the exact tracer when light begins or ends at a place above the ground, to half a second.</summary>
    /// <param name="rays">From the place.</param>
    /// <param name="horizon">As <see cref="HorizonSurvey.HorizonOf"/> gives it.</param>
    /// <param name="before">A time before.</param>
    /// <param name="after">A time after.</param>
    /// <param name="isRise">Whether it begins.</param>
    /// <param name="sunAt">The Sun at a time, m, body-fixed.</param>
    public Instant ChangeBetween(
        PlaceRays rays, float[] horizon, Instant before, Instant after, bool isRise,
        Func<Instant, Vector3D> sunAt)
    {
        (double low, double high) = (0.0, after.SecondsSince(before));
        while (high - low > 0.5)
        {
            double middle = 0.5 * (low + high);
            (low, high) = _exact.IsVisible(rays, horizon, sunAt(before.After(middle))) == isRise ? (low, middle) : (middle, high);
        }

        return before.After(0.5 * (low + high));
    }

    private LightFinder NewFinder(float[]? parts) => new(
        _sun, _earth, _conditions, Math.Tan(double.DegreesToRadians(_horizons.Band.TopDegrees)))
    {
        Exact = _conditions.IsExact ? _exact : null,
        Parts = parts,
    };

    private PlaceLight Of(LightFinder finder, IReadOnlyList<Vector3D> directions, PlaceHorizons horizons, int place)
    {
        _horizons.Profile.Read(horizons.CornersOf(place), finder.Table.Tangents);
        return finder.Of(_horizons.RaysFrom(LocalFrame.At(horizons.Radii[place] * directions[place])));
    }
}

/// <summary>What light is asked for.</summary>
/// <param name="SunBodyFixed">The Sun at each step, m, body-fixed.</param>
/// <param name="EarthBodyFixed">The Earth at each step, m, body-fixed.</param>
public sealed record LightConditions(IReadOnlyList<Vector3D> SunBodyFixed, IReadOnlyList<Vector3D> EarthBodyFixed)
{
    /// <summary>Whether the Sun is a point.</summary>
    public bool IsPoint { get; init; }

    /// <summary>Whether the exact tracer decides what the horizon's error leaves open.</summary>
    public bool IsExact { get; init; }

    /// <summary>Normal of the chosen plane along east, north and up, length 1.</summary>
    public Vector3D FixedPlane { get; init; } = Vector3D.UnitZ;

    /// <summary>Steps: longer times without Sun are counted.</summary>
    public double NightLimit { get; init; } = double.PositiveInfinity;
}
