namespace Msisf.Core.Numerics;

/// <summary>How states between samples are found; <c>default</c> is linear.</summary>
/// <param name="Method">The kind of polynomial.</param>
/// <param name="Degree">Its degree, from 1.</param>
public readonly record struct Interpolation(InterpolationMethod Method, int Degree)
{
    /// <summary>How many samples the polynomial goes through.</summary>
    public int Samples => Method switch
    {
        InterpolationMethod.Hermite => (Degree + 1) / 2,
        InterpolationMethod.Lagrange => Degree + 1,
        _ => 2,
    };

    /// <summary>"HERMITE 7", as CCSDS files name it.</summary>
    public override string ToString() =>
        Invariant($"{Method.ToString().ToUpperInvariant()} {(Method == default ? 1 : Degree)}");
}

/// <summary>The kind of polynomial between samples.</summary>
public enum InterpolationMethod
{
    /// <summary>A straight line between neighbours; of attitudes, a turn at a constant rate. The default.</summary>
    Linear,

    /// <summary>Through the values.</summary>
    Lagrange,

    /// <summary>Through the values, with the given derivatives.</summary>
    Hermite,
}
