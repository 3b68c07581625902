using Msisf.Core.Render.Photometry;

namespace Msisf.Core.Certainty;

/// <summary>
/// The angles on a facet whose corners rise and fall while the directions to Sun and camera turn, and what a law gives for all of them.
/// </summary>
internal readonly struct FacetAngles
{
    private readonly AngleForm _incidence;
    private readonly AngleForm _emission;
    private readonly AngleForm _phase;
    private readonly double _sun;
    private readonly double _view;

    /// <summary>Finds the angles.</summary>
    /// <param name="facet">The facet.</param>
    /// <param name="toSun">Length 1.</param>
    /// <param name="sunAngle">rad: by which it may turn.</param>
    /// <param name="toCamera">Length 1.</param>
    /// <param name="viewAngle">rad: by which it may turn.</param>
    public FacetAngles(FacetBand facet, Vector3D toSun, double sunAngle, Vector3D toCamera, double viewAngle)
    {
        // A unit vector that turns by an angle changes across itself by up to its sine, and along itself by up to 1 - its cosine.
        (_sun, double sunRest) = (Math.Sin(sunAngle), 1.0 - Math.Cos(sunAngle));
        (_view, double viewRest) = (Math.Sin(viewAngle), 1.0 - Math.Cos(viewAngle));
        (double sunChange, double viewChange) = (_sun + sunRest, _view + viewRest);
        _incidence = new AngleForm(
            Vector3D.Dot(facet.Normal, toSun), facet.Rest + sunRest + (facet.Tilt * sunChange))
        {
            ByHeights = ByHeights(facet, toSun),
            BySun = Across(facet.Normal, toSun),
        };
        _emission = new AngleForm(
            Vector3D.Dot(facet.Normal, toCamera), facet.Rest + viewRest + (facet.Tilt * viewChange))
        {
            ByHeights = ByHeights(facet, toCamera),
            ByView = Across(facet.Normal, toCamera),
        };
        _phase = new AngleForm(
            0.25 * (toSun - toCamera).LengthSquared, 0.5 * (sunRest + viewRest + (sunChange * viewChange)))
        {
            BySun = -0.5 * Across(toCamera, toSun),
            ByView = -0.5 * Across(toSun, toCamera),
        };
        CosIncidence = Interval.Around(_incidence.Middle, _incidence.Radius(_sun, _view)).Clamp(-1.0, 1.0);
    }

    /// <summary>Cosine of the incidence angle.</summary>
    public Interval CosIncidence { get; }

    /// <summary>The radiance factors where the facet sees the Sun.</summary>
    /// <param name="law">The law.</param>
    /// <param name="beyond">By how much the mean cosine of a part of the Sun's disc can be above that of its centre.</param>
    public Interval RadianceFactors(IEnclosedLaw law, double beyond)
    {
        Interval incidence = new(CosIncidence.Low, Math.Min(1.0, CosIncidence.High + beyond));
        Interval emission = Interval.Around(_emission.Middle, _emission.Radius(_sun, _view)).Clamp(-1.0, 1.0);
        Interval phase = Interval.Around(_phase.Middle, _phase.Radius(_sun, _view)).Clamp(0.0, 1.0);
        bool isWhole = beyond == 0.0 && incidence.Low > Tolerances.GrazingCosine && emission.Low > Tolerances.GrazingCosine;
        Sloped factor = law.Enclose(
            Sloped.Variable(incidence.Clamp(Tolerances.GrazingCosine, 1.0), 0),
            Sloped.Variable(emission.Clamp(Tolerances.GrazingCosine, 1.0), 1),
            Sloped.Variable(phase, 2));
        Interval direct = new(isWhole ? Math.Max(0.0, factor.Value.Low) : 0.0, factor.Value.High);
        return isWhole && factor.First.IsFinite && factor.Second.IsFinite && factor.Third.IsFinite
            ? direct.Both(BySlopes(law, in factor))
            : direct;
    }

    /// <summary>The mean value theorem: from the middle on, the law changes by slopes in the box times the angles' changes.</summary>
    private Interval BySlopes(IEnclosedLaw law, in Sloped factor)
    {
        Interval middle = law.Enclose(
            Math.Min(1.0, _incidence.Middle), Math.Min(1.0, _emission.Middle), Math.Clamp(_phase.Middle, 0.0, 1.0)).Value;
        AngleForm change = (factor.First.Middle * _incidence) + (factor.Second.Middle * _emission) + (factor.Third.Middle * _phase);
        double radius = change.Radius(_sun, _view)
            + (factor.First.Radius * _incidence.Radius(_sun, _view))
            + (factor.Second.Radius * _emission.Radius(_sun, _view))
            + (factor.Third.Radius * _phase.Radius(_sun, _view));
        return new Interval(middle.Low - radius, middle.High + radius);
    }

    private static Vector3D ByHeights(FacetBand facet, Vector3D direction) => new(
        Vector3D.Dot(facet.Turns.A, direction), Vector3D.Dot(facet.Turns.B, direction), Vector3D.Dot(facet.Turns.C, direction));

    private static Vector3D Across(Vector3D vector, Vector3D axis) => vector - (Vector3D.Dot(vector, axis) * axis);
}
