namespace Msisf.Core.Scene;

/// <summary>The map that colours the surface of a scene.</summary>
/// <param name="ImageName">File name of the map's image, linear grey, the whole Moon with north up, in the folder of the patterns.</param>
/// <param name="WestDegrees">East longitude of the image's left edge.</param>
/// <param name="Diffuse">Radiance factor of white with the Sun in the zenith.</param>
public sealed record SceneAlbedo(string ImageName, double WestDegrees, double Diffuse);
