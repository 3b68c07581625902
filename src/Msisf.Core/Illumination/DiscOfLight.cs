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

    /// <summary>Steps of the table of a strip's light, from its lower to its upper end.</summary>
    private const int Steps = 64;

    /// <summary>um: the wavelength of <see cref="Darkening"/>.</summary>
    private const double Wavelength = 0.7;

    private readonly float _perArea;
    private readonly float[] _offsets = new float[Strips];
    private readonly float[] _halves = new float[Strips];
    private readonly float[] _light = new float[Strips * (Steps + 1)];
    private readonly float[] _moment = new float[Strips * (Steps + 1)];

    /// <summary>Makes a disc.</summary>
    /// <param name="isDarkened">Whether it is the Sun, which is darker at its limb.</param>
    public DiscOfLight(bool isDarkened)
    {
        const int Parts = 16; // of a step, for the sums
        double whole = 0.0;
        double[] light = new double[_light.Length];
        double[] moment = new double[_light.Length];
        for (int strip = 0; strip < Strips; strip++)
        {
            double offset = ((strip + 0.5) / Strips * 2.0) - 1.0;
            double half = HalfOf(offset);
            (_offsets[strip], _halves[strip]) = ((float)offset, (float)half);
            for (int step = Steps - 1; step >= 0; step--)
            {
                int at = (strip * (Steps + 1)) + step;
                (light[at], moment[at]) = (light[at + 1], moment[at + 1]);
                for (int part = 0; part < Parts; part++)
                {
                    double up = half * (((step + ((part + 0.5) / Parts)) / Steps * 2.0) - 1.0);
                    double height = 2.0 * half / (Steps * Parts) * (isDarkened ? Darkening((offset * offset) + (up * up)) : 1.0);
                    light[at] += height;
                    moment[at] += height * up;
                }
            }

            whole += light[strip * (Steps + 1)];
        }

        _perArea = 1.0f / (2.0f * _halves.Sum());
        for (int i = 0; i < light.Length; i++)
        {
            (_light[i], _moment[i]) = ((float)(light[i] / whole), (float)(moment[i] / whole));
        }
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
        Vector512<float> place = Vector512.MinNative(
            Vector512.MaxNative((horizon + half) * (Vector512.Create(0.5f * Steps) / half), Vector512<float>.Zero),
            Vector512.Create((float)Steps));
        (float light, float moment) = (0.0f, 0.0f);
        for (int strip = 0; strip < Strips; strip++)
        {
            int step = Math.Min((int)place[strip], Steps - 1);
            float rest = place[strip] - step;
            int at = (strip * (Steps + 1)) + step;
            light += _light[at] + (rest * (_light[at + 1] - _light[at]));
            moment += _moment[at] + (rest * (_moment[at + 1] - _moment[at]));
        }

        return (light, moment);
    }

    /// <summary>Half the mean height of a strip in radii: that of the disc across it.</summary>
    private static double HalfOf(double offset)
    {
        const double Width = 1.0 / Strips;
        return (Chord(offset + Width) - Chord(offset - Width)) / (2.0 * Width);

        static double Chord(double x)
        {
            double up = Math.Sqrt(Math.Max(0.0, 1.0 - (x * x)));
            return 0.5 * ((x * up) + Math.Atan2(x, up));
        }
    }

    private static double Darkening(double squaredRadius)
    {
        double mu = Math.Sqrt(Math.Max(0.0, 1.0 - squaredRadius));
        double first = 1.0 / Wavelength;
        double fifth = Math.Pow(Wavelength, -5.0);
        double[] factors =
        [
            0.75267 - (0.265577 * first), 0.93874 + (0.265577 * first) - (0.004095 * fifth), -1.89287 + (0.012582 * fifth),
            2.42234 - (0.017117 * fifth), -1.71150 + (0.011977 * fifth), 0.49062 - (0.003347 * fifth),
        ];
        double sum = 0.0;
        for (int power = factors.Length - 1; power >= 0; power--)
        {
            sum = (sum * mu) + factors[power];
        }

        return sum;
    }
}
