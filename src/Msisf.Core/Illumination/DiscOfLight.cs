using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Illumination;

/// <summary>
/// The disc of the Sun or the Earth in upright strips: how much of it, and of its light, is over a horizon, at sixteen steps at once.
/// Immutable.
/// </summary>
/// <remarks>
/// The Sun's limb darkening is that of H. Neckel, Solar Phys. 229 (2005) 13, for 700 nm, below which lies half of the Sun's energy:
/// the sum of A_i mu^i with mu the cosine of the angle from the surface's normal.
/// </remarks>
internal sealed class DiscOfLight
{
    /// <summary>Strips of a disc at most.</summary>
    private const int MaxStrips = 64;

    /// <summary>um: the wavelength of <see cref="Darkening"/>.</summary>
    private const double Wavelength = 0.7;

    /// <summary>Nodes, in the square of the place along a strip, of the polynomials of the mean light from its middle on.</summary>
    private const int Nodes = 6;

    private readonly float[] _offsets;
    private readonly float[] _halves;
    private readonly float[] _perHalfSquare;
    private readonly float[] _moments;
    private readonly float[] _nodes = new float[Nodes];
    private readonly float[] _newton;
    private readonly float[] _ups;
    private readonly float _perArea;

    /// <summary>Makes a disc.</summary>
    /// <param name="strips">How many strips it has, an even number.</param>
    /// <param name="isDarkened">Whether it is the Sun, which is darker at its limb.</param>
    public DiscOfLight(int strips, bool isDarkened)
    {
        double[] factors = isDarkened ? Darkening() : [1.0];
        double[] nodes = [.. Enumerable.Range(0, Nodes).Select(node => 0.5 - (0.5 * Math.Cos(Math.PI * (node + 0.5) / Nodes)))];
        double[] means = new double[strips * Nodes];
        double[] ups = new double[Nodes];
        (_offsets, _halves, _perHalfSquare) = (new float[strips], new float[strips], new float[strips]);
        (double whole, double summed) = (0.0, 0.0);
        for (int strip = 0; strip < strips; strip++)
        {
            // From the middle outwards, to the right and left in turn.
            double offset = ((strip / 2) + 0.5) / strips * (strip % 2 == 0 ? 2.0 : -2.0);
            double half = HalfOf(offset, 1.0 / strips);
            (_offsets[strip], _halves[strip], _perHalfSquare[strip]) = ((float)offset, (float)half, (float)(1.0 / (half * half)));
            whole += 2.0 * half * MeanTo(1.0, half, factors);
            Span<double> differences = means.AsSpan(strip * Nodes, Nodes);
            for (int node = 0; node < Nodes; node++)
            {
                double end = Math.Sqrt(nodes[node]);
                differences[node] = MeanTo(end, half, factors);

                // The light over a level, times its height over it, and half the level for all of the light: an even function of it.
                double level = Math.Min(end, half);
                ups[node] += MomentOver(Math.Sqrt((half - level) * (half + level)), factors)
                    + (level * level * MeanTo(level / half, half, factors)) + ((end - level) * half * MeanTo(1.0, half, factors));
            }

            ToDifferences(differences, nodes);
            summed += 2.0 * half * ValueAt(1.0, differences, nodes);
        }

        ToDifferences(ups, nodes);
        _newton = [.. means.Select(mean => (float)(mean / summed))]; // so that all of the disc gives 1
        _ups = [.. ups.Select(up => (float)(up / whole))];
        _nodes = [.. nodes.Select(node => (float)node)];
        _moments = [.. factors.Select((factor, power) => (float)(factor / ((power + 2) * whole)))];
        _perArea = (float)(2.0 / (strips * Math.PI));
    }

    /// <summary>The light of the whole disc on a horizontal plane: what is above the plane, times the sine of its elevation.</summary>
    /// <param name="sine">Sine of the elevation of the disc's middle.</param>
    /// <param name="slope">Tangent of the disc's angular radius.</param>
    public Vector512<float> UpOf(Vector512<float> sine, Vector512<float> slope)
    {
        Vector512<float> up = Vector512.MaxNative(sine, Vector512<float>.Zero);
        Vector512<float> isThrough = Vector512.LessThan(Vector512.Abs(sine), slope); // the plane passes through the disc
        if (!Vector512.LessThanAny(Vector512.Abs(sine), slope))
        {
            return up;
        }

        Vector512<float> level = sine / slope;
        Vector512<float> even = ValueAt(level * level, _ups);
        return Vector512.ConditionalSelect(isThrough, (0.5f * sine) + (slope * even), up);
    }

