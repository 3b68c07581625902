using Msisf.App.Preparation;
using Msisf.Core.Illumination;
using Msisf.Core.Time;

namespace Msisf.App.Illumination;

/// <summary>The light of places hour by hour over a month (from new Moon to new Moon it takes 29.5 days).</summary>
/// <param name="From">MJD, UTC, of the first hour.</param>
internal sealed record MonthOfLight(double From, IReadOnlyList<MonthOfLight.Place> Places)
{
    private const int HalfDays = 15;
    private const int Steps = 721;

    /// <summary>Finds it.</summary>
    /// <param name="model">The ground.</param>
    /// <param name="directions">Places, BODY_FIXED, length 1.</param>
    /// <param name="sunAt">Says where the Sun is at times, m, BODY_FIXED.</param>
    public static MonthOfLight Find(
        ElevationModel model, Vector3D[] directions, Instant middle,
        Func<IEnumerable<Instant>, Vector3D[]> sunAt, int threads, CancellationToken cancellation)
    {
        Instant from = middle + (-HalfDays * Duration.Day);
        Vector3D[] suns = sunAt(Enumerable.Range(0, Steps).Select(hour => from + (hour * Duration.OfSeconds(3600))));
        HorizonSurvey survey = new(model.Grid, model.Tracer, directions, isMoon: true);
        LightSurvey lights = new(survey, new LightConditions(suns, suns) { IsExact = true });
        PlaceHorizons horizons = survey.Find(directions, 0.0, threads, null, cancellation);
        return new MonthOfLight(from.Mjd, [.. directions.Select((_, place) =>
        {
            (PlaceLight light, float[] parts) = lights.At(directions, horizons, place);
            return new Place(parts, light.LitSteps / (double)Steps, light.Light.Count, light.Dark.Count);
        })]);
    }

    /// <summary>The light of a place.</summary>
    /// <param name="Parts">Visible part of the Sun's disc at each hour, by area, 0 to 1.</param>
    /// <param name="Lit">Part of the hours with any of the Sun in view.</param>
    /// <param name="LongestLight">h.</param>
    /// <param name="LongestDark">h.</param>
    internal sealed record Place(float[] Parts, double Lit, int LongestLight, int LongestDark);
}
