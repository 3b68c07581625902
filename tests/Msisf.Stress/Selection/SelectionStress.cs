using Msisf.Core.Tiles.Selection;

namespace Msisf.Stress.Selection;

/// <summary>The selection of tiles for random cameras: nothing missed, and how many too many.</summary>
public sealed class SelectionStress : IStressTest
{
    /// <summary>Number of the first camera: those of docs/surface.md were others.</summary>
    private const int FirstCamera = 100_000;

    /// <inheritdoc/>
    public string Name => "selection";

    /// <inheritdoc/>
    public string Subject =>
        "Cameras of twelve kinds with the Sun anywhere, a third of them low, on LDEM_4 and on a made-up Moon with 40 km of relief: "
            + "images with the "
        + "selected tiles alone against images with all, by rays through every facet, pixel by pixel; and kept tiles against tiles seen.";

    /// <inheritdoc/>
    public StressReport Run(StressLength length, int seed)
    {
        (int real, int madeUp, int excess) = length == StressLength.Full ? (10_000, 2_000, 1_000) : (36, 12, 6);
        JudgedMoon moon = JudgedMoon.Real;
        JudgedMoon rugged = JudgedMoon.MadeUp();
        Dspsa selection = new(moon.Grid);
        Dspsa onRugged = new(rugged.Grid);
        SelectionMeasure onReal = SeededCases.Run(real, seed, () => new SelectionMeasure(moon, selection, FirstCamera));
        SelectionMeasure onMadeUp = SeededCases.Run(madeUp, seed, () => new SelectionMeasure(rugged, onRugged, FirstCamera));
        ExcessMeasure tooMany = SeededCases.Run(excess, seed, () => new ExcessMeasure(moon, selection, FirstCamera));
        return new StressReport(
            Name, real + madeUp + excess, [.. onReal.Figures, .. onMadeUp.Figures, .. tooMany.Figures], [.. tooMany.Series]);
    }
}
