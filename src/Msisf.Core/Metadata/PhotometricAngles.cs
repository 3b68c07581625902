using Msisf.Core.Numerics;

namespace Msisf.Core.Metadata;

/// <summary>The three angles of photometry at a point of the surface; <c>default</c> is light and camera on the normal.</summary>
/// <param name="Incidence">rad, [0, pi]: from the normal to the light; above pi/2 the surface turns away from it.</param>
/// <param name="Emission">rad, [0, pi]: from the normal to the camera.</param>
/// <param name="Phase">rad, [0, pi]: from the light to the camera.</param>
public readonly record struct PhotometricAngles(double Incidence, double Emission, double Phase)
{
    /// <summary>The angles at a point.</summary>
    /// <param name="pointMoonMe">The point of the surface, m.</param>
    /// <param name="normalMoonMe">Its outward normal, any length but zero.</param>
    /// <param name="cameraMoonMe">Where it is seen from, m; not the point itself.</param>
    /// <param name="lightMoonMe">The Sun, or the lamp that stands for it, m; not the point itself.</param>
    /// <returns>Phase is 0 to the last bit if the light is at the camera.</returns>
    public static PhotometricAngles At(Vector3D pointMoonMe, Vector3D normalMoonMe, Vector3D cameraMoonMe, Vector3D lightMoonMe)
    {
        Vector3D toCamera = cameraMoonMe - pointMoonMe;
        Vector3D toLight = lightMoonMe - pointMoonMe;
        return new PhotometricAngles(
            Vector3D.AngleBetween(toLight, normalMoonMe),
            Vector3D.AngleBetween(toCamera, normalMoonMe),
            Vector3D.AngleBetween(toLight, toCamera));
    }
}
