using Msisf.Core.Terrain;

namespace Msisf.App.Settings;

/// <summary>Which synthetic elevation model is made.</summary>
/// <param name="PixelsPerDegree">Its resolution.</param>
/// <param name="Seed">Decides the terrain.</param>
/// <param name="BaseModel">Label or image of the model that it continues to smaller scales; null for an invented Moon.</param>
/// <param name="Region">Part of the Moon.</param>
/// <param name="Folder">Folder of the model.</param>
/// <param name="Unattended">Draw no progress bar.</param>
internal sealed record SynthesisSettings(
    int PixelsPerDegree, ulong Seed, string? BaseModel, MoonRegion Region, string Folder, bool Unattended);
