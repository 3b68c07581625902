using Msisf.Core.Numerics;

namespace Msisf.Core.Camera;

/// <summary>A half line: origin + t direction, t >= 0.</summary>
/// <param name="Origin">m, MOON_ME.</param>
/// <param name="Direction">MOON_ME, any length but zero.</param>
public readonly record struct Ray(Vector3D Origin, Vector3D Direction);
