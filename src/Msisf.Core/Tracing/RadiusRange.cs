namespace Msisf.Core.Tracing;

/// <summary>Minimum and maximum vertex radius of a block, m; floats that were rounded outwards.</summary>
/// <param name="Min">m.</param>
/// <param name="Max">m.</param>
internal readonly record struct RadiusRange(float Min, float Max)
{
    /// <summary>The range that holds no radius.</summary>
    public static RadiusRange Empty => new(float.PositiveInfinity, float.NegativeInfinity);

    /// <summary>Rounds outwards.</summary>
    public static RadiusRange Around(double min, double max) =>
        new(MathF.BitDecrement((float)min), MathF.BitIncrement((float)max));

    /// <summary>The range that holds a radius too.</summary>
    public RadiusRange With(double radius) => new(
        Math.Min(Min, MathF.BitDecrement((float)radius)), Math.Max(Max, MathF.BitIncrement((float)radius)));

    /// <summary>The range that holds both.</summary>
    public RadiusRange With(RadiusRange other) => new(Math.Min(Min, other.Min), Math.Max(Max, other.Max));
}
