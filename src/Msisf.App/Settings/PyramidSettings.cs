namespace Msisf.App.Settings;

/// <summary>Selects the elevation model whose coarser levels are made or checked.</summary>
/// <param name="Model">Label, image or folder of the model; null for the default folders.</param>
/// <param name="PixelsPerDegree">
/// Resolution of the model, px/deg, needed for a folder; null if <paramref name="Model"/> determines it.
/// </param>
/// <param name="Unattended">Whether to draw no progress bar.</param>
internal sealed record PyramidSettings(string? Model, int? PixelsPerDegree, bool Unattended);
