using System.Runtime.Intrinsics;

namespace Msisf.Synthesis;

/// <summary>How much brighter a fresh crater makes the ground: by a halo of ejecta, and by rays, some of them short. Immutable.</summary>
/// <remarks>
/// Which craters: those of the last 750 Ma (S. C. Werner, S. Medvedev, EPSL 295 (2010), 147): N(&gt;D) = 6.3e-4 D^-3 for each km2, D in km,
/// by the rate of G. Neukum, B. A. Ivanov, W. K. Hartmann, Space Sci. Rev. 96 (2001), 55. That would be most of the small ones, whose rays
/// fade sooner; of these a tenth. Ejecta cover the ground up to 2.35 radii (H. J. Moore et al., Proc. Lunar Sci. Conf. 5 (1974), 71). Rays
/// are up to 6.59 R^1.27 long, both in km (J. R. Elliott et al., Icarus 312 (2018), 231, eq. 2). How bright and how many they are is chosen
/// by eye.
/// </remarks>
internal sealed class CraterRays
{
    /// <summary>Part of the small craters that has rays.</summary>
    public const double MostWithRays = 0.1;

    /// <summary>By how much a new crater's floor and rim are brighter than the ground.</summary>
    private const double Brightest = 0.7;

    /// <summary>Brightness of a ray at the rim, where that of the halo is 1.</summary>
    private const double RayBrightness = 0.7;

    private const ulong Purpose = 9;
    private const double YoungOfOneKilometre = 6.3e-10; // per m2
    private const double YoungExponent = 3.0;
    private const double OldestFreshnessLog2 = CraterPopulation.OldestFreshnessLog2;
    private const double HaloReach = 2.35; // radii
    private const double LengthOfOneKilometre = 6.59; // radii
    private const double LengthExponent = 0.27;
    private const int Rays = 9;
    private const double ShortestRay = 0.4; // of the longest
    private const double LeastWidth = 0.08; // radii
    private const double MostWidth = 0.35;
    private const double Widening = 0.05; // radii a radius
    private const double WithWidths = 1.1; // of the reach
    private const int Lanes = 4;

    private readonly Vector3D _centre;
    private readonly double _radius;
    private readonly double _reach;
    private readonly float _strength;
    private readonly Ray[] _rays = new Ray[Rays];

    /// <summary>Places the rays of a crater.</summary>
    /// <param name="crater">The crater.</param>
    /// <param name="freshFrom">From this freshness on craters like it have rays; it is fresher.</param>
    public CraterRays(in PlacedCrater crater, double freshFrom)
    {
        (_centre, _radius) = (crater.Direction, crater.Radius);
        _strength = (float)(Brightest * (crater.Freshness - freshFrom) / (1.0 - freshFrom));
        _reach = ReachOf(0.5 * crater.Diameter);
        SplitMix64 random = SplitMix64.For(
            0, Purpose, BitConverter.DoubleToInt64Bits(_centre.X), BitConverter.DoubleToInt64Bits(_centre.Z));
        Vector3D east = new Vector3D(-_centre.Y, _centre.X, 0.0).Normalized();
        Vector3D north = Vector3D.Cross(_centre, east);
        for (int i = 0; i < Rays; i++)
        {
            (double sin, double cos) = PortableMath.SinCosDegrees(360.0 * random.NextUniform());
            double length = LengthOf(random.NextUniform(), _reach);
            double width = LeastWidth + (random.NextUniform() * (MostWidth - LeastWidth));
            Vector3D along = (cos * east) + (sin * north);
            Vector3D middle = (_centre + (0.5 * (1.0 + length) * _radius * along)).Normalized();
            _rays[i] = new Ray(along, (cos * north) - (sin * east), middle, length, width);
        }
    }

    /// <summary>Part of the craters of a size that has rays: the freshest.</summary>
    /// <param name="diameter">m.</param>
    /// <param name="countAbove">Craters of this size and larger ones, per m2.</param>
    public static double ShareOf(double diameter, double countAbove) =>
        Math.Min(YoungOfOneKilometre * PortableMath.Pow(1e-3 * diameter, -YoungExponent) / countAbove, MostWithRays);

    /// <summary>Freshness from which on craters have rays, if a part of all has; its logarithm is uniform.</summary>
    public static double FreshFrom(double share) => PortableMath.Exp2(OldestFreshnessLog2 * share);

    /// <summary>
    /// Mean over all craters of the brightness of their rays, of which those of a new crater are 1, if a part of all has any.
    /// </summary>
    public static double MeanStrength(double share)
    {
        double from = FreshFrom(share);
        return ((1.0 - from) / (-OldestFreshnessLog2 * 0.69314718055994531) - (share * from)) / (1.0 - from);
    }

    /// <summary>How far a crater changes the ground's brightness, radii of the crater.</summary>
    /// <param name="radius">m.</param>
    public static double ReachOf(double radius) =>
        Math.Max(HaloReach, LengthOfOneKilometre * PortableMath.Pow(1e-3 * radius, LengthExponent));

