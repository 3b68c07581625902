using Msisf.Core.Camera;

namespace Msisf.Core.Navigation;

/// <summary>The space that a pinhole's image shows: four planes through the focal point and the image's borders.</summary>
internal readonly struct ImagePyramid
{
    private readonly Vector3D _apex;
    private readonly Vector3D[] _inward;

    /// <summary>The pyramid of a camera without a lens.</summary>
    public ImagePyramid(FrameCamera camera)
    {
        _apex = camera.PositionBodyFixed;
        Vector3D[] corners =
        [
            camera.RayThrough(0.5, 0.5).Direction, camera.RayThrough(camera.Width + 0.5, 0.5).Direction,
            camera.RayThrough(camera.Width + 0.5, camera.Height + 0.5).Direction, camera.RayThrough(0.5, camera.Height + 0.5).Direction,
        ];

        // Clockwise in an image whose y is down: right, down and forward are a right-handed system.
        _inward = [.. corners.Select((corner, index) => Vector3D.Cross(corner, corners[(index + 1) % corners.Length]).Normalized())];
    }

    /// <summary>Whether the image shows any part of a disc, were nothing in front of it.</summary>
    /// <remarks>
    /// In the disc's plane each plane of the pyramid is a half plane a x + c >= 0; the disc is the unit circle. The point nearest to the
    /// middle that all half planes have is the middle, the foot on one border, or where two borders meet.
    /// </remarks>
    public bool Shows(in CraterDisc disc)
    {
        Vector3D way = disc.Centre - _apex;
        Span<(double X, double Y, double Offset)> borders = stackalloc (double, double, double)[_inward.Length];
        bool showsMiddle = true;
        for (int i = 0; i < borders.Length; i++)
        {
            Vector3D inward = _inward[i];
            borders[i] = (Vector3D.Dot(inward, disc.Major), Vector3D.Dot(inward, disc.Minor), Vector3D.Dot(inward, way));
            showsMiddle &= borders[i].Offset >= 0.0;
        }

        if (showsMiddle)
        {
            return true;
        }

        for (int i = 0; i < borders.Length; i++)
        {
            (double x, double y, double rest) = borders[i];
            double square = (x * x) + (y * y);
            if (rest < 0.0 && rest * rest > square)
            {
                return false; // all of the disc lies beyond this border
            }

            if (Has(borders, -rest * x / square, -rest * y / square, i, i))
            {
                return true;
            }

            for (int j = 0; j < i; j++)
            {
                (double otherX, double otherY, double otherRest) = borders[j];
                double area = Stable.DifferenceOfProducts(x, otherY, y, otherX);
                if (Has(
                    borders,
                    Stable.DifferenceOfProducts(y, otherRest, rest, otherY) / area,
                    Stable.DifferenceOfProducts(rest, otherX, x, otherRest) / area,
                    i,
                    j))
                {
                    return true;
                }
            }
        }

        return false;
    }

    /// <summary>Whether a point is in the unit circle and in all half planes but those on whose borders it lies.</summary>
    private static bool Has(ReadOnlySpan<(double X, double Y, double Offset)> borders, double x, double y, int first, int second)
    {
        bool isInside = (x * x) + (y * y) <= 1.0; // false also for parallel borders, which meet nowhere
        for (int i = 0; i < borders.Length && isInside; i++)
        {
            isInside = i == first || i == second || (borders[i].X * x) + (borders[i].Y * y) + borders[i].Offset >= 0.0;
        }

        return isInside;
    }
}
