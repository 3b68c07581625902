using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Tests.Metadata;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Camera;

public class CameraMatrixTests
{
    /// <summary>m: the sphere of the reference pixels.</summary>
    private const double SphereRadius = 1_737_400.0;

    /// <summary>
    /// m: latitude and longitude as doubles are good to 3e-14 degrees, 1e-9 m; the coordinates of point and camera to 2e-10 m each.
    /// </summary>
    private const double PointError = 1e-8;

    /// <summary>Of a distance: some roundings each of R p, t and their sum.</summary>
    private const double DistanceError = 4e-15;

    /// <summary>px: the rounding of u and v themselves, up to 16384.</summary>
    private const double PixelError = 1e-11;

    /// <summary>
    /// Latitude and longitude of what a pixel shows were computed by tests/reference/illumination.py with 50 digits, from the thesis's
    /// equations; K, R and t must lead from there back to the pixel.
    /// </summary>
    [Fact]
    public void Of_ReferencePixels_ProjectsTheirPointsOntoThem()
    {
        ReferencePixel[] pixels =
            [.. ((string[])["moderate", "limb", "pole", "subsolar", "one_metre_above", "far"]).SelectMany(ReferencePixel.Read)];

        Assert.Equal(750, pixels.Length);
        Assert.All(pixels, pixel =>
        {
            CameraMatrix matrix = CameraMatrix.Of(pixel.Camera);
            Vector3D inCamera = (matrix.Rotation * OnSphere(pixel.LatitudeDegrees, pixel.LongitudeDegrees)) + matrix.Translation;
            double error = PixelError
                + (matrix.FocalLength * (PointError + (DistanceError * pixel.Camera.PositionBodyFixed.Length)) / inCamera.Z);

            Assert.InRange(Row(matrix.IntrinsicRows[0], inCamera) - (pixel.X - 1), -error, error);
            Assert.InRange(Row(matrix.IntrinsicRows[1], inCamera) - (pixel.Y - 1), -error, error);
            Assert.Equal(Vector3D.UnitZ, matrix.IntrinsicRows[2]);
        });
    }

    /// <summary>Thesis section 9.2 as printed: 1024 x 1024 px, 40 degrees, pixels (450, 100) and (500, 100), 13 decimals.</summary>
    [Theory]
    [InlineData(450, 44.58440049692400, 56.79090635326980)]
    [InlineData(500, 41.65137059729800, 58.68035440967800)]
    public void Of_PublishedExample_ProjectsThePrintedPoints(int h, double latitude, double longitude)
    {
        CameraMatrix matrix = CameraMatrix.Of(new PinholeCamera(
            new Vector3D(2e6, 2e6, 0.0),
            UnitQuaternion.FromComponents(
                -2.391176183943345e-001, +9.904576054128762e-002, +3.696438106143861e-001, +8.923991008325228e-001),
            double.DegreesToRadians(40.0),
            1024,
            1024));

        Vector3D inCamera = (matrix.Rotation * OnSphere(latitude, longitude)) + matrix.Translation;

        // 512 / tan(20 degrees) with 50 digits (mpmath 1.3.0): 1406.70843876076661.
        Assert.Equal(1406.7084387607666, matrix.FocalLength, 1e-11);
        Assert.Equal((1024, 1024, 511.5, 511.5), (matrix.Width, matrix.Height, matrix.PrincipalX, matrix.PrincipalY));
        Assert.InRange(Row(matrix.IntrinsicRows[0], inCamera) - (h - 1), -Rounding.OfPlaces, Rounding.OfPlaces);
        Assert.InRange(Row(matrix.IntrinsicRows[1], inCamera) - 99.0, -Rounding.OfPlaces, Rounding.OfPlaces);
    }

    [Fact]
    public void Of_ImageThatIsNotSquare_HasSquarePixelsAndItsOwnMiddle()
    {
        PinholeCamera camera = new(new Vector3D(0.0, 0.0, 3e6), UnitQuaternion.Identity, double.DegreesToRadians(90.0), 640, 201);

        CameraMatrix matrix = CameraMatrix.Of(camera);

        // By hand: 640 / (2 tan 45) = 320; looking along -x, y right, z up, so that down is -z and the Moon's centre 3000 km below.
        Assert.Equal(320.0, matrix.FocalLength, 1e-12);
        Assert.Equal((319.5, 100.0), (matrix.PrincipalX, matrix.PrincipalY));
        Assert.Equal([Vector3D.UnitY, -Vector3D.UnitZ, -Vector3D.UnitX], matrix.RotationRows);
        Assert.Equal(new Vector3D(0.0, 3e6, 0.0), matrix.Translation);
    }

    private static double Row(Vector3D row, Vector3D inCamera) => Vector3D.Dot(row, inCamera) / inCamera.Z;

    private static Vector3D OnSphere(double latitudeDegrees, double longitudeDegrees)
    {
        (double sinLatitude, double cosLatitude) = Math.SinCos(double.DegreesToRadians(latitudeDegrees));
        (double sinLongitude, double cosLongitude) = Math.SinCos(double.DegreesToRadians(longitudeDegrees));
        return SphereRadius * new Vector3D(cosLatitude * cosLongitude, cosLatitude * sinLongitude, sinLatitude);
    }
}
