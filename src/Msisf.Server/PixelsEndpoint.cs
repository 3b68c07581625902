using System.Text.Json;
using Microsoft.AspNetCore.Http;
using Msisf.App.Rendering;
using Msisf.App.Serving;
using Msisf.Core.Camera;
using Msisf.Core.Render;
using Msisf.Core.Tracing;

namespace Msisf.Server;

/// <summary>POST /v1/pixels: what points of an image show.</summary>
/// <param name="frames">Does the work.</param>
internal sealed class PixelsEndpoint(FrameService frames)
{
    /// <summary>Answers a request.</summary>
    public async Task AnswerAsync(HttpContext context)
    {
        using JsonDocument json = await JsonBody.ReadAsync(context.Request).ConfigureAwait(false);
        frames.CollectWarnings();
        PointsRequest request = PointsRequest.Read(json.RootElement, "pixels", ["x", "y"], needed: 2, frames);
        RequestedFrame frame = request.Frame.IsTraceable ? request.Frame : request.Frame.WithTruth();
        SurfaceReading?[] points = await frames.RunAsync(
            frame,
            (session, threads, end) => frame.IsTraceable
                ? Traced(session, session.Prepare(frame.Place!, end), request.Points, end)
                : Drawn(session, session.Prepare(frame.Place!, end), request.Points, threads, end),
            context.RequestAborted).ConfigureAwait(false);
        await JsonBody.SendAsync(context.Response, new { Points = points }).ConfigureAwait(false);
    }

    private static SurfaceReading?[] Traced(
        RenderSession session, PreparedFrame frame, IReadOnlyList<double[]> pixels, CancellationToken cancellation)
    {
        FrameTruth truth = session.TruthOf(frame);
        return [.. pixels.Select(pixel =>
        {
            cancellation.ThrowIfCancellationRequested();
            return truth.At(pixel[0], pixel[1]);
        })];
    }

    /// <summary>Penumbras and smooth normals are known at the middle of each pixel.</summary>
    private static SurfaceReading?[] Drawn(
        RenderSession session, PreparedFrame frame, IReadOnlyList<double[]> pixels, int threads, CancellationToken cancellation)
    {
        using NativeImage image = session.Draw(frame, threads, cancellation);
        IGroundTruth truth = image.ToRendered(Stream.Null).Truth!;
        return [.. pixels.Select(pixel =>
        {
            FrameTruth.RequireInside(truth.Camera, pixel[0], pixel[1]);
            int x = (int)Math.Round(pixel[0]);
            int y = (int)Math.Round(pixel[1]);
            Ray ray = truth.Camera.RayThrough(x, y);
            return truth.TryGet(x, y, out SurfaceHit hit, out PixelIllumination light)
                ? SurfaceReading.Of(truth.Camera, ray, hit, light, truth.LightPositionMoonMe)
                : null;
        })];
    }
}
