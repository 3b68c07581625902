namespace Msisf.Core.Render.Shadows;

/// <summary>Bounds in light space across the Sun's rays, m; <c>default</c> is the ray through the Moon's centre.</summary>
/// <param name="MinU">Minimum u.</param>
/// <param name="MaxU">Maximum u; less than <paramref name="MinU"/> if the box is empty.</param>
/// <param name="MinV">Minimum v.</param>
/// <param name="MaxV">Maximum v.</param>
internal readonly record struct LightBox(double MinU, double MaxU, double MinV, double MaxV)
{
    /// <summary>The empty box.</summary>
    public static LightBox Empty => new(double.PositiveInfinity, double.NegativeInfinity, double.PositiveInfinity, double.NegativeInfinity);

    /// <summary>Whether the box is empty.</summary>
    public bool IsEmpty => !(MinU <= MaxU && MinV <= MaxV);

    /// <summary>The smallest box that contains both boxes.</summary>
    public static LightBox Union(LightBox a, LightBox b) => new(
        Math.Min(a.MinU, b.MinU),
        Math.Max(a.MaxU, b.MaxU),
        Math.Min(a.MinV, b.MinV),
        Math.Max(a.MaxV, b.MaxV));

    /// <summary>The part that both boxes contain; empty if they do not overlap.</summary>
    public static LightBox Intersection(LightBox a, LightBox b) => new(
        Math.Max(a.MinU, b.MinU),
        Math.Min(a.MaxU, b.MaxU),
        Math.Max(a.MinV, b.MinV),
        Math.Min(a.MaxV, b.MaxV));

    /// <summary>The box, extended by a margin on all sides.</summary>
    /// <param name="margin">Margin, m.</param>
    public LightBox Widened(double margin) => Widened(margin, margin);

    /// <summary>The box, extended by a margin on each side.</summary>
    /// <param name="marginU">Margin along u, m.</param>
    /// <param name="marginV">Margin along v, m.</param>
    public LightBox Widened(double marginU, double marginV) =>
        new(MinU - marginU, MaxU + marginU, MinV - marginV, MaxV + marginV);
}
