using Msisf.Core.Terrain;

namespace Msisf.Core.Preview;

/// <summary>The ground in the middle of an image, on a sphere.</summary>
/// <param name="Point">Where the viewing direction meets the sphere.</param>
/// <param name="Sun">Where the Sun stands there; null if a lamp lights the scene.</param>
/// <param name="MetresPerPixel">Width that a pixel covers there, m, across the line of sight.</param>
public readonly record struct BoresightView(SelenographicPoint Point, SkyDirection? Sun, double MetresPerPixel);
