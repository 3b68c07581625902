namespace Msisf.Core.Camera;

/// <summary>A half line: origin + t direction, t >= 0.</summary>
/// <param name="Origin">m, body-fixed.</param>
/// <param name="Direction">MOON_ME, any length but zero.</param>
public readonly record struct Ray(Vector3D Origin, Vector3D Direction);

/// <summary>
/// A point of the image plane in rendering coordinates (thesis eq. 8.13): whole numbers are pixel centres, from 1; any value outside the
/// image is allowed.
/// </summary>
/// <param name="X">px, to the right.</param>
/// <param name="Y">px, down.</param>
public readonly record struct RenderingPoint(double X, double Y);
