using Msisf.Core.Numerics;

namespace Msisf.Core.Surface;

/// <summary>All directions within an angle of a centre direction.</summary>
/// <param name="Centre">Unit vector, MOON_ME.</param>
/// <param name="CosRadius">Cosine of the angle.</param>
/// <param name="SinRadius">Sine of the angle, which is below pi.</param>
internal readonly record struct SphericalCap(Vector3D Centre, double CosRadius, double SinRadius);
