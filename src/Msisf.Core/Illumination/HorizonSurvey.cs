using Msisf.Core.Camera;
using Msisf.Core.Parallel;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;
using Msisf.Core.Tracing;

namespace Msisf.Core.Illumination;

/// <summary>Finds the horizons of many places of a terrain, which hold for any date. Safe for several threads.</summary>
public sealed class HorizonSurvey
{
    /// <summary>
    /// Raise it when the same terrain gets another horizon, or one that is stored in another way: kept ones are not used then.
    /// </summary>
    public const int Version = 4;

    /// <summary>Columns of a turn: 0.011 degrees each.</summary>
    public const int Columns = 32_768;

    /// <summary>
    /// degrees: the greatest error of a stored horizon. Between columns it may be off by half a column times the steepest slope along it,
    /// 0.0032 degrees at 30 degrees; storing adds <see cref="StoredErrorDegrees"/> and a step of at most 0.0003 degrees near the poles.
    /// </summary>
    public const double ErrorDegrees = 0.005;

    /// <summary>m: a place on the ground is so high over its facet, so that no light passes through the joint of two facets.</summary>
    public const double LeastHeight = 1e-3;

    /// <summary>Greatest height of a place over the ground, m.</summary>
    public const double MaxHeight = 10_000.0;

    private const double StoredErrorDegrees = 0.0015;

    /// <summary>degrees: the same for horizons that are not kept in files.</summary>
    private const double FineErrorDegrees = 1e-4;

    private readonly HorizonTerrain _terrain;
    private readonly double _start;
    private readonly double _bottom;

    /// <summary>Prepares a survey.</summary>
    /// <param name="terrain">The model, or several.</param>
    /// <param name="tracer">Traces rays on the same terrain.</param>
    /// <param name="directions">Places that span all that are asked for.</param>
    /// <param name="isMoon">Whether it is the Moon, over which the Sun's and the Earth's places are limited.</param>
    public HorizonSurvey(ITerrain terrain, ITerrainTracer tracer, IEnumerable<Vector3D> directions, bool isMoon)
    {
        _terrain = new HorizonTerrain(SurfaceModel.Of(terrain));
        Tracer = tracer;
        _start = terrain.RadiusLimits.Max + 1.0;

        // No horizon dips lower than that of the lowest ground from the highest place.
        (double least, double most) = (terrain.RadiusLimits.Min, terrain.RadiusLimits.Max + MaxHeight);
        _bottom = -Math.Sqrt((most - least) * (most + least)) / least;
        double bottomDegrees = double.RadiansToDegrees(Math.Atan(_bottom));
        Band = new HorizonBand(directions, isMoon, bottomDegrees, Columns);
        Profile = new HorizonProfile(Columns, bottomDegrees, Band.TopDegrees);
    }

    /// <summary>Whether horizons are stored more exactly, with some ten times as many corners; for few places.</summary>
    public bool IsFine { get; init; }

    internal HorizonBand Band { get; }

    internal HorizonProfile Profile { get; }

    internal ITerrainTracer Tracer { get; }

    /// <summary>Finds the place above the ground in a direction.</summary>
    /// <param name="direction">MOON_ME, length 1.</param>
    /// <param name="height">m over the ground; not below 0.</param>
    /// <returns>The place, and the tangent of the ground's slope; null where there is no ground.</returns>
    public (LocalFrame Frame, double Slope)? PlaceAt(Vector3D direction, double height)
    {
        if (!Tracer.TryTrace(new Ray(_start * direction, -direction), out SurfaceHit hit))
        {
            return null;
        }

        Vector3D up = hit.PointBodyFixed.Normalized();
        double cosine = Vector3D.Dot(hit.NormalBodyFixed, up);
        double slope = Math.Sqrt(Math.Max(0.0, (1.0 - cosine) * (1.0 + cosine))) / cosine;
        return (LocalFrame.At((hit.PointBodyFixed.Length + Math.Max(height, LeastHeight)) * up), slope);
    }

