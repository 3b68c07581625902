namespace Msisf.Core.Preview;

/// <summary>How much of an area a function is positive on, from its values at the corners.</summary>
internal static class PositivePart
{
    /// <summary>The part of a triangle on which a linear function is not negative.</summary>
    /// <param name="a">Its value at a corner.</param>
    /// <param name="b">At another one.</param>
    /// <param name="c">At the third.</param>
    /// <returns>0 to 1; above 0 if one of the values is.</returns>
    public static double OfTriangle(double a, double b, double c) => ((a >= 0.0 ? 1 : 0) + (b >= 0.0 ? 1 : 0) + (c >= 0.0 ? 1 : 0)) switch
    {
        3 => 1.0,
        0 => 0.0,
        1 => a >= 0.0 ? AtCorner(a, b, c) : b >= 0.0 ? AtCorner(b, a, c) : AtCorner(c, a, b),
        _ => 1.0 - (a < 0.0 ? AtCorner(a, b, c) : b < 0.0 ? AtCorner(b, a, c) : AtCorner(c, a, b)),
    };

    /// <summary>The part on the side of the one corner whose value has another sign than the other two.</summary>
    private static double AtCorner(double corner, double other, double third) =>
        corner / (corner - other) * (corner / (corner - third));
}
