using System.Net.WebSockets;

namespace Msisf.Server;

/// <summary>A message of a client.</summary>
/// <param name="Type">Binary for a state, text for JSON.</param>
/// <param name="Bytes">Its content.</param>
internal sealed record StreamMessage(WebSocketMessageType Type, byte[] Bytes);
