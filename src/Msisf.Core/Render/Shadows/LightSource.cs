using Msisf.Core.Numerics;

namespace Msisf.Core.Render.Shadows;

/// <summary>The Sun as a light source that casts shadows.</summary>
/// <param name="PositionMoonMe">The Sun's centre, m, MOON_ME.</param>
/// <param name="Slope">Radius of the Sun's disc over its distance from the Moon's centre; 0 for a point source.</param>
internal readonly record struct LightSource(Vector3D PositionMoonMe, double Slope);
