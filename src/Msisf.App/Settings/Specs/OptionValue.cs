namespace Msisf.App.Settings.Specs;

/// <summary>The text of one option.</summary>
/// <param name="Words">
/// As they would stand on the command line; none for a flag, which in a configuration file is "true" or "false".
/// </param>
/// <param name="Place">Where in a configuration file it stands, e.g. "a.yaml, line 3"; null for the command line.</param>
internal sealed record OptionValue(IReadOnlyList<string> Words, string? Place = null);
