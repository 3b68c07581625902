namespace Msisf.Core.Sky;

/// <summary>The disc of a body of the sky: how bright each of its points is. Immutable.</summary>
/// <remarks>
/// A planet's and the Earth's are a Lambert sphere's, scaled to the whole body's magnitude. The Sun's limb is darkened as D. Hestroffer and
/// C. Magnan have it (Astron. Astrophys. 333 (1998) 338), I = mu^a with a = 0.5 in the visible.
/// </remarks>
public sealed class BodyDisc
{
    private const double LimbExponent = 0.5;

    private readonly Vector3D _centre;
    private readonly Vector3D _across;
    private readonly Vector3D _along; // the pole as it is seen
    private readonly double _flattening; // of the outline along the pole
    private readonly double _tangent;
    private readonly double _whole; // integral of the brightness over the disc, in squares of its radius
    private readonly Vector3D _toSun; // across, along, towards the observer
    private readonly bool _isSun;

    /// <summary>The disc as it is seen along some axes.</summary>
    /// <param name="place">The body.</param>
    /// <param name="centre">Direction of its centre, length 1.</param>
    /// <param name="turn">Turns a vector of J2000 into the axes of that direction.</param>
    public BodyDisc(BodyPlace place, Vector3D centre, Func<Vector3D, Vector3D> turn)
    {
        _centre = centre;
        _isSun = place.Body == SkyBody.Sun;
        Vector3D pole = turn(place.Body.PoleJ2000);
        Vector3D across = Vector3D.Cross(pole, centre);
        _across = (across.Length > 1e-9 ? across : Vector3D.Cross(Math.Abs(centre.X) < 0.9 ? Vector3D.UnitX : Vector3D.UnitY, centre))
            .Normalized();
        _along = Vector3D.Cross(centre, _across);
        double sine = Vector3D.Dot(pole, centre);
        double ratio = place.Body.PolarRadius / place.Body.EquatorialRadius;
        _flattening = Math.Sqrt((sine * sine) + (ratio * ratio * (1.0 - (sine * sine))));
        _tangent = Math.Tan(place.AngularRadius);
        Vector3D sun = turn(place.ToSunJ2000);
        _toSun = new Vector3D(Vector3D.Dot(sun, _across), Vector3D.Dot(sun, _along), -Vector3D.Dot(sun, _centre));
        double phase = place.Phase;
        _whole = _flattening * (_isSun
            ? Math.PI / (1.0 + (0.5 * LimbExponent))
            : 2.0 / 3.0 * (Trigonometry.Sin(phase) + ((Math.PI - phase) * Trigonometry.Cos(phase))));
    }

    /// <summary>Whether the disc, its lit part or the rest, lies in a direction.</summary>
    /// <param name="direction">Length 1.</param>
    public bool Covers(Vector3D direction)
    {
        double cosine = Vector3D.Dot(direction, _centre);
        return cosine > 0.0 && PlaceOf(direction, cosine) is var (u, v) && (u * u) + (v * v) < 1.0;
    }

    /// <summary>Part of the whole body's light that comes from a direction, per steradian; 0 beside the disc.</summary>
    /// <param name="direction">Length 1.</param>
    public double LightFrom(Vector3D direction)
    {
        double cosine = Vector3D.Dot(direction, _centre);
        if (cosine <= 0.0)
        {
            return 0.0;
        }

        (double u, double v) = PlaceOf(direction, cosine);
        double square = 1.0 - (u * u) - (v * v);
        if (square <= 0.0)
        {
            return 0.0;
        }

        double emission = Math.Sqrt(square);
        double brightness = _isSun
            ? Math.Pow(emission, LimbExponent)
            : Math.Max(0.0, (u * _toSun.X) + (v * _toSun.Y) + (emission * _toSun.Z));
        return brightness / (_whole * _tangent * _tangent * cosine * cosine * cosine);
    }

    /// <summary>Where a direction meets the disc, in its radii: across, and along the pole in those of its flattened outline.</summary>
    private (double Across, double Along) PlaceOf(Vector3D direction, double cosine) =>
        (Vector3D.Dot(direction, _across) / (cosine * _tangent), Vector3D.Dot(direction, _along) / (cosine * _tangent * _flattening));
}
