using Msisf.Adapters.Tiles;

namespace Msisf.App.Settings;

/// <summary>Which patterns of a whole model are made, and of which samples.</summary>
/// <param name="PixelsPerDegree">Resolution of the model.</param>
/// <param name="Ldem">The model's file or folder; null for the default folders or the database.</param>
/// <param name="IsDatabase">Take the samples from the database.</param>
/// <param name="DefaultsFile">Option file with the connection to the database; null for the environment alone.</param>
/// <param name="PatternRepository">Folder of the patterns.</param>
/// <param name="Patterns">Their form.</param>
/// <param name="Unattended">Draw no progress bar.</param>
internal sealed record WholeMoonSettings(
    int PixelsPerDegree, string? Ldem, bool IsDatabase, string? DefaultsFile, string PatternRepository, PatternOptions Patterns,
    bool Unattended);
