using Msisf.Core.Comparison;

namespace Msisf.App.Twins;

/// <summary>A real image beside its twin.</summary>
/// <param name="Real">The real image, by lines; NaN where it has no value.</param>
/// <param name="Agreement">Agreement of all pixels.</param>
/// <param name="ByPhase">Agreement of the pixels of some phase angles.</param>
/// <param name="Whole">By how much the twin must be moved to lie on the real image; null if that is not found.</param>
/// <param name="Blocks">The same for blocks.</param>
internal sealed record TwinComparison(
    float[] Real, ImageAgreement Agreement, IReadOnlyList<PhaseAgreement> ByPhase, ImageShift? Whole, IReadOnlyList<BlockShift> Blocks)
{
    private const double PhaseStep = 10.0;

    /// <summary>Pixels that make a row of the table by phase angle.</summary>
    private const int LeastCount = 50;

    /// <param name="real">The real image.</param>
    /// <param name="drawn">I/F of its twin, the same size.</param>
    /// <param name="phase">degrees: the phase angle of each pixel; NaN where no surface is seen.</param>
    /// <param name="width">px.</param>
    /// <returns>Null if nothing lit is drawn where the real image has pixels.</returns>
    public static TwinComparison? Of(float[] real, float[] drawn, float[] phase, int width, CancellationToken cancellation)
    {
        if (ImageAgreement.Of(real, drawn) is not { } agreement)
        {
            return null;
        }

        List<PhaseAgreement> byPhase = [];
        for (double low = 0.0; low < 180.0; low += PhaseStep)
        {
            double high = low + PhaseStep;
            if (ImageAgreement.Of(real, drawn, i => phase[i] >= low && phase[i] < high) is { } part && part.Count >= LeastCount)
            {
                byPhase.Add(new PhaseAgreement(low, high, part, agreement.Factor != 0.0 ? part.Factor / agreement.Factor : null));
            }
        }

        (ImageShift? whole, IReadOnlyList<BlockShift> blocks) = new ShiftFinder(real, drawn, width).Find(cancellation);
        return new TwinComparison(real, agreement, byPhase, whole, blocks);
    }
}

/// <summary>The agreement of pixels of some phase angles.</summary>
/// <param name="Low">degrees.</param>
/// <param name="High">degrees.</param>
/// <param name="Agreement">After a factor of their own.</param>
/// <param name="Ratio">
/// Their factor over that of the whole image: above 1 where the real image is brighter than its twin; null where that factor is 0.
/// </param>
internal sealed record PhaseAgreement(double Low, double High, ImageAgreement Agreement, double? Ratio);
