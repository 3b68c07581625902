using System.Text.Json;
using Msisf.App.Serving;

namespace Msisf.Server;

/// <summary>POST /v1/ground: the height of the ground at places, on the surface that a frame shows.</summary>
/// <param name="frames">Does the work.</param>
internal sealed class GroundEndpoint(FrameService frames)
{
    /// <summary>Describes the route.</summary>
    public static RouteText About { get; } = new("Says how high the ground is at places of the Moon.", AnswerForm.Json)
    {
        Body = ApiSchemas.OfPoints("points", "[latitude, longitude]: degrees", least: 2, most: 2),
    };

    /// <summary>Answers a request.</summary>
    public async Task AnswerAsync(HttpContext context)
    {
        using JsonDocument json = await JsonBody.ReadAsync(context.Request).ConfigureAwait(false);
        frames.CollectWarnings();
        PointsRequest request = PointsRequest.Read(json.RootElement, "points", ["latitude", "longitude"], needed: 2, frames);
        double[] heights = await frames.RunAsync(
            request.Frame,
            (session, _, end) =>
            {
                FrameTruth truth = session.TruthOf(session.Prepare(request.Frame.Place!, end));
                return request.Points.Select(point =>
                {
                    end.ThrowIfCancellationRequested();
                    return truth.HeightAt(point[0], point[1]);
                }).ToArray();
            },
            context.RequestAborted).ConfigureAwait(false);
        await JsonBody.SendAsync(context.Response, new { Heights = heights }).ConfigureAwait(false);
    }
}
