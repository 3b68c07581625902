namespace Msisf.Core.Numerics;

/// <summary>
/// A short sequence of random numbers that belongs to a place: the same seed and keys give the same numbers, in whatever order places are
/// visited. <c>default</c> is the sequence of state 0.
/// </summary>
/// <remarks>G. L. Steele, D. Lea, C. H. Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014.</remarks>
internal struct SplitMix64
{
    private const ulong Step = 0x9E37_79B9_7F4A_7C15;

    private ulong _state;

    private SplitMix64(ulong state) => _state = state;

    /// <summary>The sequence of one place.</summary>
    /// <param name="seed">The user's seed.</param>
    /// <param name="purpose">What the numbers are for; keeps the uses of one seed apart.</param>
    /// <param name="row">First key of the place.</param>
    /// <param name="column">Second key of the place.</param>
    public static SplitMix64 For(ulong seed, ulong purpose, long row, long column)
    {
        ulong hash = Mix(seed + Step);
        hash = Mix(hash ^ (purpose * Step));
        hash = Mix(hash ^ ((ulong)row * 0xD6E8_FEB8_6659_FD93));
        hash = Mix(hash ^ ((ulong)column * 0xA076_1D64_78BD_642F));
        return new SplitMix64(hash);
    }

    /// <summary>64 random bits.</summary>
    public ulong NextBits()
    {
        _state += Step;
        return Mix(_state);
    }

    /// <summary>A number in [0, 1), a multiple of 2^-53.</summary>
    public double NextUniform() => (NextBits() >> 11) * (1.0 / (1UL << 53));

    private static ulong Mix(ulong z)
    {
        z = (z ^ (z >> 30)) * 0xBF58_476D_1CE4_E5B9;
        z = (z ^ (z >> 27)) * 0x94D0_49BB_1331_11EB;
        return z ^ (z >> 31);
    }
}