    /// <summary>The part of the disc's area that is over a horizon, 0 to 1.</summary>
    /// <param name="table">The horizon.</param>
    /// <param name="seen">The discs.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public Vector512<float> AreaOver(HorizonTable table, in SeenBody seen)
    {
        Vector512<float> sum = Vector512<float>.Zero;
        for (int strip = 0; strip < _offsets.Length; strip++)
        {
            sum += Shown(seen.HeightOf(seen.TangentAt(table, _offsets[strip])), Vector512.Create(_halves[strip]));
        }

        return AreaOf(sum);
    }

    /// <summary>Whether any, and whether all of the disc is over a horizon; strips that are only touched by it do not count.</summary>
    /// <param name="table">The horizon.</param>
    /// <param name="seen">The discs.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public (uint Whole, uint Any) SeeOver(HorizonTable table, in SeenBody seen)
    {
        const uint All = 0xFFFF;
        (uint whole, uint any) = (All, 0);
        for (int strip = 0; strip < _offsets.Length && (whole != 0 || any != All); strip++)
        {
            Vector512<float> half = Vector512.Create(_halves[strip]);
            Vector512<float> horizon = seen.HeightOf(seen.TangentAt(table, _offsets[strip]));
            whole &= (uint)Vector512.LessThanOrEqual(horizon, -half).ExtractMostSignificantBits();
            any |= (uint)Vector512.LessThan(horizon, half).ExtractMostSignificantBits();
        }

        return (whole, any);
    }

    /// <summary>The parts of the disc's area and light over a horizon.</summary>
    /// <param name="table">The horizon.</param>
    /// <param name="seen">The discs.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public DiscParts Over(HorizonTable table, in SeenBody seen)
    {
        Vector512<float> level = -seen.Tangent / seen.Slope;
        (Vector512<float> area, Vector512<float> below) = (Vector512<float>.Zero, Vector512<float>.Zero);
        (Vector512<float> belowLevel, Vector512<float> moment) = (Vector512<float>.Zero, Vector512<float>.Zero);
        Span<Vector512<float>> tangents = stackalloc Vector512<float>[MaxStrips];
        for (int strip = 0; strip < _offsets.Length; strip++)
        {
            tangents[strip] = seen.TangentAt(table, _offsets[strip]);
        }

        for (int strip = 0; strip < _offsets.Length; strip++)
        {
            Vector512<float> half = Vector512.Create(_halves[strip]);
            ReadOnlySpan<float> means = _newton.AsSpan(strip * Nodes, Nodes);
            Vector512<float> horizon = seen.HeightOf(tangents[strip]);
            area += Shown(horizon, half);
            Vector512<float> up = Vector512.MinNative(Vector512.MaxNative(horizon, -half), half);
            Vector512<float> perSquare = Vector512.Create(_perHalfSquare[strip]);
            below += up * ValueAt(up * up * perSquare, means);
            up = Vector512.MinNative(Vector512.MaxNative(up, level), half);
            Vector512<float> square = up * up * perSquare;
            belowLevel += up * ValueAt(square, means);
            moment += MomentOver(half * Vector512.Sqrt(Vector512.MaxNative(Vector512<float>.One - square, Vector512<float>.Zero)));
        }

        Vector512<float> middle = Vector512.Create(0.5f);
        Vector512<float> above = (middle - belowLevel) * seen.Tangent;
        return new DiscParts(
            AreaOf(area), Vector512.MinNative(Vector512.MaxNative(middle - below, Vector512<float>.Zero), Vector512<float>.One),
            Vector512.MaxNative(Vector512<float>.Zero, (above + (moment * seen.Slope)) / seen.PerCosine));
    }

    private static Vector512<float> Shown(Vector512<float> horizon, Vector512<float> half) =>
        Vector512.MinNative(Vector512.MaxNative(half - horizon, Vector512<float>.Zero), half + half);

