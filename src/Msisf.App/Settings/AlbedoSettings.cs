using Msisf.Adapters.Raster.Albedo;
using Msisf.Core.Render.Photometry;

namespace Msisf.App.Settings;

/// <summary>The checked options of the map of the Moon's reflectance.</summary>
/// <param name="MapPath">The map; null for none, or for the installed one.</param>
/// <param name="IsGiven">Whether the user names a map, or none; if not, an installed map may be used.</param>
/// <param name="Properties">Properties of the map that the user gives.</param>
/// <param name="Sha256">SHA-256 that the map must have; null for any.</param>
/// <param name="Band">Band of the law moon, of the map and of the radiance.</param>
internal sealed record AlbedoSettings(
    string? MapPath, bool IsGiven, MapProperties Properties, string? Sha256, SpectralBand Band);
