namespace Msisf.Adapters.Input;

/// <summary>One key of a configuration file with its value or values, as text.</summary>
/// <param name="Key">As it is written.</param>
/// <param name="Values">
/// The value, or the values of a list; at least one, each a line without control characters. None if it has <paramref name="Entries"/>.
/// </param>
/// <param name="IsList">Whether it is written as a list.</param>
/// <param name="Line">Line of the key, from 1.</param>
/// <param name="Column">Column of the key, from 1.</param>
/// <param name="Entries">The keys below this one; null if it has values.</param>
public sealed record ConfigEntry(
    string Key, IReadOnlyList<string> Values, bool IsList, int Line, int Column, IReadOnlyList<ConfigEntry>? Entries = null);
