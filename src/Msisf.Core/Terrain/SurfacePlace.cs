namespace Msisf.Core.Terrain;

/// <summary>A place by latitude, longitude and height, as a user gives it; <c>default</c> is the origin of both on the sphere.</summary>
public readonly record struct SurfacePlace
{
    /// <summary>Checks the numbers.</summary>
    /// <param name="latitudeDegrees">degrees, [-90, 90].</param>
    /// <param name="longitudeDegrees">degrees, east, [-360, 360].</param>
    /// <param name="height">m, over the reference radius, or over the terrain.</param>
    /// <param name="isOverTerrain">Whether the height counts from the terrain.</param>
    /// <exception cref="Errors.BadInputException">A number is not finite or out of its range.</exception>
    public SurfacePlace(double latitudeDegrees, double longitudeDegrees, double height, bool isOverTerrain)
    {
        LatitudeDegrees = Guard.InRange(latitudeDegrees, -90.0, 90.0, "The latitude (degrees)");
        LongitudeDegrees = Guard.InRange(longitudeDegrees, -360.0, 360.0, "The longitude (degrees east)");
        Height = Guard.Finite(height, "The height (m)");
        IsOverTerrain = isOverTerrain;
    }

    /// <summary>degrees.</summary>
    public double LatitudeDegrees { get; }

    /// <summary>degrees, east.</summary>
    public double LongitudeDegrees { get; }

    /// <summary>m, over the reference radius, or over the terrain.</summary>
    public double Height { get; }

    /// <summary>Whether <see cref="Height"/> counts from the terrain and not from the reference radius.</summary>
    public bool IsOverTerrain { get; }

    /// <summary>Position in m, body-fixed.</summary>
    /// <param name="groundRadius">
    /// Distance from the Moon's centre to the terrain in a direction, m; asked only if the height counts from the terrain.
    /// </param>
    /// <param name="referenceRadius">m: radius of the sphere over which other heights count.</param>
    public Vector3D ToPositionBodyFixed(Func<Vector3D, double> groundRadius, double referenceRadius = MoonConstants.ReferenceRadius)
    {
        Vector3D direction = new SelenographicPoint(
            double.DegreesToRadians(LatitudeDegrees), double.DegreesToRadians(LongitudeDegrees)).ToDirectionBodyFixed();
        return ((IsOverTerrain ? groundRadius(direction) : referenceRadius) + Height) * direction;
    }
}
