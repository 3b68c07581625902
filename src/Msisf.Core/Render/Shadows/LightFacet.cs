namespace Msisf.Core.Render.Shadows;

/// <summary>The corners of a facet in light space, m.</summary>
internal readonly record struct LightFacet(
    double Ua, double Va, double Wa, double Ub, double Vb, double Wb, double Uc, double Vc, double Wc)
{
    /// <summary>Bounds of the facet across the rays, m.</summary>
    public LightBox Box => new(
        Math.Min(Ua, Math.Min(Ub, Uc)), Math.Max(Ua, Math.Max(Ub, Uc)), Math.Min(Va, Math.Min(Vb, Vc)), Math.Max(Va, Math.Max(Vb, Vc)));

    /// <summary>Minimum depth of the facet, m.</summary>
    public double MinDepth => Math.Min(Wa, Math.Min(Wb, Wc));

    /// <summary>Bounds of u for the part of the facet between two values of v, all in m.</summary>
    /// <returns>Minimum and maximum u, m; plus and minus infinity if there is no such part.</returns>
    public (double MinU, double MaxU) Between(double minV, double maxV)
    {
        double min = double.PositiveInfinity;
        double max = double.NegativeInfinity;
        AddEdge(Ua, Va, Ub, Vb, minV, maxV, ref min, ref max);
        AddEdge(Ub, Vb, Uc, Vc, minV, maxV, ref min, ref max);
        AddEdge(Uc, Vc, Ua, Va, minV, maxV, ref min, ref max);
        return (min, max);
    }

    private static void AddEdge(
        double ua, double va, double ub, double vb, double minV, double maxV, ref double min, ref double max)
    {
        double low = Math.Max(minV, Math.Min(va, vb));
        double high = Math.Min(maxV, Math.Max(va, vb));
        if (low > high)
        {
            return;
        }

        double slope = va == vb ? 0.0 : (ub - ua) / (vb - va);
        double atLow = va == vb ? ua : ua + ((low - va) * slope);
        double atHigh = va == vb ? ub : ua + ((high - va) * slope);
        min = Math.Min(min, Math.Min(atLow, atHigh));
        max = Math.Max(max, Math.Max(atLow, atHigh));
    }
}