    private Vector512<float> AreaOf(Vector512<float> sum) => Vector512.MinNative(Vector512<float>.One, sum * Vector512.Create(_perArea));

    /// <summary>The value of Newton's polynomial at squares.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private Vector512<float> ValueAt(Vector512<float> square, ReadOnlySpan<float> differences)
    {
        Vector512<float> value = Vector512.Create(differences[Nodes - 1]);
        for (int node = Nodes - 2; node >= 0; node--)
        {
            value = Vector512.Create(differences[node]) + ((square - Vector512.Create(_nodes[node])) * value);
        }

        return value;
    }

    /// <summary>
    /// Sum of the light times its height above a place with a mu, in a closed form: of each power of mu, times the height, the integral is
    /// one of the next power but one.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private Vector512<float> MomentOver(Vector512<float> mu)
    {
        Vector512<float> moment = Vector512.Create(_moments[^1]);
        for (int power = _moments.Length - 2; power >= 0; power--)
        {
            moment = (moment * mu) + Vector512.Create(_moments[power]);
        }

        return moment * mu * mu;
    }

    /// <summary>Half the mean height of a strip in radii: that of the disc across it.</summary>
    private static double HalfOf(double offset, double halfWidth)
    {
        return (Chord(offset + halfWidth) - Chord(offset - halfWidth)) / (2.0 * halfWidth);

        static double Chord(double x)
        {
            double up = Math.Sqrt(Math.Max(0.0, 1.0 - (x * x)));
            return 0.5 * ((x * up) + Math.Atan2(x, up));
        }
    }

    /// <summary>Mean light along a strip from its middle to a part of its half height; mu is half sqrt(1 - u^2).</summary>
    private static double MeanTo(double end, double half, double[] factors)
    {
        double root = Math.Sqrt((1.0 - end) * (1.0 + end));
        double integral = end;                                              // of mu^0, mu^2, ...
        double other = 0.5 * (Math.Atan2(end, root) + (end * root));        // of mu^1, mu^3, ...
        (double sum, double scale) = (0.0, 1.0);
        for (int power = 0; power < factors.Length; power++)
        {
            sum += factors[power] * scale * integral;
            double next = ((end * Math.Pow(root, power + 2)) + ((power + 2) * integral)) / (power + 3);
            (integral, other) = (other, next);
            scale *= half;
        }

        return sum / end;
    }

    /// <summary>Light times height along a strip above a place with a mu.</summary>
    private static double MomentOver(double mu, double[] factors) =>
        factors.Select((factor, power) => factor * Math.Pow(mu, power + 2) / (power + 2)).Sum();

    /// <summary>Turns values at nodes into the divided differences of Newton's polynomial through them.</summary>
    private static void ToDifferences(Span<double> values, double[] nodes)
    {
        for (int order = 1; order < Nodes; order++)
        {
            for (int node = Nodes - 1; node >= order; node--)
            {
                values[node] = (values[node] - values[node - 1]) / (nodes[node] - nodes[node - order]);
            }
        }
    }

    private static double ValueAt(double square, ReadOnlySpan<double> differences, double[] nodes)
    {
        double value = 0.0;
        for (int node = Nodes - 1; node >= 0; node--)
        {
            value = differences[node] + ((square - nodes[node]) * value);
        }

        return value;
    }

    /// <summary>Factors of the powers of mu.</summary>
    private static double[] Darkening()
    {
        double first = 1.0 / Wavelength;
        double fifth = Math.Pow(Wavelength, -5.0);
        return
        [
            0.75267 - (0.265577 * first), 0.93874 + (0.265577 * first) - (0.004095 * fifth), -1.89287 + (0.012582 * fifth),
            2.42234 - (0.017117 * fifth), -1.71150 + (0.011977 * fifth), 0.49062 - (0.003347 * fifth),
        ];
    }
}

/// <summary>Parts of a disc over a horizon, at sixteen steps.</summary>
/// <param name="Area">0 to 1, of its area.</param>
/// <param name="Light">0 to 1, of its light.</param>
/// <param name="Up">Its light on a horizontal plane: that which is above the plane, times the sine of its elevation.</param>
internal readonly record struct DiscParts(Vector512<float> Area, Vector512<float> Light, Vector512<float> Up);
