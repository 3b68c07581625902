using System.Text.Json;
using Msisf.App.Serving;

namespace Msisf.Server;

/// <summary>POST /v1/pixels: what points of an image show.</summary>
/// <param name="frames">Does the work.</param>
internal sealed class PixelsEndpoint(FrameService frames)
{
    /// <summary>Describes the route.</summary>
    public static RouteText About { get; } = new("Says what points of an image show.", AnswerForm.Json)
    {
        Body = ApiSchemas.OfPoints("pixels", "[x, y]: pixels from 1 for the middle of the first one, x right, y down", least: 2, most: 2),
        Answer = ApiSchemas.OfList("points", ApiSchemas.SurfacePoint, isNullable: true),
    };

    /// <summary>Answers a request.</summary>
    public async Task AnswerAsync(HttpContext context)
    {
        using JsonDocument json = await JsonBody.ReadAsync(context.Request).ConfigureAwait(false);
        frames.CollectWarnings();
        PointsRequest request = PointsRequest.Read(json.RootElement, "pixels", ["x", "y"], needed: 2, frames);
        RequestedFrame frame = request.Frame;
        SurfaceReading?[] points = await frames.RunAsync(
            frame,
            (session, threads, end) => Read(session, frame, request.Points, threads, end),
            context.RequestAborted,
            isLarge: !frame.IsTraceable && FrameService.IsLarge(frame.Settings)).ConfigureAwait(false);
        await JsonBody.SendAsync(context.Response, new { Points = points }).ConfigureAwait(false);
    }

    private static SurfaceReading?[] Read(
        RenderSession session, RequestedFrame frame, IReadOnlyList<double[]> pixels, int threads, CancellationToken cancellation)
    {
        PreparedFrame prepared = session.Prepare(frame.Place!, cancellation);
        FrameTruth truth = session.TruthOf(prepared);
        SurfaceReading?[] readings = frame.IsTraceable
            ? [.. pixels.Select(pixel =>
            {
                cancellation.ThrowIfCancellationRequested();
                return truth.At(pixel[0], pixel[1]);
            })]
            : session.ReadDrawn(prepared, pixels, threads, cancellation);
        return [.. readings.Zip(pixels, (reading, pixel) => reading is null ? null : truth.WithShade(reading, pixel[1]))];
    }
}
