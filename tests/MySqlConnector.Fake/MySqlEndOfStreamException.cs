namespace MySqlConnector;

/// <summary>What the package throws when the server closes the connection within an answer.</summary>
public sealed class MySqlEndOfStreamException()
    : EndOfStreamException("An incomplete response was received from the server");
