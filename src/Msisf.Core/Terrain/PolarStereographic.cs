namespace Msisf.Core.Terrain;

/// <summary>
/// The polar stereographic projection of LOLA's products on the sphere of <see cref="MoonConstants.ReferenceRadius"/> R, true to scale at
/// the pole. With rho = 2 R tan((90 - |latitude|) / 2), X = rho sin(longitude), Y = rho cos(longitude): sample = SampleOffset + X / scale;
/// line = LineOffset - Y / scale at the south pole, LineOffset + Y / scale at the north pole. The map is as seen from outside.
/// </summary>
/// <remarks>
/// The direction of (X, Y) needs no trigonometry: with a = X / R, b = Y / R and s = (a a + b b) / 4 it is (b, a, +-(1 - s)) / (1 + s).
/// </remarks>
/// <param name="IsSouth">Whether the middle of the map is the south pole.</param>
/// <param name="MetresPerPixel">MAP_SCALE: m a pixel at the pole.</param>
/// <param name="LineOffset">Line of the pole, from 0 for the centre of the top line.</param>
/// <param name="SampleOffset">Sample of the pole, from 0 for the centre of the leftmost sample.</param>
public sealed record PolarStereographic(bool IsSouth, double MetresPerPixel, double LineOffset, double SampleOffset) : MapProjection
{
    /// <summary>
    /// Radii of the Moon: X and Y of all samples are within this of the pole (37 degrees of latitude in the middle of a map's edge); the
    /// bounds of <c>PlaneBorder</c> rest on it.
    /// </summary>
    public const double MaxExtent = 1.0;

    /// <summary>
    /// Where the middle of the map lies: 0 at a pole of the Moon, 1 at longitude 0 (of a southern map 180) on the equator, 2 at
    /// longitude 90 (270). The axes x, y, z above are then y, z, x or z, x, y of MOON_ME.
    /// </summary>
    public int Turn { get; init; }

    /// <inheritdoc/>
    public override GridResolution Resolution => GridResolution.FromMetresPerPixel(MetresPerPixel);

    /// <summary>Sine of the pole's latitude: -1 or 1.</summary>
    public double PoleSign => IsSouth ? -1.0 : 1.0;

    /// <summary>Turns the axes of the map, of which the third goes through its middle, to those of MOON_ME.</summary>
    public Vector3D ToBodyFixed(Vector3D inMap) => Turn switch
    {
        1 => new Vector3D(inMap.Z, inMap.X, inMap.Y),
        2 => new Vector3D(inMap.Y, inMap.Z, inMap.X),
        _ => inMap,
    };

    /// <summary>Turns the axes of MOON_ME to those of the map.</summary>
    public Vector3D ToMap(Vector3D moonMe) => Turn switch
    {
        1 => new Vector3D(moonMe.Y, moonMe.Z, moonMe.X),
        2 => new Vector3D(moonMe.Z, moonMe.X, moonMe.Y),
        _ => moonMe,
    };

    /// <summary>X / R of a sample.</summary>
    public double A(double sample) => (sample - SampleOffset) * MetresPerPixel / MoonConstants.ReferenceRadius;

    /// <summary>Y / R of a line.</summary>
    public double B(double line) => PoleSign * (line - LineOffset) * MetresPerPixel / MoonConstants.ReferenceRadius;

    /// <inheritdoc/>
    public override MapProjection Halved() => this with
    {
        MetresPerPixel = 2.0 * MetresPerPixel,
        LineOffset = 0.5 * (LineOffset - 0.5),
        SampleOffset = 0.5 * (SampleOffset - 0.5),
    };

    /// <inheritdoc/>
    public override Vector3D DirectionOf(double line, double sample)
    {
        double a = A(sample);
        double b = B(line);
        double s = 0.25 * ((a * a) + (b * b));
        double f = 1.0 / (1.0 + s);
        return ToBodyFixed(new Vector3D(f * b, f * a, PoleSign * (f * (1.0 - s))));
    }

    /// <inheritdoc/>
    public override (double Line, double Sample) PixelOf(Vector3D directionBodyFixed)
    {
        // The other pole lies at infinity, where no pixel is.
        Vector3D direction = ToMap(directionBodyFixed).Normalized();
        double f = 2.0 * MoonConstants.ReferenceRadius / MetresPerPixel / (1.0 + (PoleSign * direction.Z));
        return (LineOffset + (PoleSign * f * direction.X), SampleOffset + (f * direction.Y));
    }

    /// <summary>Whether a grid of a size from this projection's first pixel on stays within <see cref="MaxExtent"/>.</summary>
    /// <param name="samples">Number of samples of a line.</param>
    public bool Holds(int lines, int samples) =>
        Math.Max(Math.Max(Math.Abs(A(0)), Math.Abs(A(samples - 1))), Math.Max(Math.Abs(B(0)), Math.Abs(B(lines - 1)))) <= MaxExtent;
}
