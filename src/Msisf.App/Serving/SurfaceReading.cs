using System.Text.Json.Serialization;
using Msisf.Core.Camera;
using Msisf.Core.Metadata;
using Msisf.Core.Render;
using Msisf.Core.Terrain;
using Msisf.Core.Tracing;

namespace Msisf.App.Serving;

/// <summary>What a point of an image shows: degrees and m, body-fixed.</summary>
/// <param name="Latitude">Degrees.</param>
/// <param name="Longitude">Degrees, east.</param>
/// <param name="Height">m over the reference radius.</param>
/// <param name="Position">m.</param>
/// <param name="Distance">m from the camera.</param>
/// <param name="Incidence">Degrees from the normal to the light.</param>
/// <param name="Emission">Degrees from the normal to the camera.</param>
/// <param name="Phase">Degrees from the light to the camera.</param>
/// <param name="IlluminationDirection">Degrees counter-clockwise from straight down in the image; null where it is undefined.</param>
/// <param name="Lit">lit, penumbra, shadow or night.</param>
/// <param name="LitFraction">Part of the Sun that is seen from there, 0 to 1.</param>
/// <param name="PixelScale">m: width of a pixel across the line of sight.</param>
/// <param name="Slope">Degrees between the normal and the radius.</param>
internal sealed record SurfaceReading(
    double Latitude, double Longitude, double Height, double[] Position, double Distance, double Incidence, double Emission, double Phase,
    double? IlluminationDirection, string Lit, double LitFraction, double PixelScale, double Slope, FacetReading Facet)
{
    /// <summary>
    /// m, of a point in shadow: to the terrain that is before the light's centre; 0 where the slope itself faces away from it. Null
    /// elsewhere.
    /// </summary>
    public double? ShadedAt { get; init; }

    /// <param name="hit">Where the ray meets the surface.</param>
    /// <param name="light">How the point is lit.</param>
    /// <param name="lightBodyFixed">The Sun, or the lamp at the camera, m.</param>
    /// <param name="firstInventedPart">Facets of this part and of those after it are invented; null of frames without.</param>
    public static SurfaceReading Of(
        FrameCamera camera, Ray ray, SurfaceHit hit, PixelIllumination light, Vector3D lightBodyFixed, int? firstInventedPart)
    {
        Vector3D point = hit.PointBodyFixed;
        SelenographicPoint place = SelenographicPoint.Below(point);
        PhotometricAngles angles = PhotometricAngles.At(point, hit.NormalBodyFixed, camera.PositionBodyFixed, lightBodyFixed);
        double? direction = Core.Metadata.IlluminationDirection.At(camera, ray.Direction, point, lightBodyFixed);
        return new SurfaceReading(
            double.RadiansToDegrees(place.Latitude),
            double.RadiansToDegrees(place.Longitude),
            point.Length - MoonConstants.ReferenceRadius,
            [point.X, point.Y, point.Z],
            hit.RayParameter * ray.Direction.Length,
            double.RadiansToDegrees(angles.Incidence),
            double.RadiansToDegrees(angles.Emission),
            double.RadiansToDegrees(angles.Phase),
            direction is { } angle ? double.RadiansToDegrees(angle) : null,
            light.State.Word(),
            light.VisibleFraction,
            camera.PixelSide(ray, hit.RayParameter),
            double.RadiansToDegrees(Vector3D.AngleBetween(hit.NormalBodyFixed, point)),
            new FacetReading(
                hit.Facet.Line, hit.Facet.Sample, (int)hit.Facet.Half, hit.Facet.Part,
                firstInventedPart is { } first ? hit.Facet.Part >= first : null));
    }
}

/// <summary>A facet of the surface (docs/pattern-format.md).</summary>
/// <param name="Line">Line of its cell, 0 for the northernmost; -1 is the fan around the north pole.</param>
/// <param name="Sample">Sample of its cell, from 0.</param>
/// <param name="Half">Which of the two facets of the cell.</param>
/// <param name="Part">
/// The model, from 0 for the coarsest of several; their number stands for the seams between them. 0 of one.
/// </param>
/// <param name="Invented">Whether it is of invented detail; null, and left out, of frames without.</param>
internal sealed record FacetReading(
    int Line, int Sample, int Half, int Part,
    [property: JsonIgnore(Condition = JsonIgnoreCondition.WhenWritingNull)] bool? Invented = null);
