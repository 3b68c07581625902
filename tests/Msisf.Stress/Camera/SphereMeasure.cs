using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;
using Msisf.Core.Tracing;
using Msisf.Stress.Reference;

namespace Msisf.Stress.Camera;

/// <summary>Where pixels' rays meet the reference sphere, from 1 m above it to 1e12 m, and whether they meet it at the limb.</summary>
internal sealed class SphereMeasure : IMeasure<SphereMeasure>
{
    private readonly WorstCase _ratio = new();
    private readonly WorstCase _metres = new();
    private readonly WorstCase _decision = new();
    private readonly WorstCase _decisionMetres = new();
    private readonly CaseCount _wrong = new();
    private readonly SeriesBuilder _byAltitude = new(1.0, 1e12, 48, isLogarithmic: true);
    private readonly SeriesBuilder _byEmission = new(1e-8, 1.0, 32, isLogarithmic: true);

    /// <summary>The worst of each quantity.</summary>
    public IEnumerable<StressFigure> Figures =>
    [
        _ratio.ToFigure("hit point on the reference sphere, to what its bound allows", "1", 1.0),
        _metres.ToFigure("hit point on the reference sphere, camera within 1e7 m, emission below 84 degrees", "m", HitBounds.PlainLimit),
        _decision.ToFigure(
            "distance from the tangent of a ray that is taken for a hit or a miss wrongly", "roundings of the inputs", HitBounds.Roundings),
        _decisionMetres.ToFigure("the same, camera within 1e7 m", "m", null),
        _wrong.ToFigure("hits that are not finite", string.Empty, 0.0),
    ];

    /// <summary>Errors over the range of an input.</summary>
    public IEnumerable<StressSeries> Series =>
    [
        _byAltitude.ToSeries("hit point on the reference sphere, emission below 84 degrees", "m", "altitude of the camera", "m", null),
        _byEmission.ToSeries("hit point on the reference sphere, to what its bound allows", "1", "cosine of the emission angle", "1", 1.0),
    ];

    /// <inheritdoc/>
    public void Try(int number, CaseRandom random)
    {
        AimedCameras cameras = new(random);
        Vector3D position = (MoonConstants.ReferenceRadius + random.Logarithmic(1.0, 1e12)) * cameras.Zenith(number);
        CameraInput input = cameras.Passing(position, Math.Min(Nearest(number, random, position), position.Length));
        Ray ray = input.ToCamera().RayThrough(input.Frame.X, input.Frame.Y);
        bool isHit = ReferenceSphere.Lola.TryFirstHit(ray, out Vector3D point);
        PreciseCamera camera = input.ToPrecise();
        PrecisePixel? pixel = PrecisePixel.At(camera, input.Frame.X, input.Frame.Y);
        double off = isHit == pixel is not null ? 0.0 : PrecisePixel.FromTangent(camera, input.Frame.X, input.Frame.Y);
        _decision.Note(off / HitBounds.Carried(position), input.ToString);
        _decisionMetres.Note(position.Length < HitBounds.OrbitDistance ? off : 0.0, input.ToString);
        bool isNoPoint = isHit && !point.IsFinite;
        _wrong.Note(isNoPoint, input.ToString);
        if (isHit && pixel is not null && !isNoPoint)
        {
            NoteHit(input, point, pixel);
        }
    }

    /// <inheritdoc/>
    public void Add(SphereMeasure other)
    {
        _ratio.Add(other._ratio);
        _metres.Add(other._metres);
        _decision.Add(other._decision);
        _decisionMetres.Add(other._decisionMetres);
        _wrong.Add(other._wrong);
        _byAltitude.Add(other._byAltitude);
        _byEmission.Add(other._byEmission);
    }

    /// <summary>m: evenly over the disc, close to the limb, and so close that rounding decides.</summary>
    private static double Nearest(int number, CaseRandom random, Vector3D position) => (number / 8 % 4) switch
    {
        0 or 1 => MoonConstants.ReferenceRadius * Math.Sqrt(random.Between(0.0, 1.0)),
        2 => MoonConstants.ReferenceRadius * (1.0 - random.Logarithmic(1e-16, 1e-2)),
        _ => MoonConstants.ReferenceRadius + (random.Between(-20.0, 20.0) * HitBounds.Carried(position)),
    };

    private void NoteHit(CameraInput input, Vector3D point, PrecisePixel pixel)
    {
        double error = (PreciseVector.From(point) - pixel.Point).Length.High;
        double cosEmission = pixel.CosEmission;
        double ratio = error / HitBounds.OnSphere(input.Position, cosEmission);
        _ratio.Note(ratio, input.ToString);
        _byEmission.Add(Math.Max(cosEmission, 1e-8), ratio);
        if (cosEmission > HitBounds.PlainCosine)
        {
            _byAltitude.Add(input.Position.Length - MoonConstants.ReferenceRadius, error);
            _metres.Note(input.Position.Length < HitBounds.OrbitDistance ? error : 0.0, input.ToString);
        }
    }
}
