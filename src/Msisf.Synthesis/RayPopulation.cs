namespace Msisf.Synthesis;

/// <summary>
/// The halos and rays of the fresh craters of a population. They make no ground brighter in the mean: what they add is taken off
/// everywhere, octave by octave of diameters.
/// </summary>
internal sealed class RayPopulation
{
    private const int DiametersOfMean = 8;

    private readonly CraterPopulation _craters;
    private readonly CellMemory<CraterRays> _memory;
    private readonly float _onHighlands;
    private readonly float _onMaria;

    /// <summary>The rays of craters.</summary>
    /// <param name="craters">The craters.</param>
    /// <param name="law">Their number.</param>
    /// <param name="memory">Keeps those that were found.</param>
    public RayPopulation(CraterPopulation craters, CraterLaw law, CellMemory<CraterRays> memory)
    {
        (_craters, _memory) = (craters, memory);
        _onHighlands = (float)craters.Octaves.Sum(octave => MeanOf(octave, 0.0));
        _onMaria = (float)craters.Octaves.Sum(octave => MeanOf(octave, 1.0));

        double MeanOf(int octave, double mare)
        {
            double min = Math.ScaleB(1.0, octave);
            return law.CountInOctave(octave) * Enumerable.Range(0, DiametersOfMean).Average(i =>
            {
                double diameter = min * law.DiameterIn(min, (i + 0.5) / DiametersOfMean);
                double share = CraterRays.ShareOf(diameter, craters.CountAbove(diameter, mare));
                double kept = craters.CountAbove(diameter, mare) / craters.CountAbove(diameter, 0.0);
                return kept * CraterRays.MeanStrength(share) * CraterRays.AreaOf(0.5 * diameter);
            });
        }
    }

    /// <summary>Finds the factors of the ground's reflectance in a block: 1 in the mean over a large area.</summary>
    /// <param name="frame">The block.</param>
    /// <param name="mareFraction">0 (highlands) to 1 (mare) at the frame's samples.</param>
    /// <param name="factors">Filled, as the frame's directions.</param>
    public void Find(MapFrame frame, ReadOnlySpan<float> mareFraction, Span<float> factors)
    {
        for (int i = 0; i < factors.Length; i++)
        {
            factors[i] = 1.0f - _onHighlands - (mareFraction[i] * (_onMaria - _onHighlands));
        }

        (double south, double north, double west, double width) = frame.Around();
        foreach ((int octave, CraterCell cell) in _craters.CellsNear(south, north, west, width, CraterRays.ReachOf))
        {
            foreach (CraterRays rays in _memory.Get(octave, cell, InCell))
            {
                rays.AddTo(frame, factors);
            }
        }
    }

    private IEnumerable<CraterRays> InCell(int octave, CraterCell cell)
    {
        foreach (PlacedCrater crater in _craters.PlacedInCell(octave, cell))
        {
            if (crater.Freshness > CraterRays.FreshFrom(CraterRays.MostWithRays)
                && CraterRays.FreshFrom(CraterRays.ShareOf(crater.Diameter, _craters.CountAbove(crater))) is var from
                && crater.Freshness > from)
            {
                yield return new CraterRays(crater, from);
            }
        }
    }
}