    /// <summary>Integral over the area of what a new crater adds, m2, in the mean of all arrangements of its rays.</summary>
    /// <param name="radius">m.</param>
    public static double AreaOf(double radius)
    {
        const int Steps = 16;
        const double Beyond = HaloReach - 1.0;
        double area = Math.PI * (1.0 + (2.0 * ((Beyond / 3.0) + (Beyond * Beyond / 12.0))));
        for (int step = 0; step < Steps; step++)
        {
            // Across a ray of half width w the brightness (1 - (x/w)^2)^2 adds up to 16/15 w; along it that falls as 1 - s/length.
            double length = LengthOf((step + 0.5) / Steps, ReachOf(radius));
            double constant = (length - 1.0) * (length - 1.0) / (2.0 * length);
            double linear = (0.5 * ((length * length) - 1.0)) - (((length * length * length) - 1.0) / (3.0 * length));
            double across = (0.5 * (LeastWidth + MostWidth) * constant) + (Widening * linear);
            area += length > 1.0 ? RayBrightness * Rays / Steps * (16.0 / 15.0) * across : 0.0;
        }

        return Brightest * radius * radius * area;
    }

    /// <summary>Adds what the crater adds to the ground's brightness at the samples of a block that it reaches.</summary>
    /// <param name="frame">The block.</param>
    /// <param name="factors">As the frame's directions.</param>
    public void AddTo(MapFrame frame, Span<float> factors)
    {
        if (CraterStamp.Reached(_centre, WithWidths * _reach * _radius, frame) is null)
        {
            return;
        }

        Add(frame, null, _centre, HaloReach, factors);
        foreach (Ray ray in _rays)
        {
            Add(frame, ray, ray.Middle, (0.5 * (ray.Length - 1.0)) + ray.Width + (Widening * ray.Length), factors);
        }
    }

    private static double LengthOf(double random, double reach) => reach * (ShortestRay + (random * (1.0 - ShortestRay)));

    /// <summary>Brightness of the halo at four places; on the crater it is 1.</summary>
    private static Vector256<double> HaloAt(Vector256<double> x, Vector256<double> y, Vector256<double> z)
    {
        Vector256<double> one = Vector256<double>.One;
        Vector256<double> beyond = Vector256.Max(Vector256.Sqrt((x * x) + (y * y) + (z * z)) - one, Vector256<double>.Zero);
        Vector256<double> left = Vector256.Max(one - (beyond / (HaloReach - 1.0)), Vector256<double>.Zero);
        return left * left;
    }

    /// <summary>Adds the halo, or a ray.</summary>
    /// <param name="frame">The block.</param>
    /// <param name="ray">The ray; null for the halo.</param>
    /// <param name="middle">Its middle.</param>
    /// <param name="reach">Radii of the crater around it.</param>
    /// <param name="factors">As the frame's directions.</param>
    private void Add(MapFrame frame, Ray? ray, Vector3D middle, double reach, Span<float> factors)
    {
        if (CraterStamp.Reached(middle, reach * _radius, frame) is not { } reached)
        {
            return;
        }

        double perRadius = 1.0 / _radius;
        for (int line = reached.FirstLine; line <= reached.LastLine; line++)
        {
            for (int sample = reached.FirstSample / Lanes * Lanes; sample <= reached.LastSample; sample += Lanes)
            {
                int at = (line * frame.Stride) + sample;
                Vector256<double> x = (Vector256.Create(frame.X.AsSpan(at)) - Vector256.Create(_centre.X)) * perRadius;
                Vector256<double> y = (Vector256.Create(frame.Y.AsSpan(at)) - Vector256.Create(_centre.Y)) * perRadius;
                Vector256<double> z = (Vector256.Create(frame.Z.AsSpan(at)) - Vector256.Create(_centre.Z)) * perRadius;
                Vector256<double> added = ray is null ? HaloAt(x, y, z) : ray.BrightnessAt(x, y, z);
                Span<float> four = factors.Slice(at, Lanes);
                (Vector128.Create((ReadOnlySpan<float>)four)
                    + (_strength * Vector128.Narrow(added.GetLower(), added.GetUpper()))).CopyTo(four);
            }
        }
    }

    /// <summary>A ray from the rim outwards.</summary>
    /// <param name="Along">Direction in which it goes, length 1.</param>
    /// <param name="Across">At right angles to it on the ground.</param>
    /// <param name="Middle">Direction of its middle, length 1.</param>
    /// <param name="Length">Radii from the crater's centre.</param>
    /// <param name="Width">Half width, radii, without what it grows by.</param>
    private sealed record Ray(Vector3D Along, Vector3D Across, Vector3D Middle, double Length, double Width)
    {
        /// <summary>Brightness at four places, in radii from the crater's centre.</summary>
        public Vector256<double> BrightnessAt(Vector256<double> x, Vector256<double> y, Vector256<double> z)
        {
            Vector256<double> one = Vector256<double>.One;
            Vector256<double> along = (x * Along.X) + (y * Along.Y) + (z * Along.Z);
            Vector256<double> across = (x * Across.X) + (y * Across.Y) + (z * Across.Z);
            Vector256<double> width = Vector256.Create(Width) + (Widening * along);
            Vector256<double> left = Vector256.Max(one - (across * across / (width * width)), Vector256<double>.Zero);
            Vector256<double> fading = Vector256.Max(one - (along / Length), Vector256<double>.Zero) * RayBrightness;
            return Vector256.GreaterThan(along, one) & (left * left * fading);
        }
    }
}
