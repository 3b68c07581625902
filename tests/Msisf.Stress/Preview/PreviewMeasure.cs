using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Preview;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;
using Msisf.Core.Tracing;
using Msisf.Stress.Camera;

namespace Msisf.Stress.Preview;

/// <summary>
/// Previews of single images. Whether an image shows the sphere is known from the angle between the direction of its centre and the nearest
/// direction in the image's pyramid.
/// </summary>
internal sealed class PreviewMeasure : IMeasure<PreviewMeasure>
{
    /// <summary>rad: nearer to the limb rounding of the attitude decides.</summary>
    private const double Undecided = 1e-12;

    /// <summary>Rays along a side of the image.</summary>
    private const int Rays = 64;

    /// <summary>1: a grid of rays is right to about a step of it for each of the sphere's two borders and the terminator.</summary>
    private const double ShareLimit = 1.5 / Rays;

    /// <summary>1: part of an image in which the preview may overlook the sphere, which it looks for in 65 rows.</summary>
    private const double OverlookedLimit = 1e-4;

    private readonly CaseCount _shownBeside = new();
    private readonly CaseCount _overlooked = new();
    private readonly CaseCount _undefined = new();
    private readonly WorstCase _moon = new();
    private readonly WorstCase _lit = new();

    /// <summary>The worst of each quantity.</summary>
    public IEnumerable<StressFigure> Figures =>
    [
        _shownBeside.ToFigure("images beside the Moon that are not told as such, or whose share is not +0", string.Empty, 0.0),
        _overlooked.ToFigure("images with more than a ten-thousandth of the Moon for which 0 is said", string.Empty, 0.0),
        _undefined.ToFigure("shares outside 0 to 1", string.Empty, 0.0),
        _moon.ToFigure("share of the image that shows the Moon, against 64 x 64 rays", "1", ShareLimit),
        _lit.ToFigure("share of the image that shows lit ground, against 64 x 64 rays", "1", ShareLimit),
    ];

    /// <inheritdoc/>
    public void Try(int number, CaseRandom random)
    {
        AimedCameras cameras = new(random);
        Vector3D position = (MoonConstants.ReferenceRadius + random.Logarithmic(1.0, 1e12)) * cameras.Zenith(number);
        CameraInput input = cameras.Passing(position, Math.Min(Nearest(number, random), position.Length));
        SceneLight sun = new(1.5e11 * random.Direction(), IsSun: true);
        SphereShare share = SphereCoverage.Of(input.ToCamera(), sun, MoonConstants.ReferenceRadius);
        bool isZero = BitConverter.DoubleToInt64Bits(share.Moon) == 0L;
        _undefined.Note(!(share.Moon is >= 0.0 and <= 1.0 && share.Lit is null or (>= 0.0 and <= 1.0)), input.ToString);
        double gap = Gap(input);
        if (gap > Undecided)
        {
            _shownBeside.Note(!isZero || share.Lit is not null, input.ToString);
        }

        (double moon, double lit) = ByRays(input, sun);
        _moon.Note(Math.Abs(moon - share.Moon), input.ToString);
        _lit.Note(Math.Abs(lit - (share.Moon * (share.Lit ?? 0.0))), input.ToString);
        _overlooked.Note(isZero && moon > OverlookedLimit, input.ToString);
    }

    /// <inheritdoc/>
    public void Add(PreviewMeasure other)
    {
        _shownBeside.Add(other._shownBeside);
        _overlooked.Add(other._overlooked);
        _undefined.Add(other._undefined);
        _moon.Add(other._moon);
        _lit.Add(other._lit);
    }

    /// <summary>m from the centre: over the disc, at the limb, and beside the Moon.</summary>
    private static double Nearest(int number, CaseRandom random) => MoonConstants.ReferenceRadius * ((number / 8 % 4) switch
    {
        0 => Math.Sqrt(random.Between(0.0, 1.0)),
        1 => 1.0 + (random.Sign() * random.Logarithmic(1e-15, 1e-6)),
        _ => 1.0 + random.Logarithmic(1e-6, 100.0),
    });

    /// <summary>rad: angle between the sphere's limb and the image; negative if the image shows the sphere.</summary>
    private static double Gap(CameraInput input)
    {
        FrameCamera camera = input.ToCamera();
        double distance = input.Position.Length;
        Vector3D centre = -input.Position / distance;
        Vector3D[] corners =
        [
            Direction(0.5, 0.5), Direction(0.5, camera.Height + 0.5), Direction(camera.Width + 0.5, camera.Height + 0.5),
            Direction(camera.Width + 0.5, 0.5),
        ];
        Vector3D middle = Direction(0.5 + (0.5 * camera.Width), 0.5 + (0.5 * camera.Height));
        bool isInside = true;
        double nearest = double.PositiveInfinity;
        for (int i = 0; i < corners.Length; i++)
        {
            (Vector3D from, Vector3D to) = (corners[i], corners[(i + 1) % corners.Length]);
            Vector3D plane = Vector3D.Cross(from, to).Normalized();
            plane = Vector3D.Dot(plane, middle) < 0.0 ? -plane : plane;
            double inward = Vector3D.Dot(plane, centre);
            isInside &= inward >= 0.0;
            Vector3D foot = (centre - (inward * plane)).Normalized();
            bool isOnEdge = Vector3D.Dot(Vector3D.Cross(from, foot), Vector3D.Cross(from, to)) >= 0.0
                && Vector3D.Dot(Vector3D.Cross(foot, to), Vector3D.Cross(from, to)) >= 0.0;
            nearest = Math.Min(nearest, Vector3D.AngleBetween(centre, from));
            nearest = isOnEdge ? Math.Min(nearest, Vector3D.AngleBetween(centre, foot)) : nearest;
        }

        double limb = Math.Atan2(
            MoonConstants.ReferenceRadius,
            Math.Sqrt((distance - MoonConstants.ReferenceRadius) * (distance + MoonConstants.ReferenceRadius)));
        return isInside ? -limb : nearest - limb;

        Vector3D Direction(double x, double y) => camera.RayThrough(x, y).Direction.Normalized();
    }

    private static (double Moon, double Lit) ByRays(CameraInput input, SceneLight sun)
    {
        FrameCamera camera = input.ToCamera();
        (int moon, int lit) = (0, 0);
        for (int row = 0; row < Rays; row++)
        {
            for (int column = 0; column < Rays; column++)
            {
                double x = 0.5 + ((column + 0.5) / Rays * camera.Width);
                double y = 0.5 + ((row + 0.5) / Rays * camera.Height);
                if (ReferenceSphere.Lola.TryFirstHit(camera.RayThrough(x, y), out Vector3D point))
                {
                    moon++;
                    lit += Vector3D.Dot(point, sun.PositionBodyFixed - point) > 0.0 ? 1 : 0;
                }
            }
        }

        return (moon / (double)(Rays * Rays), lit / (double)(Rays * Rays));
    }
}
