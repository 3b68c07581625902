using Msisf.Core.Camera;

namespace Msisf.Adapters.CameraExport;

/// <summary>
/// The rows of an image as one row that turns, which is what a line-scan camera has. Rows farther from the axis are longer in angle, so
/// that none fits all: the one is taken that is nearest to all others.
/// </summary>
/// <param name="Turns">Turn of each row of the image, from the axes of the one row to the image's (OpenCV's).</param>
/// <param name="Misfit">px: the largest distance of a pixel from that of the one row.</param>
internal sealed record RollingRow(CameraModel Line, IReadOnlyList<UnitQuaternion> Turns, double Misfit)
{
    /// <summary>Rows that are tried and compared, at equal intervals.</summary>
    private const int Compared = 33;

    /// <summary>Pixels of a row that are compared, at equal intervals.</summary>
    private const int Pixels = 17;

    /// <summary>Finds the row.</summary>
    public static RollingRow Of(CameraModel camera)
    {
        int count = Math.Min(Compared, camera.Height);
        int[] rows = [.. Enumerable.Range(0, count).Select(i => count == 1 ? 0 : i * (camera.Height - 1) / (count - 1))];
        (CameraModel line, double misfit) = rows
            .Select(row => LineOf(camera, row))
            .Select(line => (line, rows.Max(row => MisfitOf(camera, row + 1.0, line))))
            .MinBy(found => found.Item2);
        return new RollingRow(line, [.. Enumerable.Range(1, camera.Height).Select(y => TurnOf(camera, y, line))], misfit);
    }

    private static CameraModel LineOf(CameraModel camera, int row) => new(
        camera.Width, 1, (camera.FocalX, camera.FocalY), (camera.PrincipalX, camera.PrincipalY - row), camera.Skew, camera.Distortion);

    private static UnitQuaternion TurnOf(CameraModel camera, double y, CameraModel line) =>
        AxesOf(camera, y) * AxesOf(line, 1.0).Conjugate;

    /// <summary>px: how far the pixels of a row are from those of the one row, once that is turned.</summary>
    private static double MisfitOf(CameraModel camera, double y, CameraModel line)
    {
        UnitQuaternion turn = TurnOf(camera, y, line);
        double step = (camera.Width - 1) / (Pixels - 1.0);
        return Enumerable.Range(0, Pixels).Max(i =>
        {
            double x = 1.0 + (i * step);
            Vector3D direction = turn.Conjugate * DirectionOf(camera, x, y);
            return line.TryToImage(direction.X / direction.Z, direction.Y / direction.Z, out RenderingPoint point)
                ? double.Hypot(point.X - x, point.Y - 1.0)
                : double.PositiveInfinity;
        });
    }

    /// <summary>Turns axes along a row (x from its left end to its right one, z to their middle) into the camera's.</summary>
    private static UnitQuaternion AxesOf(CameraModel camera, double y)
    {
        (Vector3D left, Vector3D right) = (DirectionOf(camera, 0.5, y), DirectionOf(camera, camera.Width + 0.5, y));
        (Vector3D along, Vector3D middle) = ((right - left).Normalized(), (left + right).Normalized());
        return UnitQuaternion.FromMatrix(new RotationMatrix(along, Vector3D.Cross(middle, along), middle)).Conjugate;
    }

    private static Vector3D DirectionOf(CameraModel camera, double x, double y)
    {
        (double right, double down) = camera.ToIdeal(x, y);
        return new Vector3D(right, down, 1.0).Normalized();
    }
}
