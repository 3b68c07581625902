namespace Msisf.Core.Render.Indirect;

/// <summary>What the samples of a group of points have shown.</summary>
/// <param name="Points">Number of its points.</param>
/// <param name="Shared">Deviation of the light of far ground, as pixels around see it.</param>
/// <param name="Other">Deviation of the light of what the points see otherwise.</param>
/// <param name="Bound">Square of the light that they see otherwise, at most, on one point.</param>
/// <param name="Near">Deviation of the light of near ground.</param>
/// <param name="Top">rad: how far up near ground was found.</param>
internal readonly record struct Trial(int Points, Deviation Shared, Deviation Other, double Bound, Deviation Near, double Top)
{
    /// <summary>What one sample costs, over a way to far ground from each point: without a way, and with a ray to near ground.</summary>
    private const double CostOfShared = 0.15;
    private const double CostOfNear = 6.0;

    /// <summary>So many times the samples that a group has need not be taken yet.</summary>
    private const double Enough = 1.25;

    /// <summary>So many times the samples that a group has are not taken at once: few samples tell badly how many are needed.</summary>
    private const int MostGrowth = 10;

    /// <summary>Most samples of a point.</summary>
    private const int Most = 65536;

    /// <summary>How much of <see cref="Other"/> counts, so that the error is least: its own, and what is left out.</summary>
    public double PartOfOther => PartOf(Other.ErrorWith(0.0));

    /// <summary>
    /// Square of the error of a point's light with the samples that an effort asks for, also where these are more than a group may have:
    /// other groups need not make up for what it can't reach.
    /// </summary>
    /// <param name="effort">As <see cref="Next"/>; 0 for the samples that it has.</param>
    public double ErrorWith(double effort)
    {
        double other = Other.ErrorWith(WantedOfOther(effort));
        return Shared.ErrorWith(WantedOfShared(effort)) + (PartOf(other) * other) + Near.ErrorWith(WantedOfNear(effort));
    }

    /// <summary>
    /// How many samples are to be taken next in place of those that the group has; 0 if these are enough. If all groups have the same
    /// effort, they have the least error for their work.
    /// </summary>
    /// <param name="effort">Samples for each unit of their standard deviation, if they cost 1.</param>
    public (int Shared, int Other, int Near) Next(double effort) => (
        Limited(WantedOfShared(effort), Shared), Limited(WantedOfOther(effort), Other), Limited(WantedOfNear(effort), Near));

    /// <summary>What samples of a point cost, over a way to far ground.</summary>
    public static double CostOf(double shared, double other, double near) =>
        (CostOfShared * Math.Min(Most, shared)) + Math.Min(Most, other) + (CostOfNear * Math.Min(Most, near));

    /// <summary>What all samples cost that the group is still to have with an effort, over a way from one point to far ground.</summary>
    public double CostWith(double effort) =>
        Points * CostOf(WantedOfShared(effort), WantedOfOther(effort), WantedOfNear(effort));

    private double PartOf(double errorOfOther) => Bound > 0.0 ? Bound / (Bound + errorOfOther) : 0.0;

    private double WantedOfShared(double effort) => Wanted(Shared, effort / Math.Sqrt(CostOfShared), 0.0);

    private double WantedOfOther(double effort) => Bound > 0.0 ? Wanted(Other, effort, Other.OfOne * Other.OfOne / Bound) : 0.0;

    private double WantedOfNear(double effort) => Wanted(Near, effort / Math.Sqrt(CostOfNear), 0.0);

    /// <summary>How many samples a group is to have; 0 if those that it has are enough.</summary>
    private static double Wanted(Deviation found, double effort, double less)
    {
        double wanted = Math.Ceiling((found.OfOne * effort) - less);
        return wanted > Enough * found.Samples ? wanted : 0.0;
    }

    /// <summary>How many of them it gets next; 0 if it has the most.</summary>
    private static int Limited(double wanted, Deviation found)
    {
        double most = Math.Min(Most, (double)MostGrowth * found.Samples);
        return found.Samples < Most ? (int)Math.Min(wanted, most) : 0;
    }
}

/// <summary>How unsure light is.</summary>
/// <param name="OfOne">Standard deviation of one sample.</param>
/// <param name="Samples">How many samples each point has.</param>
internal readonly record struct Deviation(double OfOne, int Samples)
{
    /// <summary>Square of the error with other samples; 0 for those that there are.</summary>
    public double ErrorWith(double samples) => Samples > 0 ? OfOne * OfOne / (samples > 0.0 ? samples : Samples) : 0.0;
}
