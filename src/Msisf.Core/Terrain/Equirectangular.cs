namespace Msisf.Core.Terrain;

/// <summary>
/// The simple cylindrical projection of the whole Moon, pixel registered: line i lies at latitude 90 - (i + 0.5) / res degrees, sample j at
/// longitude (j + 0.5) / res degrees.
/// </summary>
/// <param name="PixelsPerDegree">Samples a degree.</param>
public sealed record Equirectangular(int PixelsPerDegree) : MapProjection
{
    /// <inheritdoc/>
    public override GridResolution Resolution => PixelsPerDegree;

    /// <inheritdoc/>
    public override MapProjection? Halved() => PixelsPerDegree % 2 == 0 ? new Equirectangular(PixelsPerDegree / 2) : null;

    /// <inheritdoc/>
    public override Vector3D DirectionOf(double line, double sample) => new SelenographicPoint(
        double.DegreesToRadians(90.0 - ((line + 0.5) / PixelsPerDegree)),
        double.DegreesToRadians((sample + 0.5) / PixelsPerDegree)).ToDirectionBodyFixed();

    /// <inheritdoc/>
    public override (double Line, double Sample) PixelOf(Vector3D directionBodyFixed)
    {
        SelenographicPoint point = SelenographicPoint.Below(directionBodyFixed);
        return (
            ((90.0 - double.RadiansToDegrees(point.Latitude)) * PixelsPerDegree) - 0.5,
            (double.RadiansToDegrees(point.Longitude) * PixelsPerDegree) - 0.5);
    }
}
