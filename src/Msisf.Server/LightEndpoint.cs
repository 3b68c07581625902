using System.Text.Json;
using Msisf.App.Illumination;
using Msisf.Core.Terrain;

namespace Msisf.Server;

/// <summary>POST /v1/light: the light of places over the month around a frame's time, hour by hour.</summary>
internal sealed class LightEndpoint(FrameService frames)
{
    /// <summary>Places of one request: each takes a horizon.</summary>
    private const int MostPlaces = 10;

    public static RouteText About { get; } = new("Says how places are lit over the month around a time.", AnswerForm.Json)
    {
        Body = ApiSchemas.OfPoints("points", "[latitude, longitude]: degrees; at most 10", least: 2, most: 2),
    };

    public async Task AnswerAsync(HttpContext context)
    {
        using JsonDocument json = await JsonBody.ReadAsync(context.Request).ConfigureAwait(false);
        frames.CollectWarnings();
        PointsRequest request = PointsRequest.Read(json.RootElement, "points", ["latitude", "longitude"], needed: 2, frames);
        if (request.Points.Count is 0 or > MostPlaces)
        {
            throw new UsageException($"'points' has {request.Points.Count} places; 1 to {MostPlaces} are answered.");
        }

        Vector3D[] directions = [.. request.Points.Select(
            point => new SurfacePlace(point[0], point[1], 0.0, isOverTerrain: false)
                .ToPositionBodyFixed(_ => MoonConstants.ReferenceRadius).Normalized())];
        MonthOfLight month = await frames.RunAsync(
            request.Frame,
            (session, threads, end) => MonthOfLight.Find(
                session.Model, directions, session.Prepare(request.Frame.Place!, end).State.Time, frames.SunAt, threads, end),
            context.RequestAborted,
            isLarge: true).ConfigureAwait(false);
        await JsonBody.SendAsync(context.Response, month).ConfigureAwait(false);
    }
}
