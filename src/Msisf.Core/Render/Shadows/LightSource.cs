using Msisf.Core.Numerics;

namespace Msisf.Core.Render.Shadows;

/// <summary>The Sun as the shadows see it.</summary>
/// <param name="PositionMoonMe">Its centre, m, MOON_ME.</param>
/// <param name="Slope">Radius over distance from the Moon's centre, of the disc that shines; 0 for a point.</param>
internal readonly record struct LightSource(Vector3D PositionMoonMe, double Slope);
