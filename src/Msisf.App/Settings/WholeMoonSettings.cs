using Msisf.Adapters.Tiles;

namespace Msisf.App.Settings;

/// <summary>Selects the patterns of a whole model and the source of their samples.</summary>
/// <param name="PixelsPerDegree">Resolution of the model, px/deg.</param>
/// <param name="Ldem">The model's file or folder; null for the default folders or the database.</param>
/// <param name="IsDatabase">Whether to take the samples from the database.</param>
/// <param name="DefaultsFile">Option file with the connection to the database; null for the environment alone.</param>
/// <param name="PatternRepository">Folder of the patterns.</param>
/// <param name="Patterns">Format of the patterns.</param>
/// <param name="Unattended">Whether to draw no progress bar.</param>
internal sealed record WholeMoonSettings(
    int PixelsPerDegree, string? Ldem, bool IsDatabase, string? DefaultsFile, string PatternRepository, PatternOptions Patterns,
    bool Unattended);
