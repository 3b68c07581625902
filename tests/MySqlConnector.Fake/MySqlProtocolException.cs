namespace MySqlConnector;

/// <summary>What the package throws when an answer is none of the protocol.</summary>
public sealed class MySqlProtocolException() : InvalidOperationException("Packet received out-of-order. Expected 0; got 72.");
