using Msisf.Core.Terrain;

namespace Msisf.Core.Surface.Sources;

/// <summary>Finds the cells of a mesh that a cap of directions may touch.</summary>
internal static class CapWindow
{
    /// <summary>rad: no map reaches that far from its pole (70.6 degrees by <see cref="PolarStereographic.MaxExtent"/>).</summary>
    private const double FarthestFromPole = 1.3;

    /// <summary>
    /// Rectangles of cells that together hold all cells that a cap touches, and one more around; they may reach beyond the mesh.
    /// </summary>
    /// <param name="margin">rad, by which the cap is widened; at least 0.</param>
    public static CellRange[] Of(FacetMesh mesh, SphericalCap cap, double margin)
    {
        double angle = Math.Atan2(cap.SinRadius, cap.CosRadius) + margin;
        return mesh.Grid.Projection is PolarStereographic polar ? OfPlane(polar, cap.Centre, angle) : OfCylinder(mesh, cap.Centre, angle);
    }

    /// <summary>Circles around a direction are circles of the plane; its diameter lies on the line through the map's pole.</summary>
    private static CellRange[] OfPlane(PolarStereographic projection, Vector3D centre, double angle)
    {
        centre = projection.ToMap(centre);
        double fromPole = Vector3D.AngleBetween(new Vector3D(0.0, 0.0, projection.PoleSign), centre);
        if (fromPole - angle > FarthestFromPole)
        {
            return [];
        }

        if (fromPole + angle > 0.9 * Math.PI)
        {
            return [new CellRange(int.MinValue / 4, int.MaxValue / 4, int.MinValue / 4, int.MaxValue / 4)];
        }

        double near = 2.0 * Math.Tan(0.5 * (fromPole - angle));
        double far = 2.0 * Math.Tan(0.5 * (fromPole + angle));
        double perLength = 1.0 / Math.Max(double.Hypot(centre.X, centre.Y), double.Epsilon);
        double a = 0.5 * (near + far) * (centre.Y * perLength);
        double b = 0.5 * (near + far) * (centre.X * perLength);
        double pixels = MoonConstants.ReferenceRadius / projection.MetresPerPixel;
        double radius = 0.5 * (far - near) * pixels;
        double line = projection.LineOffset + (projection.PoleSign * b * pixels);
        double sample = projection.SampleOffset + (a * pixels);
        return [Around(line - radius, line + radius, sample - radius, sample + radius)];
    }

    private static CellRange[] OfCylinder(FacetMesh mesh, Vector3D centre, double angle)
    {
        SelenographicPoint point = SelenographicPoint.Below(centre);
        double perRadian = mesh.Samples / (2.0 * Math.PI);
        double line = (((0.5 * Math.PI) - point.Latitude) * perRadian) - 0.5;
        double lines = angle * perRadian;
        double sine = Math.Sin(Math.Min(angle, 0.5 * Math.PI)) / Math.Max(Math.Cos(point.Latitude), double.Epsilon);
        if (sine >= 1.0 || Math.Abs(point.Latitude) + angle >= 0.5 * Math.PI)
        {
            return [Around(line - lines, line + lines, 0.0, Math.Max(mesh.Samples, mesh.Cells.EndSample))];
        }

        double sample = (point.Longitude * perRadian) - 0.5;
        double samples = Math.Atan2(sine, Math.Sqrt(1.0 - (sine * sine))) * perRadian;
        CellRange range = Around(line - lines, line + lines, sample - samples, sample + samples);
        return
        [
            range, // what reaches over the prime meridian comes again on the other side
            range with { FirstSample = range.FirstSample - mesh.Samples, EndSample = range.EndSample - mesh.Samples },
            range with { FirstSample = range.FirstSample + mesh.Samples, EndSample = range.EndSample + mesh.Samples },
        ];
    }

    private static CellRange Around(double firstLine, double lastLine, double firstSample, double lastSample) => new(
        (int)Math.Floor(firstLine) - 1, (int)Math.Floor(lastLine) + 2, (int)Math.Floor(firstSample) - 1, (int)Math.Floor(lastSample) + 2);
}
