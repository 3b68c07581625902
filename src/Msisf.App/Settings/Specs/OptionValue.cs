namespace Msisf.App.Settings.Specs;

/// <summary>The value of one option as text.</summary>
/// <param name="Words">
/// Words of the value as on the command line; empty for a flag, which is "true" or "false" in a configuration file.
/// </param>
/// <param name="Place">Position in a configuration file, e.g. "a.yaml, line 3"; null for the command line.</param>
internal sealed record OptionValue(IReadOnlyList<string> Words, string? Place = null);
