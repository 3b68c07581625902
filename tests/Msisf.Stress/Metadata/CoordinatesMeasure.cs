using System.Globalization;
using Msisf.Adapters.Metadata;
using Msisf.Core.Metadata;
using Msisf.Core.Numerics;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;
using Msisf.Core.Tracing;
using Msisf.Stress.Camera;
using Msisf.Stress.Reference;

namespace Msisf.Stress.Metadata;

/// <summary>The numbers of single pixels as they stand in the meta file: latitude, longitude, illumination direction.</summary>
internal sealed class CoordinatesMeasure : IMeasure<CoordinatesMeasure>
{
    private readonly AngleMeasure _latitude = new(
        "latitude", PixelBounds.PromisedCoordinate, new SeriesBuilder(1e-8, 1.0, 32, isLogarithmic: true));
    private readonly AngleMeasure _longitude = new(
        "longitude", PixelBounds.PromisedCoordinate, new SeriesBuilder(1e-12, 1.0, 24, isLogarithmic: true));
    private readonly AngleMeasure _direction = new(
        "illumination direction", PixelBounds.PromisedDirection,
        new SeriesBuilder(Tolerances.IlluminationDirectionSine, 1.0, 28, isLogarithmic: true));

    private readonly SeriesBuilder _byDistance = new(MoonConstants.ReferenceRadius, PixelCases.Highest, 36, isLogarithmic: true);
    private readonly CaseCount _undefined = new();
    private readonly CaseCount _outOfRange = new();
    private readonly CaseCount _decisions = new();

    /// <summary>The worst of each quantity.</summary>
    public IEnumerable<StressFigure> Figures =>
    [
        .. _latitude.Figures, .. _longitude.Figures, .. _direction.Figures,
        _undefined.ToFigure("illumination directions that are there or missing against the rule", string.Empty, 0.0),
        _outOfRange.ToFigure("numbers out of their range", string.Empty, 0.0),
        _decisions.ToFigure("pixels that show the Moon or not, wrongly, beyond what rounding explains", string.Empty, 0.0),
    ];

    /// <summary>Errors over the range of an input.</summary>
    public IEnumerable<StressSeries> Series =>
    [
        _byDistance.ToSeries(
            "latitude, emission below 84 degrees",
            "degrees",
            "distance of the camera from the Moon's centre",
            "m",
            PixelBounds.PromisedCoordinate),
        _latitude.Series.ToSeries(
            "latitude, camera within 1e7 m", "degrees", "cosine of the emission angle", "1", PixelBounds.PromisedCoordinate),
        _longitude.Series.ToSeries(
            "longitude, camera within 1e7 m, emission below 84 degrees",
            "degrees",
            "cosine of the latitude",
            "1",
            PixelBounds.PromisedCoordinate),
        _direction.Series.ToSeries(
            "illumination direction, camera within 1e7 m, emission below 84 degrees",
            "degrees",
            "sine of the Sun's zenith angle times that between ground line and line of sight, in the image",
            "1",
            PixelBounds.PromisedDirection),
    ];

    /// <inheritdoc/>
    public void Try(int number, CaseRandom random)
    {
        PixelCases cases = new(random);
        CameraInput input = cases.Camera(number);
        (int x, int y) = (input.Frame.X, input.Frame.Y);
        PreciseCamera precise = input.ToPrecise();
        PrecisePixel? pixel = PrecisePixel.At(precise, x, y);
        Vector3D light = cases.Light(number, input, pixel);
        string Text() => $"{input}, light {light}";
        SpherePixels pixels = new(input.ToCamera(), ReferenceSphere.Lola, new SceneLight(light, IsSun: true));
        bool isThere = pixels.TryGet(x, y, out PixelRecord record);
        if (isThere && pixel is not null)
        {
            NoteCoordinates(input.Position, record.Point, pixel, Text);
            NoteDirection(input.Position, light, record.IlluminationDirection, pixel, Text);
        }

        bool isWrong = isThere != pixel is not null
            && PrecisePixel.FromTangent(precise, x, y) > HitBounds.Roundings * HitBounds.Carried(input.Position);
        _decisions.Note(isWrong, Text);
    }

    /// <inheritdoc/>
    public void Add(CoordinatesMeasure other)
    {
        _latitude.Add(other._latitude);
        _longitude.Add(other._longitude);
        _direction.Add(other._direction);
        _byDistance.Add(other._byDistance);
        _undefined.Add(other._undefined);
        _outOfRange.Add(other._outOfRange);
        _decisions.Add(other._decisions);
    }

    /// <summary>degrees: as the meta file has it, and an XML parser reads it.</summary>
    private static double Written(double radians) =>
        double.Parse(LongE.ToText(double.RadiansToDegrees(radians)), CultureInfo.InvariantCulture);

    /// <summary>degrees between a written angle and that of a vector.</summary>
    private static double Error(double degrees, DoubleWord x, DoubleWord y) =>
        double.RadiansToDegrees(Math.Abs(PreciseMath.AngleError(degrees * PreciseMath.Degree, x, y)));

    private void NoteCoordinates(Vector3D camera, SelenographicPoint found, PrecisePixel pixel, Func<string> text)
    {
        PreciseVector point = pixel.Point;
        DoubleWord across = DoubleWord.Sqrt((point.X * point.X) + (point.Y * point.Y));
        double cosEmission = pixel.CosEmission;
        double cosLatitude = across.High / MoonConstants.ReferenceRadius;
        bool isPlain = cosEmission > HitBounds.PlainCosine;
        bool isNear = camera.Length < HitBounds.OrbitDistance;
        double latitude = Written(found.Latitude);
        double latitudeError = Error(latitude, across, point.Z);
        _latitude.Note(latitudeError, PixelBounds.Coordinate(camera, cosEmission, 1.0), isNear ? cosEmission : null, text);
        if (isPlain)
        {
            _byDistance.Add(camera.Length, latitudeError);
        }

        double longitude = Written(found.Longitude);
        if (cosLatitude > 0.0)
        {
            double error = Error(longitude, point.X, point.Y);
            _longitude.Note(error, PixelBounds.Coordinate(camera, cosEmission, cosLatitude), isNear && isPlain ? cosLatitude : null, text);
        }

        _outOfRange.Note(!(latitude >= -90.0 && latitude <= 90.0 && longitude >= 0.0 && longitude < 360.0), text);
    }

    private void NoteDirection(Vector3D camera, Vector3D light, double? found, PrecisePixel pixel, Func<string> text)
    {
        double sine = pixel.DirectionSine(light);
        double cosEmission = pixel.CosEmission;
        double doubt = PixelBounds.DirectionSine(camera, cosEmission);
        double beyondRule = found is null ? sine - Tolerances.IlluminationDirectionSine : Tolerances.IlluminationDirectionSine - sine;
        _undefined.Note(beyondRule > doubt, () => $"{text()}: {found:R}, exact sine {sine:R}");

        if (found is double angle)
        {
            double degrees = Written(angle);
            (DoubleWord down, DoubleWord right) = pixel.IlluminationDirection(light);
            bool isInSeries = camera.Length < HitBounds.OrbitDistance && cosEmission > HitBounds.PlainCosine;
            _direction.Note(Error(degrees, down, right), PixelBounds.Direction(camera, cosEmission, sine), isInSeries ? sine : null, text);
            _outOfRange.Note(!(degrees >= 0.0 && degrees < 360.0), text);
        }
    }
}
