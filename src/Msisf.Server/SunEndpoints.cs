using Msisf.Adapters.Input;
using Msisf.App.Settings;
using Msisf.Core.Ephemeris;
using Msisf.Core.Preview;
using Msisf.Core.Terrain;
using Msisf.Core.Time;
using System.Text.Json;

namespace Msisf.Server;

/// <summary>
/// GET /v1/sun: where the Sun is at a time, and where it is in the sky of a place. GET /v1/sun/path: where it is at evenly spaced
/// times, for the viewer's time bar.
/// </summary>
internal sealed class SunEndpoints(FrameService frames)
{
    private const int MostTimes = 2001;
    private static readonly string[] Names = ["utc", "mjd", "latitude", "longitude", "ephemeris", "aberration"];

    public static RouteText About { get; } = new(
        "Says where the Sun is at a time, and where it is in the sky of a place.", AnswerForm.Json)
    { Query = Names };

    public static RouteText AboutPath { get; } = new("Says where the Sun is at evenly spaced times (MJD, UTC).", AnswerForm.Json)
    {
        Query = ["from", "to", "count"],
    };

    public Task AnswerAsync(HttpContext context)
    {
        IQueryCollection query = context.Request.Query;
        if (query.Keys.FirstOrDefault(key => !Names.Contains(key)) is { } unknown)
        {
            throw new UsageException($"{NumberText.Shown(unknown)} is not known here; there are {string.Join(", ", Names)}.");
        }

        if (query.ContainsKey("utc") == query.ContainsKey("mjd"))
        {
            throw new UsageException("'utc' or 'mjd' is needed: the time of the Sun's position.");
        }

        if (query.ContainsKey("latitude") != query.ContainsKey("longitude"))
        {
            throw new UsageException("'latitude' and 'longitude' belong together. Give both, or none.");
        }

        CalendarTime utc = TimeText.Parse(Text(query, query.ContainsKey("utc") ? "utc" : "mjd"));
        RenderSettings settings = SettingsOf(query);
        IEphemeris engine = frames.Sessions.Ephemeris.Of(settings).Engine();
        Instant time = engine.TimeScale.InstantOf(utc);
        Vector3D sun = engine.SunPositionBodyFixed(time, settings.Aberration);
        SelenographicPoint below = SelenographicPoint.Below(sun);
        Vector3D direction = sun.Normalized();
        SkyDirection? sky = query.ContainsKey("latitude") ? SkyDirection.Of(PlaceOf(query), sun) : null;
        SunAnswer answer = new(
            time.ToIsoUtc(),
            time.Mjd,
            new PointAnswer(double.RadiansToDegrees(below.Latitude), double.RadiansToDegrees(below.Longitude)),
            [direction.X, direction.Y, direction.Z],
            sun.Length,
            sky is { } above ? double.RadiansToDegrees(above.Elevation) : null,
            sky?.Azimuth is { } azimuth ? double.RadiansToDegrees(azimuth) : null);
        return JsonBody.SendAsync(context.Response, answer);
    }

    public Task AnswerPathAsync(HttpContext context)
    {
        IQueryCollection query = context.Request.Query;
        double from = Number(query, "from");
        double to = Number(query, "to");
        double count = Number(query, "count");
        if (!(to > from) || count is not (>= 2 and <= MostTimes) || count != Math.Floor(count))
        {
            throw new UsageException(
                $"'to' is after 'from', and 'count' a whole number from 2 to {MostTimes}; given were from={query["from"]}, "
                    + $"to={query["to"]}, count={query["count"]}.");
        }

        double step = (to - from) / (count - 1.0);
        TimeScale scale = frames.TimeScale();
        Vector3D[] suns = frames.SunAt(Enumerable.Range(0, (int)count).Select(index => scale.InstantOfMjd(from + (index * step))));
        return JsonBody.SendAsync(
            context.Response, new SunPathAnswer(from, step, suns.Select(sun => (double[])[sun.X, sun.Y, sun.Z])));
    }

    /// <summary>The options of the ephemeris, read as those of a frame.</summary>
    private RenderSettings SettingsOf(IQueryCollection query)
    {
        Dictionary<string, string> options = new[] { LightOptions.Ephemeris.Key, LightOptions.Aberration.Key }
            .Where(query.ContainsKey).ToDictionary(key => key, key => Text(query, key));
        JsonElement json = JsonSerializer.SerializeToElement(options, AnswerTypes.Default.DictionaryStringString);
        return frames.Read(json, needsPlace: false).Settings;
    }

    private static Vector3D PlaceOf(IQueryCollection query) => PlaceText.Place(
        PlaceText.ParseDegrees(Text(query, "latitude"), "'latitude'"),
        PlaceText.ParseDegrees(Text(query, "longitude"), "'longitude'"),
        (0.0, false)).ToPositionBodyFixed(_ => MoonConstants.ReferenceRadius);

    private static string Text(IQueryCollection query, string name) => query[name] is [{ Length: > 0 } text]
        ? text
        : throw new UsageException($"'{name}' is needed once, with a value.");

    private static double Number(IQueryCollection query, string name) =>
        query[name] is [{ } text] && double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double number)
            && double.IsFinite(number)
            ? number
            : throw new UsageException($"'{name}' is needed once, as a number: 'from' and 'to' are MJD, 'count' is how many times.");
}

/// <summary>The Sun at a time, and in the sky of a place, if one was asked for.</summary>
/// <param name="Direction">Length 1, BODY_FIXED.</param>
/// <param name="Distance">m, from the Moon's centre.</param>
/// <param name="Elevation">Degrees above the horizontal.</param>
/// <param name="Azimuth">Degrees from north by east.</param>
internal sealed record SunAnswer(
    string Utc, double Mjd, PointAnswer SubSolarPoint, double[] Direction, double Distance, double? Elevation, double? Azimuth);

/// <summary>A place, degrees.</summary>
internal sealed record PointAnswer(double Latitude, double Longitude);

/// <summary>The Sun at evenly spaced times.</summary>
/// <param name="From">MJD of the first.</param>
/// <param name="Step">Days.</param>
/// <param name="Positions">m, BODY_FIXED.</param>
internal sealed record SunPathAnswer(double From, double Step, IEnumerable<double[]> Positions);
