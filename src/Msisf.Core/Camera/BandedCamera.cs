namespace Msisf.Core.Camera;

/// <summary>A camera whose bands of rows have a state each: one that scans, or whose shutter rolls.</summary>
public sealed class BandedCamera : ICamera
{
    private readonly CameraBand[] _bands;

    private BandedCamera(IEnumerable<FrameCamera> cameras)
    {
        int end = 0;
        _bands = [.. cameras.Select(camera => new CameraBand(new PixelRows(end, end += camera.Height), camera))];
        Height = end;
    }

    /// <inheritdoc/>
    public int Width => _bands[0].Camera.Width;

    /// <inheritdoc/>
    public int Height { get; }

    /// <inheritdoc/>
    public IReadOnlyList<CameraBand> Bands => _bands;

    /// <summary>The camera that consists of some, one below the other; one alone stays what it is.</summary>
    /// <param name="cameras">At least one; all of the same width.</param>
    public static ICamera Of(IReadOnlyList<FrameCamera> cameras)
    {
        ArgumentOutOfRangeException.ThrowIfZero(cameras.Count);
        return cameras.Any(camera => camera.Width != cameras[0].Width)
            ? throw new ArgumentException("Bands of several widths do not make an image.", nameof(cameras))
            : cameras.Count == 1 ? cameras[0] : new BandedCamera(cameras);
    }

    /// <summary>A camera whose rows have states of their own; neighbouring rows of the same state are one band.</summary>
    /// <param name="model">The camera; each row sees what this one's row sees.</param>
    /// <param name="states">State of each row, from the top.</param>
    public static ICamera Of(CameraModel model, IReadOnlyList<CameraState> states)
    {
        ArgumentOutOfRangeException.ThrowIfNotEqual(states.Count, model.Height);
        List<FrameCamera> cameras = [];
        for (int first = 0, end; first < states.Count; first = end)
        {
            for (end = first + 1; end < states.Count && states[end] == states[first]; end++)
            {
            }

            cameras.Add(model.Window(0, first, model.Width, end - first).At(states[first]));
        }

        return Of(cameras);
    }

    /// <inheritdoc/>
    public CameraBand BandAt(double y)
    {
        double row = Math.Clamp(Math.Floor(y - 0.5), 0.0, Height - 1.0);
        int low = 0;
        for (int high = _bands.Length - 1; low < high;)
        {
            int middle = (low + high + 1) / 2;
            (low, high) = _bands[middle].Rows.First <= row ? (middle, high) : (low, middle - 1);
        }

        return _bands[low];
    }

    /// <inheritdoc/>
    public Ray RayThrough(double x, double y)
    {
        (PixelRows rows, FrameCamera camera) = BandAt(y);
        return camera.RayThrough(x, y - rows.First);
    }

    /// <inheritdoc/>
    /// <remarks>
    /// The band is, among those that see the point, the one whose rows it is in or nearest to. A point that is in no band's rows
    /// has a place beside the image, even where its place beside that band would be among the rows of others.
    /// </remarks>
    public bool TryProjectPoint(Vector3D pointBodyFixed, out RenderingPoint point)
    {
        (double nearest, PixelRows where) = ProjectNearest(pointBodyFixed, out point);
        if (nearest is > 0.0 and < double.PositiveInfinity && point.Y >= 0.5 && point.Y <= Height + 0.5)
        {
            point = point with { Y = where.First + where.End < Height ? 0.5 - nearest : Height + 0.5 + nearest };
        }

        return nearest < double.PositiveInfinity;
    }

    /// <inheritdoc/>
    /// <remarks>A point between the rows of two bands has its place beside those of the nearer one.</remarks>
    public bool TryProjectOutline(Vector3D pointBodyFixed, out RenderingPoint point) =>
        ProjectNearest(pointBodyFixed, out point).Distance < double.PositiveInfinity;

    /// <summary>The place of a point in the band in whose rows it lies, or beside whose rows it lies nearest.</summary>
    /// <returns>px from that band's rows, infinite if no band sees the point; and the rows.</returns>
    private (double Distance, PixelRows Rows) ProjectNearest(Vector3D pointBodyFixed, out RenderingPoint point)
    {
        (double nearest, point, PixelRows where) = (double.PositiveInfinity, default, default);
        foreach ((PixelRows rows, FrameCamera camera) in _bands)
        {
            if (camera.TryProjectPoint(pointBodyFixed, out RenderingPoint seen))
            {
                double beside = Math.Max(0.0, Math.Max(0.5 - seen.Y, seen.Y - camera.Height - 0.5));
                (nearest, point, where) = beside < nearest
                    ? (beside, seen with { Y = seen.Y + rows.First }, rows)
                    : (nearest, point, where);
            }
        }

        return (nearest, where);
    }

    /// <inheritdoc/>
    /// <remarks>Rows above and below the image are seen in the states of the first and the last row.</remarks>
    public ICamera Window(int left, int top, int width, int height) => Of(
    [
        .. from band in _bands
           let first = band.Rows.First == 0 ? top : Math.Max(top, band.Rows.First)
           let end = band.Rows.End == Height ? top + height : Math.Min(top + height, band.Rows.End)
           where first < end
           select (FrameCamera)band.Camera.Window(left, first - band.Rows.First, width, end - first),
    ]);

    /// <inheritdoc/>
    public ICamera Moved(CameraMotion motion, double seconds) =>
        Of([.. _bands.Select(band => (FrameCamera)band.Camera.Moved(motion, seconds))]);
}
