namespace Msisf.Core.Render.Shadows;

/// <summary>The corners of a facet in light space, m.</summary>
internal readonly record struct LightFacet(
    double Ua, double Va, double Wa, double Ub, double Vb, double Wb, double Uc, double Vc, double Wc)
{
    /// <summary>Bounds across the rays.</summary>
    public LightBox Box => new(
        Math.Min(Ua, Math.Min(Ub, Uc)), Math.Max(Ua, Math.Max(Ub, Uc)), Math.Min(Va, Math.Min(Vb, Vc)), Math.Max(Va, Math.Max(Vb, Vc)));

    /// <summary>m: no point of it is nearer to the Sun.</summary>
    public double LeastDepth => Math.Min(Wa, Math.Min(Wb, Wc));

    /// <summary>Bounds of u of the part between two values of v.</summary>
    /// <returns>m; infinite the wrong way round if there is no such part.</returns>
    public (double LeastU, double GreatestU) Between(double leastV, double greatestV)
    {
        double least = double.PositiveInfinity;
        double greatest = double.NegativeInfinity;
        AddEdge(Ua, Va, Ub, Vb, leastV, greatestV, ref least, ref greatest);
        AddEdge(Ub, Vb, Uc, Vc, leastV, greatestV, ref least, ref greatest);
        AddEdge(Uc, Vc, Ua, Va, leastV, greatestV, ref least, ref greatest);
        return (least, greatest);
    }

    private static void AddEdge(
        double ua, double va, double ub, double vb, double leastV, double greatestV, ref double least, ref double greatest)
    {
        double low = Math.Max(leastV, Math.Min(va, vb));
        double high = Math.Min(greatestV, Math.Max(va, vb));
        if (low > high)
        {
            return;
        }

        double slope = va == vb ? 0.0 : (ub - ua) / (vb - va);
        double atLow = va == vb ? ua : ua + ((low - va) * slope);
        double atHigh = va == vb ? ub : ua + ((high - va) * slope);
        least = Math.Min(least, Math.Min(atLow, atHigh));
        greatest = Math.Max(greatest, Math.Max(atLow, atHigh));
    }
}
