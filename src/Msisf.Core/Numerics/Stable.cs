namespace Msisf.Core.Numerics;

/// <summary>Sums and products that keep their digits where the plain formula cancels.</summary>
public static class Stable
{
    /// <summary>a * b - c * d within 1.5 units in the last place, for any cancellation.</summary>
    /// <remarks>Kahan's algorithm; C.-P. Jeannerod, N. Louvet, J.-M. Muller, Math. Comp. 82 (2013).</remarks>
    public static double DifferenceOfProducts(double a, double b, double c, double d)
    {
        double cd = c * d;
        double error = Math.FusedMultiplyAdd(-c, d, cd);
        double difference = Math.FusedMultiplyAdd(a, b, -cd);
        return difference + error;
    }
}
