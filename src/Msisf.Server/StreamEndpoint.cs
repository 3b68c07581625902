using System.Net.WebSockets;

namespace Msisf.Server;

/// <summary>GET /v1/stream: a WebSocket on which states go in and images come out.</summary>
/// <param name="stopping">The server ends.</param>
internal sealed class StreamEndpoint(FrameService frames, CancellationToken stopping)
{
    public async Task AnswerAsync(HttpContext context)
    {
        if (!context.WebSockets.IsWebSocketRequest)
        {
            throw new RefusedException(StatusCodes.Status426UpgradeRequired, "/v1/stream is a WebSocket.");
        }

        using WebSocket socket = await context.WebSockets.AcceptWebSocketAsync().ConfigureAwait(false);
        frames.Metrics.StreamsChanged(1);
        try
        {
            using StreamSession session = new(frames, socket, context.RequestAborted, stopping);
            await session.RunAsync().ConfigureAwait(false);
        }
        finally
        {
            frames.Metrics.StreamsChanged(-1);
        }
    }
}
