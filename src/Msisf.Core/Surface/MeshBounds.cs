using Msisf.Core.Terrain;

namespace Msisf.Core.Surface;

/// <summary>Directions of the facets of a block of cells of latitude and longitude as seen from the Moon's centre.</summary>
internal static class MeshBounds
{
    /// <summary>
    /// Ratio of a facet's minimum radius to its minimum vertex radius, at least. It is the cosine of the angle from a facet's middle to its
    /// vertices, which is at most half the diagonal of a cell (1 percent added).
    /// </summary>
    public static double SagittaFactor(int pixelsPerDegree) => Math.Cos(1.01 * Math.Sqrt(0.5) * Math.PI / 180.0 / pixelsPerDegree);

    /// <summary>The same for cells whose sides are seen at an angle of at most so many rad.</summary>
    public static double SagittaOf(double cellAngle) => Math.Cos(1.01 * Math.Sqrt(0.5) * cellAngle);

    /// <summary>Latitude of the block's middle, rad.</summary>
    public static double CentreLatitude(CellRange cells, int lines) =>
        0.5 * (FacetMesh.Latitude(cells.FirstLine, lines) + FacetMesh.Latitude(cells.EndLine, lines));

    /// <summary>Longitude of the block's middle, rad, not wrapped to one turn.</summary>
    public static double CentreLongitude(CellRange cells, int samples) =>
        FacetMesh.Longitude(0.5 * (cells.FirstSample + cells.EndSample), samples);

    /// <summary>The cap around the block's middle that contains all its facets.</summary>
    /// <remarks>
    /// A facet seen from the centre is a spherical triangle, which lies in each cap below a hemisphere that holds its corners. The
    /// vertex of a latitude-longitude block farthest from the middle is one of its four corners: the distance grows with the
    /// difference in longitude, and along a meridian its cosine A sin + B cos with B >= 0 has one maximum and no inner minimum.
    /// </remarks>
    public static SphericalCap CapOf(CellRange cells, int lines, int samples)
    {
        double latitude = CentreLatitude(cells, lines);
        double longitude = CentreLongitude(cells, samples);
        double halfWidth = Math.Min(Math.PI, longitude - FacetMesh.Longitude(cells.FirstSample, samples));
        double radius = Tolerances.CapRadius + Math.Max(
            Distance(latitude, FacetMesh.Latitude(cells.FirstLine, lines), halfWidth),
            Distance(latitude, FacetMesh.Latitude(cells.EndLine, lines), halfWidth));
        (double sinRadius, double cosRadius) = Math.SinCos(radius);
        return new SphericalCap(new SelenographicPoint(latitude, longitude).ToDirectionBodyFixed(), cosRadius, sinRadius);
    }

    /// <summary>Radius (rad) of a cap around the block's middle that lies entirely within the block's facets.</summary>
    public static double InnerRadius(CellRange cells, int lines, int samples)
    {
        double north = FacetMesh.Latitude(cells.FirstLine, lines);
        double south = FacetMesh.Latitude(cells.EndLine, lines);
        double halfWidth = Math.Min(0.5 * Math.PI, (cells.EndSample - cells.FirstSample) * Math.PI / samples);
        double toSide = Math.Cos(CentreLatitude(cells, lines)) * Math.Sin(halfWidth); // sine of the distance, so less than it

        // The straight edges along a parallel bulge towards the pole by a part of the cell that is far below a tenth of the block.
        return 0.9 * Math.Min(0.5 * (north - south), toSide);
    }

    private static double Distance(double latitude, double otherLatitude, double longitudeDifference)
    {
        double alongMeridian = Math.Sin(0.5 * (latitude - otherLatitude));
        double alongParallel = Math.Sin(0.5 * longitudeDifference);
        double chord = (alongMeridian * alongMeridian)
            + (Math.Cos(latitude) * Math.Cos(otherLatitude) * alongParallel * alongParallel);
        return 2.0 * Math.Atan2(Math.Sqrt(chord), Math.Sqrt(Math.Max(0.0, 1.0 - chord)));
    }
}

/// <summary>Tells from the slope of a part's steepest facet whether its ground faces a viewpoint.</summary>
internal static class GroundFacing
{
    /// <summary>Whether all facets of a part certainly face away from a viewpoint.</summary>
    /// <param name="nearest">Minimum angle at the Moon's centre between the viewpoint and a point of the part.</param>
    /// <param name="distance">m: the viewpoint's distance from the Moon's centre.</param>
    /// <param name="minRadius">m: minimum radius of the facets.</param>
    /// <param name="maxSlope">Tangent of the maximum slope of the facets.</param>
    /// <remarks>
    /// The viewpoint is D cos(theta) - r over a point's level at a distance D sin(theta) to the side. cos(theta) + maxSlope sin(theta)
    /// falls from where its slope is the steepest one.
    /// </remarks>
    public static bool IsTurnedAway(SineCosine nearest, double distance, double minRadius, double maxSlope) =>
        nearest.Sine > 0.0
        && nearest.Sine > maxSlope * nearest.Cosine
        && nearest.Cosine + (maxSlope * nearest.Sine) < minRadius / distance;
}
