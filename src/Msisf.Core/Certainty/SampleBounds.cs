using Msisf.Core.Camera;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Render.Shadows;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Scene;

namespace Msisf.Core.Certainty;

/// <summary>Bounds of single samples. Keeps buffers, so each thread needs its own object.</summary>
/// <param name="search">Finds facets; for the heights' limits.</param>
/// <param name="camera">The camera.</param>
/// <param name="light">The Sun.</param>
/// <param name="options">How the image is drawn: the law is an <see cref="IEnclosedLaw"/>.</param>
/// <param name="uncertainty">The other limits.</param>
internal sealed class SampleBounds(
    BandSearch search, FrameCamera camera, SceneLight light, NativeRenderOptions options, Uncertainty uncertainty)
{
    /// <summary>m: by how much rounding moves a corner, of the surface that is drawn and of another one.</summary>
    private const double Lattices = 2.0 * Tolerances.VertexLattice;

    private readonly IEnclosedLaw _law = (IEnclosedLaw)options.Reflectance;
    private readonly SamplePattern _pattern = SamplePattern.Grid(options.SubsamplesPerAxis);
    private readonly double _discSlope = DiscSlopeOf(light, options);
    private readonly MapRange? _map = options.Albedo is { } map ? new MapRange(camera, map, options, uncertainty) : null;
    private readonly List<Meeting> _seen = [];
    private readonly List<Meeting> _casters = [];
    private readonly List<double> _ends = [];

    /// <summary>Tangent of the angle at which the Sun's disc ends, at most; 0 for a point.</summary>
    public static double DiscSlopeOf(SceneLight light, NativeRenderOptions options) =>
        options.Sun == SunModel.Disc ? -new SunDisc(light.PositionBodyFixed, light.Radius).MinCosine : 0.0;

    /// <summary>Finds the bounds of a row's pixels: the means of their samples'.</summary>
    public void FindRow(int row, CertainImage image)
    {
        for (int column = 0; column < camera.Width; column++)
        {
            Interval sum = Interval.Zero;
            CertainState? state = null;
            for (int sample = 0; sample < _pattern.Count; sample++)
            {
                Ray ray = camera.RayThrough(column + 1.0 + _pattern.Right[sample], row + 1.0 + _pattern.Down[sample]);
                Found found = OfRay(ray);
                sum += found.Factors;
                state = state is null || state == found.State ? found.State : CertainState.Undecided;
            }

            int pixel = (row * camera.Width) + column;
            double rounding = Tolerances.IntervalRounding * sum.High;
            image.Low[pixel] = Math.Max(0.0, (sum.Low - rounding) / _pattern.Count);
            image.High[pixel] = (sum.High + rounding) / _pattern.Count;
            image.States[pixel] = state!.Value;
        }
    }

    private Found OfRay(Ray ray)
    {
        double growth = 2.0 * Math.Sin(0.5 * uncertainty.Turn);
        Beam beam = new(ray.Origin, ray.Direction.Normalized(), uncertainty.Position + Lattices, growth);
        _seen.Clear();
        search.Find(in beam, onlyCasters: false, _seen);
        double end = EndOf(in beam, _seen);
        Found? found = null;
        foreach (Meeting meeting in _seen)
        {
            // The surface is entered from outside: through facets that face the ray.
            if (meeting.Where.Low <= end && meeting.Facet.MayFaceAway(beam.Direction, uncertainty.Turn))
            {
                Found there = OfGround(in beam, meeting.Facet, meeting.Where with { High = Math.Min(meeting.Where.High, end) });
                found = found is { } before ? before.Or(there) : there;
            }
        }

        Found sky = new(Interval.Zero, CertainState.NoSurface);
        return found is not { } ground ? sky : double.IsFinite(end) ? ground : ground.Or(sky);
    }

    /// <summary>m along a beam: where all of its rays have entered the ground, whatever its form; infinity if that is nowhere.</summary>
    private double EndOf(in Beam beam, List<Meeting> meetings)
    {
        _ends.Clear();
        foreach (Meeting meeting in meetings)
        {
            _ends.Add(meeting.BelowFrom);
            _ends.Add(meeting.Where.High);
        }

        _ends.Sort();
        foreach (double distance in _ends)
        {
            if (!double.IsFinite(distance) || search.IsInside(beam.At(distance), beam.RadiusAt(distance)))
            {
                return distance;
            }
        }

        return double.PositiveInfinity;
    }

    /// <summary>What samples show where a beam meets a facet.</summary>
    /// <param name="where">m along the beam.</param>
    private Found OfGround(in Beam beam, FacetBand facet, Interval where)
    {
        Vector3D point = beam.At(where.Middle);
        double radius = where.Radius + beam.RadiusAt(where.High);
        Vector3D toSun = light.PositionBodyFixed - point;
        double distance = toSun.Length;
        toSun /= distance;
        double sunAngle = uncertainty.Sun + BandSearch.AngleOf(radius, distance);
        FacetAngles angles = new(facet, toSun, sunAngle, -beam.Direction, uncertainty.Turn);
        if (angles.CosIncidence.High <= -_discSlope)
        {
            return new Found(Interval.Zero, CertainState.Dark);
        }

        Beam toLight = new(point, toSun, radius, Math.Tan(Math.Min(1.0, sunAngle + _discSlope)));
        _casters.Clear();
        search.Find(in toLight, onlyCasters: true, _casters);
        bool isFacing = angles.CosIncidence.Low > _discSlope;
        if (_casters.Count > 0 && double.IsFinite(EndOf(in toLight, _casters)))
        {
            return new Found(Interval.Zero, CertainState.Dark);
        }

        bool isLit = isFacing && _casters.Count == 0;
        Interval factors = angles.RadianceFactors(_law, isLit ? 0.0 : 2.0 * _discSlope);
        factors *= _map?.Of(point, radius) ?? 1.0;
        return isLit ? new Found(factors, CertainState.Lit) : new Found(factors with { Low = 0.0 }, CertainState.Undecided);
    }

    /// <summary>What a sample can show.</summary>
    /// <param name="Factors">I/F.</param>
    /// <param name="State">What is certain of it.</param>
    private readonly record struct Found(Interval Factors, CertainState State)
    {
        /// <summary>What shows this or something else.</summary>
        public Found Or(Found other) =>
            new(Factors.Hull(other.Factors), State == other.State ? State : CertainState.Undecided);
    }
}
