using System.Globalization;
using Msisf.Core.Numerics;

namespace Msisf.Stress.Povray;

/// <summary>How wrong POV-Ray's answers are for one form of the mesh.</summary>
internal sealed class TraceErrors
{
    private const double MetresPerKilometre = 1000.0;

    /// <summary>Degrees: a normal this far off is that of another facet; neighbours of rugged ground differ by more.</summary>
    private const double SameFacetDegrees = 1e-3;

    /// <summary>From 2 to 2048 px/deg, a bin around each of 4, 16, ... 1024.</summary>
    private const int ResolutionBins = 5;

    private readonly string _form;
    private readonly WorstCase _hit = new();
    private readonly WorstCase _plane = new();
    private readonly WorstCase _planeInFloats = new();
    private readonly WorstCase _normal = new();
    private readonly SeriesBuilder _hitOverResolution = new(2.0, 2048.0, ResolutionBins, isLogarithmic: true);
    private readonly SeriesBuilder _normalOverResolution = new(2.0, 2048.0, ResolutionBins, isLogarithmic: true);
    private readonly SeriesBuilder _planeOverRayLength = new(10.0, 4e8, 16, isLogarithmic: true);
    private readonly SeriesBuilder _planeOverOrigin = new(0.0, 130_000.0, 13, isLogarithmic: false);
    private readonly SeriesBuilder _hitOverIncidence = new(0.0, 90.0, 18, isLogarithmic: false);
    private readonly SeriesBuilder _missedOverRounding = new(1e-6, 1e3, 18, isLogarithmic: true);
    private readonly CaseCount _missed = new();
    private readonly CaseCount _missedBeyond = new();

    /// <param name="form">For the report, e.g. "tile-local mesh2".</param>
    public TraceErrors(string form) => _form = form;

    /// <summary>Compares an answer with the exact hit.</summary>
    /// <param name="block">Where.</param>
    /// <param name="pixelsPerDegree">Its resolution.</param>
    /// <param name="ray">What was asked.</param>
    /// <param name="pointKm">The answer.</param>
    /// <param name="normalFound">Its normal.</param>
    public void Note(TraceBlock block, int pixelsPerDegree, TraceRay ray, Vector3D pointKm, Vector3D normalFound)
    {
        string Input() => string.Create(
            CultureInfo.InvariantCulture,
            $"{block.Place}, ray from {ray.StartKm} km along {ray.Direction}: exactly {ray.HitKm}, found {pointKm}");
        // A mesh has two sides; which way its normal shows, the viewer decides.
        double normal = double.RadiansToDegrees(Math.Min(
            Vector3D.AngleBetween(normalFound, ray.Normal), Vector3D.AngleBetween(-normalFound, ray.Normal)));
        bool isMissed = normalFound == default || normal > SameFacetDegrees;
        _missedOverRounding.Add(ray.RoundedPastEdge, isMissed ? 1.0 : 0.0);
        (ray.RoundedPastEdge > 1.0 ? _missedBeyond : _missed).Note(isMissed, Input);
        if (isMissed)
        {
            return;
        }

        double plane = MetresPerKilometre * Math.Abs(Vector3D.Dot(pointKm - ray.HitKm, ray.Normal));
        double hit = MetresPerKilometre * (pointKm - ray.HitKm).Length;
        _hit.Note(hit, Input);
        _plane.Note(plane, Input);
        _planeInFloats.Note(plane / (MetresPerKilometre * ray.HitFromOriginKm * TracePrecisionStress.FloatUnit), Input);
        _normal.Note(normal, Input);
        _hitOverResolution.Add(pixelsPerDegree, hit);
        _normalOverResolution.Add(pixelsPerDegree, normal);
        _planeOverRayLength.Add(MetresPerKilometre * ray.LengthKm, plane);
        _planeOverOrigin.Add(MetresPerKilometre * ray.HitFromOriginKm, plane);
        _hitOverIncidence.Add(double.RadiansToDegrees(Math.Atan2(Vector3D.Cross(ray.Direction, ray.Normal).Length, ray.Cosine)), hit);
    }

    /// <summary>The figures.</summary>
    /// <param name="isLimited">Whether the form has to keep the limits; the other is there to compare.</param>
    public IEnumerable<StressFigure> Figures(bool isLimited)
    {
        double? Limit(double limit) => isLimited ? limit : null;
        yield return _missed.ToFigure(
            $"{_form}: rays that miss their facet, although rounded to floats they would meet it", string.Empty, Limit(0.0));
        yield return _missedBeyond.ToFigure($"{_form}: rays that miss their facet, and rounded to floats may miss it", string.Empty, null);
        yield return _hit.ToFigure($"{_form}: from the exact hit", "m", null);
        yield return _plane.ToFigure($"{_form}: from the facet's plane", "m", Limit(TracePrecisionStress.MaxFromPlane));
        if (isLimited)
        {
            yield return _planeInFloats.ToFigure(
                $"{_form}: from the facet's plane, in 2^-24 of the distance from the tile's origin", "1",
                TracePrecisionStress.MaxFromPlaneInFloats);
        }

        yield return _normal.ToFigure($"{_form}: normal", "degrees", Limit(TracePrecisionStress.MaxNormalDegrees));
    }

    /// <summary>Errors over what they depend on.</summary>
    public IEnumerable<StressSeries> Series() =>
    [
        _hitOverResolution.ToSeries($"{_form}: from the exact hit", "m", "resolution", "px/deg", null),
        _normalOverResolution.ToSeries($"{_form}: normal", "degrees", "resolution", "px/deg", null),
        _planeOverRayLength.ToSeries($"{_form}: from the facet's plane", "m", "length of the ray", "m", null),
        _planeOverOrigin.ToSeries($"{_form}: from the facet's plane", "m", "distance from the tile's origin", "m", null),
        _hitOverIncidence.ToSeries($"{_form}: from the exact hit", "m", "angle to the normal", "degrees", null),
        _missedOverRounding.ToSeries(
            $"{_form}: share of rays that miss their facet",
            "1",
            "ray's rounding to floats, in parts of the way to the facet's edge",
            "1",
            null),
    ];
}
