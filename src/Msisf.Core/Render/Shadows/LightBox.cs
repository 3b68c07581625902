namespace Msisf.Core.Render.Shadows;

/// <summary>Bounds across the Sun's rays, m in light space; <c>default</c> is the point in front of the Moon's centre.</summary>
/// <param name="MinU">Minimum u.</param>
/// <param name="MaxU">Maximum u; below the minimum one if nothing is in the box.</param>
/// <param name="MinV">Minimum v.</param>
/// <param name="MaxV">Maximum v.</param>
internal readonly record struct LightBox(double MinU, double MaxU, double MinV, double MaxV)
{
    /// <summary>Holds nothing.</summary>
    public static LightBox Empty => new(double.PositiveInfinity, double.NegativeInfinity, double.PositiveInfinity, double.NegativeInfinity);

    /// <summary>Whether nothing is in it.</summary>
    public bool IsEmpty => !(MinU <= MaxU && MinV <= MaxV);

    /// <summary>The minimum box that holds both.</summary>
    public static LightBox Union(LightBox a, LightBox b) => new(
        Math.Min(a.MinU, b.MinU),
        Math.Max(a.MaxU, b.MaxU),
        Math.Min(a.MinV, b.MinV),
        Math.Max(a.MaxV, b.MaxV));

    /// <summary>What both hold.</summary>
    public static LightBox Intersection(LightBox a, LightBox b) => new(
        Math.Max(a.MinU, b.MinU),
        Math.Min(a.MaxU, b.MaxU),
        Math.Max(a.MinV, b.MinV),
        Math.Min(a.MaxV, b.MaxV));

    /// <summary>The box with a margin.</summary>
    /// <param name="margin">m.</param>
    public LightBox Widened(double margin) => new(MinU - margin, MaxU + margin, MinV - margin, MaxV + margin);
}
