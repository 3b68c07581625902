using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.Core.Ephemeris;
using Msisf.Core.Illumination;
using Msisf.Core.Terrain;
using Msisf.Core.Time;

namespace Msisf.App.Preview;

/// <summary>Says how long the ground below the end of a landing stays lit, by the shadows of the elevation models.</summary>
/// <param name="engine">Gives the Sun.</param>
internal sealed class LandingLight(ElevationModel model, IEphemeris engine, bool isMoon)
{
    /// <summary>m: a run that ends lower over the ground is a landing.</summary>
    private const double LowEnd = 1000.0;

    /// <summary>Hours that are looked at together; so many times <see cref="Chunks"/> are 400 days.</summary>
    private const int ChunkHours = 480;

    private const int Chunks = 20;

    private static readonly Duration Hour = Duration.OfSeconds(3600);

    /// <summary>Whether frames come down to the ground: the last one is the lowest, and less than half as high as the first.</summary>
    /// <param name="heights">m: heights of the cameras over the ground, in order.</param>
    public static bool IsLanding(IReadOnlyList<double> heights) =>
        heights.Count > 1 && heights[^1] < LowEnd && heights[^1] < 0.5 * heights[0] && heights[^1] <= heights.Min();

    /// <param name="positionBodyFixed">The last camera, m.</param>
    public void Write(Vector3D positionBodyFixed, Instant time, ILog log, CancellationToken cancellation)
    {
        Vector3D direction = positionBodyFixed.Normalized();
        SelenographicPoint point = SelenographicPoint.Below(direction);
        HorizonSurvey survey = new(model.Grid, model.Tracer, [direction], isMoon) { IsFine = true };
        if (survey.PlaceAt(direction, 0.0) is null)
        {
            return; // outside a map of a part
        }

        PlaceHorizons horizons = survey.Find([direction], 0.0, threads: 1, advanced: null, cancellation);
        LocalFrame frame = LocalFrame.At(horizons.Radii[0] * direction);
        string site = Invariant(
            $"The target below the last frame, {double.RadiansToDegrees(point.Latitude):F5}, "
                + $"{double.RadiansToDegrees(point.Longitude):F5},");
        bool? isLit = null;
        Instant last = time;
        for (int chunk = 0; chunk < Chunks; chunk++)
        {
            cancellation.ThrowIfCancellationRequested();
            Instant start = last;
            List<Vector3D> suns = SunsFrom(start);
            if (suns.Count < 2)
            {
                break;
            }

            LightSurvey lights = new(survey, new LightConditions(suns, suns) { IsExact = true });
            float[] parts = lights.At([direction], horizons, 0).Parts;
            isLit ??= parts[0] > 0.0f;
            int change = Array.FindIndex(parts, part => part > 0.0f != isLit);
            if (change >= 0)
            {
                Instant exact = lights.ChangeBetween(
                    survey.RaysFrom(frame), survey.HorizonOf(horizons, 0),
                    start + ((change - 1) * Hour), start + (change * Hour),
                    !isLit.Value, at => engine.SunPositionBodyFixed(at));
                log.Note(Text(site, isLit.Value, time, exact));
                return;
            }

            last = start + ((suns.Count - 1) * Hour);
        }

        log.Note(Invariant(
            $"{site} {(isLit == false ? "lies in shadow, and no Sun is seen there" : "is lit, and stays so")} for the "
                + $"{(last - time) / Duration.Day:F1} days that were looked at."));
    }

    private static string Text(string site, bool isLit, Instant time, Instant change)
    {
        string hours = Invariant($"{(change - time) / Hour:F1} h");
        CalendarTime second = change.Utc.RoundedTo(Duration.OfSeconds(1));
        return isLit
            ? $"{site} stays lit for {hours} after it: the Sun sets behind the models' horizon at {second}Z."
            : $"{site} lies in shadow: the Sun rises over the models' horizon at {second}Z, {hours} after it.";
    }

    /// <summary>The Sun hour by hour, as far as the kernels go.</summary>
    private List<Vector3D> SunsFrom(Instant start)
    {
        List<Vector3D> suns = [];
        try
        {
            for (int hour = 0; hour <= ChunkHours; hour++)
            {
                suns.Add(engine.SunPositionBodyFixed(start + (hour * Hour)));
            }
        }
        catch (SpiceException)
        {
            // The kernels end: what is known until then is said.
        }

        return suns;
    }
}
