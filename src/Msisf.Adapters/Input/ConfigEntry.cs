namespace Msisf.Adapters.Input;

/// <summary>One key of a configuration file with its value or values, as text.</summary>
/// <param name="Key">As it is written.</param>
/// <param name="Values">The value, or the values of a list; at least one, each a line without control characters.</param>
/// <param name="IsList">Whether it is written as a list.</param>
/// <param name="Line">Line of the key, from 1.</param>
/// <param name="Column">Column of the key, from 1.</param>
public sealed record ConfigEntry(string Key, IReadOnlyList<string> Values, bool IsList, int Line, int Column);
