using Msisf.Core.Numerics;

namespace Msisf.Stress;

/// <summary>
/// Random numbers with all bits of a double, the same on every machine. Not safe for several threads: each part of the cases has its own.
/// </summary>
public sealed class CaseRandom
{
    private SplitMix64 _bits;

    /// <summary>The numbers of one part of a test's cases.</summary>
    /// <param name="seed">As given to <see cref="IStressTest.Run"/>.</param>
    /// <param name="part">Number of the part; parts have nothing in common.</param>
    public CaseRandom(int seed, int part) => _bits = SplitMix64.For((ulong)seed, purpose: 0, part, 0);

    /// <summary>In [0, 1).</summary>
    public double Unit() => _bits.NextUniform();

    /// <summary>Whole, in [0, <paramref name="count"/>).</summary>
    public int Below(int count) => (int)(Unit() * count);

    /// <summary>Evenly from one bound to the other.</summary>
    public double Between(double from, double to) => from + ((to - from) * Unit());

    /// <summary>Evenly in the logarithm; both bounds are above 0.</summary>
    public double Logarithmic(double from, double to) => Math.Exp(Between(Math.Log(from), Math.Log(to)));

    /// <summary>1 or -1.</summary>
    public double Sign() => Unit() < 0.5 ? 1.0 : -1.0;

    /// <summary>Evenly on the unit sphere.</summary>
    public Vector3D Direction()
    {
        double z = Between(-1.0, 1.0);
        (double sin, double cos) = Math.SinCos(Between(-Math.PI, Math.PI));
        double horizontal = Math.Sqrt((1.0 - z) * (1.0 + z));
        return new Vector3D(horizontal * cos, horizontal * sin, z);
    }

    /// <summary>Evenly of all attitudes.</summary>
    /// <remarks>K. Shoemake, "Uniform random rotations", Graphics Gems III (1992).</remarks>
    public UnitQuaternion Attitude()
    {
        double share = Unit();
        (double sinFirst, double cosFirst) = Math.SinCos(Between(-Math.PI, Math.PI));
        (double sinSecond, double cosSecond) = Math.SinCos(Between(-Math.PI, Math.PI));
        double first = Math.Sqrt(1.0 - share);
        double second = Math.Sqrt(share);
        return UnitQuaternion.FromComponents(first * sinFirst, first * cosFirst, second * sinSecond, second * cosSecond);
    }
}
