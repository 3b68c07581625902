namespace Msisf.Core.Camera;

/// <summary>
/// What the pixels of an image see. The image consists of bands of rows with one state each: a frame camera (<see cref="FrameCamera"/>)
/// has one band, a camera that scans or whose shutter rolls has more (<see cref="BandedCamera"/>). Points of the image are in rendering
/// coordinates of the whole image: pixel (x, y) from 1, x right, y down (thesis eq. 8.13). Immutable.
/// </summary>
public interface ICamera
{
    /// <summary>Image width, px.</summary>
    int Width { get; }

    /// <summary>Image height, px.</summary>
    int Height { get; }

    /// <summary>The bands from the top of the image to its foot.</summary>
    IReadOnlyList<CameraBand> Bands { get; }

    /// <summary>The state of the frame, which is that of its first row.</summary>
    CameraState State => Bands[0].Camera.State;

    /// <summary>Focal point of the frame, m, body-fixed.</summary>
    Vector3D PositionBodyFixed => State.PositionBodyFixed;

    /// <summary>Orientation of the frame: turns camera axes into Moon axes.</summary>
    UnitQuaternion MoonFromCamera => State.MoonFromCamera;

    /// <summary>The band that holds a row; above and below the image the first and the last.</summary>
    /// <param name="y">Rendering coordinate; row y reaches from y - 0.5 to y + 0.5.</param>
    CameraBand BandAt(double y);

    /// <summary>The ray through a point of the image plane.</summary>
    /// <param name="x">Rendering coordinate; whole numbers are pixel centres.</param>
    /// <param name="y">Rendering coordinate.</param>
    Ray RayThrough(double x, double y);

    /// <summary>Where a point is seen.</summary>
    /// <param name="pointBodyFixed">m, body-fixed.</param>
    /// <param name="point">Rendering coordinates, also outside the image; (0, 0) if there are none.</param>
    /// <returns>False for a point that no row sees, because it lies behind the camera.</returns>
    bool TryProjectPoint(Vector3D pointBodyFixed, out RenderingPoint point);

    /// <summary>
    /// Where a point is seen, or would be if its neighbours in the image left no gap between their rows: outlines are closed curves then.
    /// </summary>
    /// <inheritdoc cref="TryProjectPoint"/>
    bool TryProjectOutline(Vector3D pointBodyFixed, out RenderingPoint point) => TryProjectPoint(pointBodyFixed, out point);

    /// <summary>The camera of a part of the image, or of more than it, in which each pixel shows what it shows in the whole.</summary>
    /// <param name="left">Columns of the whole to the left of it; negative where it reaches farther than the whole.</param>
    /// <param name="top">Rows of the whole above it.</param>
    /// <param name="width">px.</param>
    /// <param name="height">px.</param>
    /// <exception cref="Errors.BadInputException">The lens does not reach so far.</exception>
    ICamera Window(int left, int top, int width, int height);

    /// <summary>The camera some time after, or before, with all its rows.</summary>
    /// <param name="seconds">s; the camera itself at 0.</param>
    ICamera Moved(CameraMotion motion, double seconds);

    /// <summary>The space that some rows show, of each band by itself.</summary>
    /// <param name="margin">px beyond the border of the image and of each band.</param>
    /// <param name="rows">The rows; null for the whole image.</param>
    internal IEnumerable<ViewFrustum> Bounds(double margin, PixelRows? rows = null)
    {
        PixelRows wanted = rows ?? new PixelRows(0, Height);
        return Bands
            .Where(band => band.Rows.First < wanted.End && wanted.First < band.Rows.End)
            .Select(band => new ViewFrustum(
                band.Camera,
                margin,
                new PixelRows(
                    Math.Max(0, wanted.First - band.Rows.First), Math.Min(band.Rows.End, wanted.End) - band.Rows.First)));
    }
}

/// <summary>A half line: origin + t direction, t >= 0.</summary>
/// <param name="Origin">m, body-fixed.</param>
/// <param name="Direction">MOON_ME, any length but zero.</param>
public readonly record struct Ray(Vector3D Origin, Vector3D Direction);

/// <summary>
/// A point of the image plane in rendering coordinates (thesis eq. 8.13): whole numbers are pixel centres, from 1; any value outside the
/// image is allowed.
/// </summary>
/// <param name="X">px, to the right.</param>
/// <param name="Y">px, down.</param>
public readonly record struct RenderingPoint(double X, double Y);

/// <summary>Some neighbouring rows of an image.</summary>
/// <param name="First">0: the topmost row of the image.</param>
/// <param name="End">One past the lowest row.</param>
public readonly record struct PixelRows(int First, int End)
{
    /// <summary>Cuts an image into strips of about equal height.</summary>
    /// <param name="strips">How many are wanted; an image with few rows gives fewer.</param>
    /// <param name="unit">Each strip but the last begins at a multiple of this.</param>
    public static IReadOnlyList<PixelRows> Strips(int height, int strips, int unit)
    {
        int units = (height + unit - 1) / unit;
        int count = Math.Clamp(strips, 1, units);
        int Border(int strip) => Math.Min(height, units * strip / count * unit);
        return [.. Enumerable.Range(0, count).Select(strip => new PixelRows(Border(strip), Border(strip + 1)))];
    }
}
