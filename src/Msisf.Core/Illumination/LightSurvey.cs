using Msisf.Core.Numerics;
using Msisf.Core.Parallel;
using Msisf.Core.Time;
using Msisf.Core.Tracing;

namespace Msisf.Core.Illumination;

/// <summary>Finds the light of places over an interval from their horizons. Safe for several threads.</summary>
public sealed class LightSurvey
{
    /// <summary>m: nominal radius of the Sun (IAU 2015 Resolution B3).</summary>
    public const double SunRadius = 695_700e3;

    /// <summary>m: mean radius of the Earth (B. A. Archinal et al., Celest. Mech. Dyn. Astr. 130 (2018) 22, table 4).</summary>
    public const double EarthRadius = 6_371_008.4;

    private readonly HorizonSurvey _horizons;
    private readonly LightConditions _conditions;
    private readonly LightTimes _sun;
    private readonly LightTimes _earth;
    private readonly ExactLight _exact;

    /// <summary>Prepares an interval.</summary>
    /// <param name="horizons">How horizons were found.</param>
    /// <param name="conditions">The bodies' places and what is asked for.</param>
    /// <param name="tracer">Of the same terrain.</param>
    public LightSurvey(HorizonSurvey horizons, LightConditions conditions, ITerrainTracer tracer)
    {
        (_horizons, _conditions) = (horizons, conditions);
        double radius = conditions.IsPoint ? 0.0 : SunRadius;
        _sun = new LightTimes(conditions.SunBodyFixed, radius);
        _earth = new LightTimes(conditions.EarthMoonMe, EarthRadius);
        _exact = new ExactLight(tracer, conditions.SunBodyFixed, radius);
    }

    /// <summary>The light of places.</summary>
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
                lights[place] = Of(finder, directions, horizons, place);
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
    /// <param name="frame">The place.</param>
    /// <param name="horizon">As <see cref="HorizonOf"/> gives it.</param>
    /// <param name="before">A time before.</param>
    /// <param name="after">A time after.</param>
    /// <param name="isRise">Whether it begins.</param>
    /// <param name="sunAt">The Sun at a time, m, body-fixed.</param>
    public ModifiedJulianDate ChangeBetween(
        LocalFrame frame, float[] horizon, ModifiedJulianDate before, ModifiedJulianDate after, bool isRise,
        Func<ModifiedJulianDate, Vector3D> sunAt)
    {
        (double low, double high) = (before.Days, after.Days);
        while (high - low > 0.5 / 86400.0)
        {
            ModifiedJulianDate middle = new(0.5 * (low + high));
            (low, high) = _exact.IsVisible(frame, horizon, sunAt(middle)) == isRise ? (low, middle.Days) : (middle.Days, high);
        }

        return new ModifiedJulianDate(0.5 * (low + high));
    }

    /// <summary>The stored horizon of a place.</summary>
    /// <param name="horizons">Horizons of places.</param>
    /// <param name="place">Which of them.</param>
    /// <returns>Tangent of the elevation at each column of azimuth, and after them that of the first again.</returns>
    public float[] HorizonOf(PlaceHorizons horizons, int place)
    {
        float[] tangents = new float[HorizonProfile.TableLength(HorizonSurvey.Columns)];
        _horizons.Profile.Read(CornersOf(horizons, place), tangents);
        return tangents[..(HorizonSurvey.Columns + 1)];
    }

    private static ReadOnlySpan<uint> CornersOf(PlaceHorizons horizons, int place)
    {
        int start = place == 0 ? 0 : horizons.Ends[place - 1];
        return horizons.Corners.AsSpan(start, horizons.Ends[place] - start);
    }

    private LightFinder NewFinder(float[]? parts) => new(
        _sun, _earth, _conditions.FluxAtAu, _conditions.FixedPlane, _conditions.NightLimit, HorizonSurvey.Columns,
        Math.Tan(double.DegreesToRadians(_horizons.TopDegrees)))
    {
        Exact = _conditions.IsExact ? _exact : null,
        Parts = parts,
    };

    private PlaceLight Of(LightFinder finder, IReadOnlyList<Vector3D> directions, PlaceHorizons horizons, int place)
    {
        _horizons.Profile.Read(CornersOf(horizons, place), finder.Table.Tangents);
        return finder.Of(LocalFrame.At(horizons.Radii[place] * directions[place]));
    }
}

/// <summary>What light is asked for.</summary>
/// <param name="SunBodyFixed">The Sun at each step, m, body-fixed.</param>
/// <param name="EarthMoonMe">The Earth at each step, m, body-fixed.</param>
public sealed record LightConditions(IReadOnlyList<Vector3D> SunBodyFixed, IReadOnlyList<Vector3D> EarthMoonMe)
{
    /// <summary>Whether the Sun is a point.</summary>
    public bool IsPoint { get; init; }

    /// <summary>Whether the exact tracer decides what the horizon's error leaves open.</summary>
    public bool IsExact { get; init; }

    /// <summary>W/m^2 at one astronomical unit.</summary>
    public double FluxAtAu { get; init; } = 1361.0;

    /// <summary>Normal of the chosen plane along east, north and up, length 1.</summary>
    public Vector3D FixedPlane { get; init; } = Vector3D.UnitZ;

    /// <summary>Steps: longer times without Sun are counted.</summary>
    public double NightLimit { get; init; } = double.PositiveInfinity;
}
