using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;
using Msisf.Stress.Reference;

namespace Msisf.Stress.Camera;

/// <summary>Where pixels' rays meet the reference sphere, from 1 m above it to 1e12 m, and whether they meet it at the limb.</summary>
internal sealed class SphereMeasure : IMeasure<SphereMeasure>
{
    /// <summary>m: the range that the plain figure in metres is for; the far side of any orbit of the Moon.</summary>
    private const double OrbitDistance = 1e7;

    /// <summary>1: cosine of the emission angle down to which the plain figures are; 84 degrees.</summary>
    private const double PlainCosEmission = 0.1;

    /// <summary>m: from <see cref="OrbitDistance"/>, at such emission angles.</summary>
    private const double PlainLimit = 1e-7;

    private readonly FigureBuilder _ratio = new("hit point on the reference sphere, to what its bound allows", "1", 1.0);
    private readonly FigureBuilder _metres = new("hit point on the reference sphere, camera within 1e7 m, emission below 84 degrees", "m", PlainLimit);
    private readonly FigureBuilder _decision = new("distance from the tangent of a ray that is taken for a hit or a miss wrongly", "roundings of the inputs", HitBounds.Roundings);
    private readonly FigureBuilder _decisionMetres = new("the same, camera within 1e7 m", "m", null);
    private readonly FigureBuilder _wrong = new("hits that are not finite", string.Empty, 0.0);
    private readonly SeriesBuilder _byAltitude = new(1.0, 1e12, 48, isLogarithmic: true);
    private readonly SeriesBuilder _byEmission = new(1e-8, 1.0, 32, isLogarithmic: true);

    /// <inheritdoc/>
    public IEnumerable<StressFigure> Figures =>
        [_ratio.ToFigure(), _metres.ToFigure(), _decision.ToFigure(), _decisionMetres.ToFigure(), _wrong.ToFigure()];

    /// <inheritdoc/>
    public IEnumerable<StressSeries> Series =>
    [
        _byAltitude.ToSeries("hit point on the reference sphere, emission below 84 degrees", "m", "altitude of the camera", "m", null),
        _byEmission.ToSeries("hit point on the reference sphere, to what its bound allows", "1", "cosine of the emission angle", "1", 1.0),
    ];

    /// <inheritdoc/>
    public void Try(int number, Random random)
    {
        AimedCameras cameras = new(random);
        Vector3D position = (MoonConstants.ReferenceRadius + cameras.Log(1.0, 1e12)) * cameras.Zenith(number);
        CameraInput input = cameras.Passing(position, Math.Min(Nearest(number, cameras, position), position.Length));
        Ray ray = input.ToCamera().RayThrough(input.Frame.X, input.Frame.Y);
        bool isHit = ReferenceSphere.Lola.TryFirstHit(ray, out Vector3D point);
        PreciseCamera camera = input.ToPrecise();
        PrecisePixel? pixel = PrecisePixel.At(camera, input.Frame.X, input.Frame.Y);
        if (isHit != pixel is not null)
        {
            double off = PrecisePixel.FromTangent(camera, input.Frame.X, input.Frame.Y);
            _decision.Add(off / HitBounds.Carried(position), input.ToString);
            _decisionMetres.Add(position.Length < OrbitDistance ? off : 0.0, input.ToString);
        }
        else if (isHit && !point.IsFinite)
        {
            _wrong.Count(input.ToString);
        }
        else if (isHit)
        {
            NoteHit(input, point, pixel!);
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
    private static double Nearest(int number, AimedCameras cameras, Vector3D position) => (number / 8 % 4) switch
    {
        0 or 1 => MoonConstants.ReferenceRadius * Math.Sqrt(cameras.Between(0.0, 1.0)),
        2 => MoonConstants.ReferenceRadius * (1.0 - cameras.Log(1e-16, 1e-2)),
        _ => MoonConstants.ReferenceRadius + (cameras.Between(-20.0, 20.0) * HitBounds.Carried(position)),
    };

    private void NoteHit(CameraInput input, Vector3D point, PrecisePixel pixel)
    {
        double error = (PreciseVector.From(point) - pixel.Point).Length.High;
        double cosEmission = pixel.CosEmission;
        double ratio = error / HitBounds.OnSphere(input.Position, cosEmission);
        _ratio.Add(ratio, input.ToString);
        _byEmission.Add(Math.Max(cosEmission, 1e-8), ratio);
        if (cosEmission > PlainCosEmission)
        {
            _byAltitude.Add(input.Position.Length - MoonConstants.ReferenceRadius, error);
            _metres.Add(input.Position.Length < OrbitDistance ? error : 0.0, input.ToString);
        }
    }
}
