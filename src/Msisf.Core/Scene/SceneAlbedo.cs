namespace Msisf.Core.Scene;

/// <summary>The map that colours the surface of a scene.</summary>
/// <param name="ImageName">
/// File name of the map's image in the folder of the patterns: linear grey, north up, the whole Moon and a row more over each pole.
/// </param>
/// <param name="WestDegrees">East longitude of the image's left edge.</param>
/// <param name="Rows">Rows of the map in the image, between one row over each pole.</param>
/// <param name="Diffuse">Radiance factor of white with the Sun in the zenith.</param>
public sealed record SceneAlbedo(string ImageName, double WestDegrees, int Rows, double Diffuse);
