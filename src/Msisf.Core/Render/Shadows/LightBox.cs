namespace Msisf.Core.Render.Shadows;

/// <summary>Bounds across the Sun's rays, m in light space; <c>default</c> is the point in front of the Moon's centre.</summary>
/// <param name="LeastU">Least u.</param>
/// <param name="GreatestU">Greatest u; below the least one if nothing is in the box.</param>
/// <param name="LeastV">Least v.</param>
/// <param name="GreatestV">Greatest v.</param>
internal readonly record struct LightBox(double LeastU, double GreatestU, double LeastV, double GreatestV)
{
    /// <summary>Holds nothing.</summary>
    public static LightBox Empty => new(double.PositiveInfinity, double.NegativeInfinity, double.PositiveInfinity, double.NegativeInfinity);

    /// <summary>Whether nothing is in it.</summary>
    public bool IsEmpty => !(LeastU <= GreatestU && LeastV <= GreatestV);

    /// <summary>The least box that holds both.</summary>
    public static LightBox Union(LightBox a, LightBox b) => new(
        Math.Min(a.LeastU, b.LeastU),
        Math.Max(a.GreatestU, b.GreatestU),
        Math.Min(a.LeastV, b.LeastV),
        Math.Max(a.GreatestV, b.GreatestV));

    /// <summary>What both hold.</summary>
    public static LightBox Intersection(LightBox a, LightBox b) => new(
        Math.Max(a.LeastU, b.LeastU),
        Math.Min(a.GreatestU, b.GreatestU),
        Math.Max(a.LeastV, b.LeastV),
        Math.Min(a.GreatestV, b.GreatestV));

    /// <summary>The box with a margin.</summary>
    /// <param name="margin">m.</param>
    public LightBox Widened(double margin) => new(LeastU - margin, GreatestU + margin, LeastV - margin, GreatestV + margin);
}