    /// <summary>Finds horizons of places that all have ground.</summary>
    /// <inheritdoc cref="FindWithGaps"/>
    /// <exception cref="BadInputException">A place is outside the models.</exception>
    public PlaceHorizons Find(
        IReadOnlyList<Vector3D> directions, double height, int threads, Action<int>? advanced, CancellationToken cancellation)
    {
        PlaceHorizons found = FindWithGaps(directions, height, threads, advanced, cancellation);
        int gap = Enumerable.Range(0, directions.Count).FirstOrDefault(place => !found.HasGround(place), -1);
        return gap < 0 ? found : throw Outside(directions[gap]);
    }

    /// <summary>Finds horizons. Places outside the models have none (<see cref="PlaceHorizons.HasGround"/>).</summary>
    /// <param name="directions">MOON_ME, length 1; neighbours follow each other.</param>
    /// <param name="height">m over the ground; 0 to <see cref="MaxHeight"/>.</param>
    /// <param name="threads">How many work at once.</param>
    /// <param name="advanced">Called with the number of places done since the last call, from any thread.</param>
    /// <param name="cancellation">Stops the work.</param>
    public PlaceHorizons FindWithGaps(
        IReadOnlyList<Vector3D> directions, double height, int threads, Action<int>? advanced, CancellationToken cancellation)
    {
        const int PerItem = 64;
        int items = (directions.Count + PerItem - 1) / PerItem;
        HorizonFinder[] finders = new HorizonFinder[Math.Max(1, Math.Min(threads, items))];
        uint[][] corners = new uint[directions.Count][];
        double[] radii = new double[directions.Count];
        float[] slopes = new float[directions.Count];
        WorkerTeam.Run(finders.Length, items, (worker, item) =>
        {
            HorizonFinder finder = finders[worker] ??= new HorizonFinder(_terrain, Columns);
            List<uint> found = [];
            finder.Forget();
            int end = Math.Min(directions.Count, (item + 1) * PerItem);
            for (int place = item * PerItem; place < end; place++)
            {
                if (PlaceAt(directions[place], height) is not var (frame, slope))
                {
                    (corners[place], slopes[place]) = (HorizonProfile.Empty(Columns), float.NaN);
                    continue;
                }

                finder.Find(frame, _bottom, Band.Tops);
                found.Clear();
                Profile.Store(finder.Buffer.Tangents, IsFine ? FineErrorDegrees : StoredErrorDegrees, found);
                corners[place] = [.. found];
                (radii[place], slopes[place]) = (frame.PositionBodyFixed.Length, (float)slope);
            }

            advanced?.Invoke(end - (item * PerItem));
        }, cancellation);
        int[] ends = new int[directions.Count];
        int sum = 0;
        for (int place = 0; place < ends.Length; place++)
        {
            ends[place] = sum += corners[place].Length;
        }

        uint[] all = new uint[sum];
        for (int place = 0; place < ends.Length; place++)
        {
            corners[place].CopyTo(all, ends[place] - corners[place].Length);
        }

        return new PlaceHorizons(radii, slopes, ends, all);
    }

    /// <summary>Rays of the tracer from a place above the ground.</summary>
    public PlaceRays RaysFrom(LocalFrame frame) => new(Tracer, _terrain.Surface, frame);

    /// <summary>The stored horizon of a place.</summary>
    /// <param name="horizons">Horizons of places.</param>
    /// <param name="place">Which of them.</param>
    /// <returns>Tangent of the elevation at each column of azimuth, and after them that of the first again.</returns>
    public float[] HorizonOf(PlaceHorizons horizons, int place)
    {
        float[] tangents = new float[HorizonProfile.TableLength(Columns)];
        Profile.Read(horizons.CornersOf(place), tangents);
        return tangents[..(Columns + 1)];
    }

    /// <summary>The error of a place outside the models.</summary>
    public static BadInputException Outside(Vector3D direction)
    {
        SelenographicPoint point = SelenographicPoint.Below(direction);
        string place = string.Create(
            CultureInfo.InvariantCulture,
            $"latitude {double.RadiansToDegrees(point.Latitude):F4}, longitude {double.RadiansToDegrees(point.Longitude):F4}");
        return new BadInputException(
            $"There is no ground at {place}: the place is outside the elevation models. Choose a region inside them, or give a model "
                + "of the whole Moon as well.");
    }
}
