using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Stress.Reference;

namespace Msisf.Stress.Camera;

/// <summary>The directions of pixels' rays, and the way back from a direction to its place in the image.</summary>
internal sealed class RayMeasure : IMeasure<RayMeasure>
{
    /// <summary>2^-53, to which a double is rounded.</summary>
    public const double Rounding = 1.0 / (1L << 53);

    /// <summary>
    /// Roundings: a component of a camera axis goes through some ten of them in the quaternion's product, and through five in the sum and
    /// the length of the image plane; they rarely add up.
    /// </summary>
    public const double DirectionLimit = 8.0;

    /// <summary>Roundings: the direction's own, and those of the turn back into the camera and of the division.</summary>
    public const double PlaceLimit = 12.0;

    private readonly WorstCase _direction = new();
    private readonly WorstCase _place = new();
    private readonly WorstCase _pixels = new();
    private readonly CaseCount _wrong = new();
    private readonly SeriesBuilder _byFov = new(1e-4, 180.0, 36, isLogarithmic: true);
    private readonly SeriesBuilder _pixelsByFov = new(1e-4, 180.0, 36, isLogarithmic: true);

    /// <summary>The worst of each quantity.</summary>
    public IEnumerable<StressFigure> Figures =>
    [
        _direction.ToFigure("direction of a pixel's ray", "2^-53 rad", DirectionLimit),
        _place.ToFigure("place in the image of a direction, to what 2^-53 rad move it", "2^-53 rad", PlaceLimit),
        _pixels.ToFigure("direction of a pixel's ray", "px", null),
        _wrong.ToFigure("rays that are not finite, or not seen by their own camera", string.Empty, 0.0),
    ];

    /// <summary>Errors over the range of an input.</summary>
    public IEnumerable<StressSeries> Series =>
    [
        _byFov.ToSeries("direction of a pixel's ray", "2^-53 rad", "field of view", "degrees", DirectionLimit),
        _pixelsByFov.ToSeries("direction of a pixel's ray", "px", "field of view", "degrees", null),
    ];

    /// <inheritdoc/>
    public void Try(int number, CaseRandom random)
    {
        AimedCameras cameras = new(random);
        CameraInput input = cameras.Towards(cameras.Zenith(number), random.Direction());
        PinholeCamera camera = input.ToCamera();
        Vector3D direction = camera.RayThrough(input.Frame.X, input.Frame.Y).Direction;
        PreciseVector exact = input.ToPrecise().DirectionThrough(input.Frame.X, input.Frame.Y);
        bool isSeen = camera.TryProject(direction, out RenderingPoint place) && direction.IsFinite;
        _wrong.Note(!isSeen, input.ToString);
        if (!isSeen)
        {
            return;
        }

        double angle = PreciseVector.Cross(PreciseVector.From(direction), exact).Length.High / exact.Length.High / direction.Length;
        double pixelAngle = MinPixelAngle(camera, direction.Length);
        double degrees = double.RadiansToDegrees(input.FieldOfView);
        _direction.Note(angle / Rounding, input.ToString);
        _pixels.Note(angle / pixelAngle, input.ToString);
        _byFov.Add(degrees, angle / Rounding);
        _pixelsByFov.Add(degrees, angle / pixelAngle);

        // Beside what the angle moves the place, a coordinate is rounded itself.
        double moved = double.Hypot(place.X - input.Frame.X, place.Y - input.Frame.Y);
        double perRounding = Rounding * ((1.0 / pixelAngle) + camera.Width + camera.Height);
        _place.Note(moved / perRounding, input.ToString);
    }

    /// <inheritdoc/>
    public void Add(RayMeasure other)
    {
        _direction.Add(other._direction);
        _place.Add(other._place);
        _pixels.Add(other._pixels);
        _wrong.Add(other._wrong);
        _byFov.Add(other._byFov);
        _pixelsByFov.Add(other._pixelsByFov);
    }

    /// <summary>
    /// rad: what a pixel spans where it is, the shorter way: a step on the image plane, tilted against the line of sight.
    /// </summary>
    private static double MinPixelAngle(PinholeCamera camera, double rayLength) =>
        camera.Direction.Length / camera.Height / (rayLength * rayLength);
}
