using System.Text.Json;
using Msisf.App.Serving;

namespace Msisf.Server;

/// <summary>POST /v1/points: where places of the Moon are seen in an image.</summary>
/// <param name="frames">Does the work.</param>
internal sealed class PointsEndpoint(FrameService frames)
{
    /// <summary>Describes the route.</summary>
    public static RouteText About { get; } = new("Says where places of the Moon are seen in an image.", AnswerForm.Json)
    {
        Body = ApiSchemas.OfPoints(
            "points",
            "[latitude, longitude] or [latitude, longitude, height]: degrees, m over the sphere of 1737400 m",
            least: 2,
            most: 3),
        Answer = ApiSchemas.OfList("pixels", ApiSchemas.ImagePoint, isNullable: false),
    };

    /// <summary>Answers a request.</summary>
    public async Task AnswerAsync(HttpContext context)
    {
        using JsonDocument json = await JsonBody.ReadAsync(context.Request).ConfigureAwait(false);
        frames.CollectWarnings();
        PointsRequest request = PointsRequest.Read(json.RootElement, "points", ["latitude", "longitude", "height"], needed: 2, frames);
        PixelReading[] pixels = await frames.RunAsync(
            request.Frame,
            (session, _, end) =>
            {
                FrameTruth truth = session.TruthOf(session.Prepare(request.Frame.Place!, end));
                return request.Points.Select(point =>
                {
                    end.ThrowIfCancellationRequested();
                    return truth.Of(point[0], point[1], point.Length > 2 ? point[2] : null);
                }).ToArray();
            },
            context.RequestAborted).ConfigureAwait(false);
        await JsonBody.SendAsync(context.Response, new { Pixels = pixels }).ConfigureAwait(false);
    }
}
