namespace Msisf.Core.Render.Tracing;

/// <summary>Least and greatest vertex radius of a block, m; floats that were rounded outwards.</summary>
/// <param name="Least">m.</param>
/// <param name="Greatest">m.</param>
internal readonly record struct RadiusRange(float Least, float Greatest)
{
    /// <summary>The range that holds no radius.</summary>
    public static RadiusRange Empty => new(float.PositiveInfinity, float.NegativeInfinity);

    /// <summary>Rounds outwards.</summary>
    public static RadiusRange Around(double least, double greatest) =>
        new(MathF.BitDecrement((float)least), MathF.BitIncrement((float)greatest));

    /// <summary>The range that holds a radius too.</summary>
    public RadiusRange With(double radius) => new(
        Math.Min(Least, MathF.BitDecrement((float)radius)), Math.Max(Greatest, MathF.BitIncrement((float)radius)));

    /// <summary>The range that holds both.</summary>
    public RadiusRange With(RadiusRange other) => new(Math.Min(Least, other.Least), Math.Max(Greatest, other.Greatest));
}
