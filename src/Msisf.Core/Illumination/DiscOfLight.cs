using System.Runtime.Intrinsics;

namespace Msisf.Core.Illumination;

/// <summary>
/// The disc of the Sun or the Earth in sixteen upright strips: how much of it, and of its light, stands over a horizon. Immutable.
/// </summary>
/// <remarks>
/// The Sun's limb darkening is that of H. Neckel, Solar Phys. 229 (2005) 13, for 700 nm, below which lies half of the Sun's energy:
/// the sum of A_i mu^i with mu the cosine of the angle from the surface's normal.
/// </remarks>
internal sealed class DiscOfLight
{
    /// <summary>Strips of a disc: the lanes of a vector.</summary>
    public const int Strips = 16;

    /// <summary>um: the wavelength of <see cref="Darkening"/>.</summary>
    private const double Wavelength = 0.7;

    /// <summary>Nodes, in the square of the place along a strip, of the polynomials of the mean light from its middle on.</summary>
    private const int Nodes = 6;

    private readonly float[] _offsets = new float[Strips];
    private readonly float[] _halves = new float[Strips];
    private readonly float[] _perHalfSquare = new float[Strips];
    private readonly float[] _moments;
    private readonly float[] _nodes = new float[Nodes];
    private readonly float[] _newton = new float[Nodes * Strips];
    private readonly float _perArea;

    /// <summary>Makes a disc.</summary>
    /// <param name="isDarkened">Whether it is the Sun, which is darker at its limb.</param>
    /// <param name="part">Which of a number of parts it is, from 0: each has every so manieth strip of so many times as many.</param>
    /// <param name="parts">How many there are.</param>
    public DiscOfLight(bool isDarkened, int part = 0, int parts = 1)
    {
        double[] factors = isDarkened ? Darkening() : [1.0];
        double[] nodes = [.. Enumerable.Range(0, Nodes).Select(node => 0.5 - (0.5 * Math.Cos(Math.PI * (node + 0.5) / Nodes)))];
        double[] means = new double[Strips * Nodes];
        double whole = 0.0;
        for (int strip = 0; strip < Strips; strip++)
        {
            double offset = ((strip + ((part + 0.5) / parts)) / Strips * 2.0) - 1.0;
            double half = HalfOf(offset, 1.0 / (Strips * parts));
            (_offsets[strip], _halves[strip], _perHalfSquare[strip]) = ((float)offset, (float)half, (float)(1.0 / (half * half)));
            whole += 2.0 * half * parts * MeanTo(1.0, half, factors);

            // Divided differences: Newton's polynomial through the nodes.
            Span<double> differences = means.AsSpan(strip * Nodes, Nodes);
            for (int node = 0; node < Nodes; node++)
            {
                differences[node] = MeanTo(Math.Sqrt(nodes[node]), half, factors);
            }

            for (int order = 1; order < Nodes; order++)
            {
                for (int node = Nodes - 1; node >= order; node--)
                {
                    differences[node] = (differences[node] - differences[node - 1]) / (nodes[node] - nodes[node - order]);
                }
            }
        }

        for (int i = 0; i < means.Length; i++)
        {
            _newton[(i % Nodes * Strips) + (i / Nodes)] = (float)(means[i] / whole);
        }

        _nodes = [.. nodes.Select(node => (float)node)];
        _moments = [.. factors.Select((factor, power) => (float)(factor / ((power + 2) * whole)))];
        _perArea = (float)(2.0 / (Strips * parts * Math.PI));
    }

    /// <summary>Places of the strips across the disc, -1 to 1.</summary>
    public Vector512<float> Offsets => Vector512.LoadUnsafe(ref _offsets[0]);

    /// <summary>The part of the disc that stands over a horizon.</summary>
    /// <param name="horizon">For each strip the horizon's height over the disc's middle, in radii.</param>
    /// <returns>0 to 1, of the area.</returns>
    public float AreaOver(Vector512<float> horizon)
    {
        Vector512<float> half = Vector512.LoadUnsafe(ref _halves[0]);
        Vector512<float> over = Vector512.MinNative(Vector512.MaxNative(half - horizon, Vector512<float>.Zero), half + half);
        return Math.Min(1.0f, Vector512.Sum(over) * _perArea);
    }

    /// <summary>The part of the disc's light over a horizon.</summary>
    /// <param name="horizon">As with <see cref="AreaOver"/>.</param>
    /// <returns>0 to 1; and the sum of the light times its height over the disc's middle in radii.</returns>
    public (float Light, float Moment) LightOver(Vector512<float> horizon)
    {
        Vector512<float> half = Vector512.LoadUnsafe(ref _halves[0]);
        Vector512<float> one = Vector512<float>.One;
        Vector512<float> up = Vector512.MinNative(Vector512.MaxNative(horizon, -half), half);
        Vector512<float> square = up * up * Vector512.LoadUnsafe(ref _perHalfSquare[0]);
        Vector512<float> below = Vector512.LoadUnsafe(ref _newton[(Nodes - 1) * Strips]);
        for (int node = Nodes - 2; node >= 0; node--)
        {
            below = Vector512.LoadUnsafe(ref _newton[node * Strips]) + ((square - Vector512.Create(_nodes[node])) * below);
        }

        // The moment is known in a closed form: of each power of mu, times the height, the integral is one of the next power but one.
        Vector512<float> mu = half * Vector512.Sqrt(Vector512.MaxNative(one - square, Vector512<float>.Zero));
        Vector512<float> moment = Vector512.Create(_moments[^1]);
        for (int power = _moments.Length - 2; power >= 0; power--)
        {
            moment = (moment * mu) + Vector512.Create(_moments[power]);
        }

        return (0.5f - Vector512.Sum(up * below), Vector512.Sum(moment * mu * mu));
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
