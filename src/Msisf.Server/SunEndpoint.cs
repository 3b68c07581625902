using System.Text.Json;
using Msisf.Adapters.Input;
using Msisf.App.Settings;
using Msisf.Core.Preview;
using Msisf.Core.Terrain;
using Msisf.Core.Time;

namespace Msisf.Server;

/// <summary>GET /v1/sun: where the Sun is at a time, and where it stands in the sky of a place.</summary>
/// <param name="frames">Knows the ephemeris.</param>
internal sealed class SunEndpoint(FrameService frames)
{
    private static readonly string[] Names = ["utc", "mjd", "latitude", "longitude", "ephemeris", "aberration"];

    public static RouteText About { get; } = new(
        "Says where the Sun is at a time, and where it stands in the sky of a place.", AnswerForm.Json)
    { Query = Names };

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

        ModifiedJulianDate time = TimeText.Parse(Text(query, query.ContainsKey("utc") ? "utc" : "mjd"));
        RenderSettings settings = SettingsOf(query);
        Vector3D sun = frames.Sessions.Ephemeris.Of(settings).Engine().SunPositionBodyFixed(time, settings.Aberration);
        SelenographicPoint below = SelenographicPoint.Below(sun);
        Vector3D direction = sun.Normalized();
        SkyDirection? sky = query.ContainsKey("latitude") ? SkyDirection.Of(PlaceOf(query), sun) : null;
        return JsonBody.SendAsync(context.Response, new
        {
            Utc = time.ToIsoUtc(),
            Mjd = time.Days,
            SubSolarPoint = new
            {
                Latitude = double.RadiansToDegrees(below.Latitude),
                Longitude = double.RadiansToDegrees(below.Longitude),
            },
            Direction = (double[])[direction.X, direction.Y, direction.Z],
            Distance = sun.Length,
            Elevation = sky is { } above ? double.RadiansToDegrees(above.Elevation) : (double?)null,
            Azimuth = sky?.Azimuth is { } azimuth ? double.RadiansToDegrees(azimuth) : (double?)null,
        });
    }

    /// <summary>The options of the ephemeris, read as those of a frame.</summary>
    private RenderSettings SettingsOf(IQueryCollection query)
    {
        Dictionary<string, string> options = new[] { LightOptions.Ephemeris.Key, LightOptions.Aberration.Key }
            .Where(query.ContainsKey).ToDictionary(key => key, key => Text(query, key));
        using JsonDocument json = JsonSerializer.SerializeToDocument(options);
        return frames.Read(json.RootElement, needsPlace: false).Settings;
    }

    private static Vector3D PlaceOf(IQueryCollection query) => PlaceText.Place(
        PlaceText.ParseDegrees(Text(query, "latitude"), "'latitude'"),
        PlaceText.ParseDegrees(Text(query, "longitude"), "'longitude'"),
        (0.0, false)).ToPositionBodyFixed(_ => MoonConstants.ReferenceRadius);

    private static string Text(IQueryCollection query, string name) => query[name] is [{ Length: > 0 } text]
        ? text
        : throw new UsageException($"'{name}' is needed once, with a value.");
}
