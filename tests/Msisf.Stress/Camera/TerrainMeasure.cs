using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Surface;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;
using Msisf.Core.Tracing;
using Msisf.Stress.Reference;

namespace Msisf.Stress.Camera;

/// <summary>Where pixels' rays meet the terrain: whether it is the right facet, and where on it.</summary>
/// <param name="terrain">The model.</param>
internal sealed class TerrainMeasure(TerrainUnderTest terrain) : IMeasure<TerrainMeasure>
{
    /// <summary>m: how far below the reference sphere a camera "in a valley" stands at least.</summary>
    private const double ValleyDepth = 1000.0;

    private readonly FacetJudge _judge = new(terrain);
    private readonly CaseCount _wrong = new();
    private readonly WorstCase _ratio = new();
    private readonly WorstCase _metres = new();
    private readonly CaseCount _sphere = new();
    private readonly SeriesBuilder _byAltitude = new(1.0, 1e12, 48, isLogarithmic: true);

    /// <summary>Rays that met the ground.</summary>
    private long _hits;

    /// <summary>The worst of each quantity.</summary>
    public IEnumerable<StressFigure> Figures =>
    [
        _wrong.ToFigure("terrain: rays that meet no facet or another than the first they enter", string.Empty, 0.0),
        _ratio.ToFigure("hit point on the terrain, to what its bound allows", "1", 1.0),
        _metres.ToFigure("hit point on the terrain, camera within 1e7 m, facet seen below 84 degrees", "m", HitBounds.PlainLimit),
        _sphere.ToFigure("valleys: rays from under the reference sphere that it is said to show", string.Empty, 0.0),
        new StressFigure($"terrain: rays that meet {terrain.Grid.ProductId}", "rays", _hits, null, string.Empty),
    ];

    /// <summary>Errors over the range of an input.</summary>
    public IEnumerable<StressSeries> Series =>
        [_byAltitude.ToSeries(
            "hit point on the terrain, facet seen below 84 degrees", "m", "height of the camera over the ground", "m", null)];

    /// <inheritdoc/>
    public void Try(int number, CaseRandom random)
    {
        AimedCameras cameras = new(random);
        bool isInValley = number % 7 == 0;
        Vector3D zenith = isInValley ? Valley(random) : cameras.Zenith(number);
        double ground = TerrainHeight.RadiusBelow(terrain.Grid, zenith);
        double height = random.Logarithmic(1.0, isInValley ? ValleyDepth / 2.0 : 1e12);
        Vector3D position = (ground + height) * zenith;
        CameraInput input = number % 5 == 0
            ? cameras.Towards(position, VertexNear(random, zenith, height) - position)
            : cameras.Passing(position, Nearest(number, random, ground + height));
        Ray ray = input.ToCamera().RayThrough(input.Frame.X, input.Frame.Y);
        bool isHit = terrain.Tracer.TryTrace(ray, out SurfaceHit hit);
        bool isWrong = _judge.IsWrong(ray, isHit ? hit : null);
        _wrong.Note(isWrong, input.ToString);
        if (isHit && !isWrong)
        {
            _hits++;
            NoteHit(input, ray, hit, height);
        }

        if (isInValley)
        {
            _sphere.Note(ReferenceSphere.Lola.TryFirstHit(ray, out _), input.ToString);
        }
    }

    /// <inheritdoc/>
    public void Add(TerrainMeasure other)
    {
        _wrong.Add(other._wrong);
        _ratio.Add(other._ratio);
        _metres.Add(other._metres);
        _sphere.Add(other._sphere);
        _byAltitude.Add(other._byAltitude);
        _hits += other._hits;
    }

    /// <summary>m: evenly over the disc, and about the limb, where mountains stand against the sky.</summary>
    private static double Nearest(int number, CaseRandom random, double distance) => Math.Min(
        distance,
        MoonConstants.ReferenceRadius * (number / 8 % 2 == 0 ? Math.Sqrt(random.Between(0.0, 1.0)) : random.Between(0.994, 1.006)));

    /// <summary>
    /// m, MOON_ME: where six facets meet, within sight if nothing is in between. Rays to it pass its edges by less than a rounding.
    /// </summary>
    private Vector3D VertexNear(CaseRandom random, Vector3D zenith, double height)
    {
        double reach = Math.Min(0.5, height / MoonConstants.ReferenceRadius);
        SelenographicPoint place = SelenographicPoint.Below(zenith + (reach * random.Direction()));
        int line = (int)((0.5 - (place.Latitude / Math.PI)) * terrain.Vertices.Lines);
        int sample = (int)(place.Longitude / (2.0 * Math.PI) * terrain.Vertices.Samples);
        return terrain.Vertices[Math.Min(line, terrain.Vertices.Lines - 1), Math.Min(sample, terrain.Vertices.Samples - 1)];
    }

    private Vector3D Valley(CaseRandom random)
    {
        Vector3D zenith;
        do
        {
            zenith = random.Direction();
        }
        while (TerrainHeight.RadiusBelow(terrain.Grid, zenith) > MoonConstants.ReferenceRadius - ValleyDepth);

        return zenith;
    }

    /// <summary>The point against that of the exact ray on the facet's plane.</summary>
    private void NoteHit(CameraInput input, Ray ray, SurfaceHit hit, double height)
    {
        PreciseCamera camera = input.ToPrecise();
        PreciseVector direction = camera.DirectionThrough(input.Frame.X, input.Frame.Y);
        PreciseFacet facet = terrain.PreciseFacetOf(hit.Facet);
        PreciseVector exact = camera.Position + (facet.ParameterOn(camera.Position, direction) * direction);
        double error = (PreciseVector.From(hit.PointBodyFixed) - exact).Length.High;
        double cosine = facet.Cosine(direction);
        _ratio.Note(error / HitBounds.OnFacet(ray.Origin, cosine), input.ToString);
        if (cosine > HitBounds.PlainCosine)
        {
            _byAltitude.Add(height, error);
            _metres.Note(ray.Origin.Length < HitBounds.OrbitDistance ? error : 0.0, input.ToString);
        }
    }
}
