using System.Net.WebSockets;

namespace Msisf.Server;

/// <summary>A message of a client.</summary>
/// <param name="Type">Binary for a state, text for JSON.</param>
/// <param name="Bytes">Its content.</param>
/// <param name="Order">Which one of the stream's messages it is; 0 for the first.</param>
internal sealed record StreamMessage(WebSocketMessageType Type, byte[] Bytes, uint Order);
