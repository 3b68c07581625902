namespace Msisf.App.Settings;

/// <summary>Which elevation model's coarser levels are made or checked.</summary>
/// <param name="Model">Its label, its image, or its folder; null for the default folders.</param>
/// <param name="PixelsPerDegree">Its resolution, which a folder needs; null if <paramref name="Model"/> says it.</param>
/// <param name="Unattended">Draw no progress bar.</param>
internal sealed record PyramidSettings(string? Model, int? PixelsPerDegree, bool Unattended);
