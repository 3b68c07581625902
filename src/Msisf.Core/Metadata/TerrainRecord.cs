using Msisf.Core.Render;
using Msisf.Core.Surface;
using Msisf.Core.Tiles;

namespace Msisf.Core.Metadata;

/// <summary>The terrain point that a pixel shows.</summary>
/// <param name="Height">m over the reference radius.</param>
/// <param name="PositionBodyFixed">m, body-fixed.</param>
/// <param name="Range">m from the camera.</param>
/// <param name="NormalBodyFixed">Outward normal that shades the point, body-fixed, length 1.</param>
/// <param name="Angles">Incidence and emission from this normal, phase.</param>
/// <param name="Light">How the point is lit.</param>
/// <param name="Tile">The tile that holds the facet; null on a map that has no tiles.</param>
/// <param name="Facet">The facet on which the point lies.</param>
public readonly record struct TerrainRecord(
    double Height,
    Vector3D PositionBodyFixed,
    double Range,
    Vector3D NormalBodyFixed,
    PhotometricAngles Angles,
    PixelIllumination Light,
    TileId? Tile,
    FacetId Facet)
{
    /// <summary>Whether the terrain has several models, and the facet's part says which.</summary>
    public bool NamesPart { get; init; }
}

/// <summary>The three angles of photometry at a point of the surface; <c>default</c> is light and camera on the normal.</summary>
/// <param name="Incidence">rad, [0, pi]: from the normal to the light; above pi/2 the surface turns away from it.</param>
/// <param name="Emission">rad, [0, pi]: from the normal to the camera.</param>
/// <param name="Phase">rad, [0, pi]: from the light to the camera.</param>
public readonly record struct PhotometricAngles(double Incidence, double Emission, double Phase)
{
    /// <summary>The angles at a point.</summary>
    /// <param name="pointBodyFixed">The point of the surface, m.</param>
    /// <param name="normalBodyFixed">Its outward normal, any length but zero.</param>
    /// <param name="cameraBodyFixed">Where it is seen from, m; not the point itself.</param>
    /// <param name="lightBodyFixed">The Sun, or the lamp that stands for it, m; not the point itself.</param>
    /// <returns>Phase is 0 to the last bit if the light is at the camera.</returns>
    public static PhotometricAngles At(Vector3D pointBodyFixed, Vector3D normalBodyFixed, Vector3D cameraBodyFixed, Vector3D lightBodyFixed)
    {
        Vector3D toCamera = cameraBodyFixed - pointBodyFixed;
        Vector3D toLight = lightBodyFixed - pointBodyFixed;
        return new PhotometricAngles(
            Vector3D.AngleBetween(toLight, normalBodyFixed),
            Vector3D.AngleBetween(toCamera, normalBodyFixed),
            Vector3D.AngleBetween(toLight, toCamera));
    }
}
