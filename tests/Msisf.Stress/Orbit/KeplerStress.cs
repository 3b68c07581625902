using Msisf.Core.Orbit;
using Msisf.Stress.Reference;

namespace Msisf.Stress.Orbit;

/// <summary>Kepler's equation for every eccentricity and any number of turns.</summary>
public sealed class KeplerStress : IStressTest
{
    /// <summary>ulp of M: the project's plan.</summary>
    private const double MaxResidual = 4.0;

    /// <summary>1: the program gives up after 100, which bisection alone would need; Newton's method doubles its digits in each.</summary>
    private const double MaxSteps = 10.0;

    /// <summary>
    /// ulp of E: half for its own rounding, and half a one of the sine over the slope of the equation at e = 1/2; a sine may be wrong by a
    /// little more.
    /// </summary>
    private const double MaxAngleError = 1.1;

    private const double MinFromParabola = 1e-12;
    private const double MaxTurns = 1e6;
    private const double MinAnomaly = 1e-30; // rad

    /// <inheritdoc/>
    public string Name => "kepler";

    /// <inheritdoc/>
    public string Subject =>
        "Kepler's equation: random e up to 1 - 1e-12 (even, and even in the logarithms of e and of 1 - e), "
            + "|M| from 1e-30 rad to 1e6 turns; the residual E - e sin E - M in double-double.";

    /// <inheritdoc/>
    public StressReport Run(StressLength length, int seed)
    {
        int cases = length == StressLength.Full ? 10_000_000 : 30_000;
        Found all = SeededCases.Run(cases, seed, () => new Found());
        return new StressReport(
            Name,
            cases,
            [
                all.Given.ToFigure("residual, in units of the last place of the M given", "ulp", MaxResidual),
                all.Reduced.ToFigure("residual, in units of the last place of M less its turns", "ulp", MaxResidual),
                all.Angle.ToFigure("error of E, for M within half a turn", "ulp", MaxAngleError),
                all.Steps.ToFigure("steps to the solution", "", MaxSteps),
            ],
            [
                all.OverEccentricity.ToSeries("residual", "ulp of M less its turns", "1 - e", "", MaxResidual),
                all.OverAnomaly.ToSeries("residual", "ulp of M less its turns", "|M|", "rad", MaxResidual),
                all.StepsOverEccentricity.ToSeries("steps to the solution", "", "1 - e", "", MaxSteps),
            ]);
    }

    private sealed class Found : IMeasure<Found>
    {
        public WorstCase Given { get; } = new();

        public WorstCase Reduced { get; } = new();

        public WorstCase Angle { get; } = new();

        public WorstCase Steps { get; } = new();

        public SeriesBuilder OverEccentricity { get; } = new(MinFromParabola, 1.0, 48, isLogarithmic: true);

        public SeriesBuilder OverAnomaly { get; } = new(MinAnomaly, 2.0 * Math.PI * MaxTurns, 74, isLogarithmic: true);

        public SeriesBuilder StepsOverEccentricity { get; } = new(MinFromParabola, 1.0, 48, isLogarithmic: true);

        public void Try(int number, CaseRandom random)
        {
            double eccentricity = random.Below(3) switch
            {
                0 => random.Between(0.0, 1.0 - MinFromParabola),
                1 => 1.0 - random.Logarithmic(MinFromParabola, 1.0),
                _ => random.Logarithmic(1e-300, 0.1),
            };
            double meanAnomaly = random.Sign() * random.Below(3) switch
            {
                0 => random.Between(0.0, Math.PI),
                1 => random.Logarithmic(MinAnomaly, Math.PI),
                _ => 2.0 * Math.PI * random.Logarithmic(0.5, MaxTurns),
            };
            Note(meanAnomaly, eccentricity);
        }

        public void Add(Found other)
        {
            Given.Add(other.Given);
            Reduced.Add(other.Reduced);
            Angle.Add(other.Angle);
            Steps.Add(other.Steps);
            OverEccentricity.Add(other.OverEccentricity);
            OverAnomaly.Add(other.OverAnomaly);
            StepsOverEccentricity.Add(other.StepsOverEccentricity);
        }

        private void Note(double meanAnomaly, double eccentricity)
        {
            double angle = KeplerSolver.Solve(meanAnomaly, eccentricity, out int steps).Angle;
            DoubleWord reduced = PreciseMath.ToHalfTurn(meanAnomaly);
            double residual = Math.Abs(PreciseKepler.Residual(angle, eccentricity, reduced).High);
            double ulps = residual / Ulp.Of(reduced.High);
            string Input() => FormattableString.Invariant($"M = {meanAnomaly:R}, e = {eccentricity:R}");
            Reduced.Note(ulps, Input);
            Given.Note(residual / Ulp.Of(meanAnomaly), Input);
            if (Math.Abs(meanAnomaly) <= Math.PI)
            {
                Angle.Note(residual / PreciseKepler.Slope(angle, eccentricity).High / Ulp.Of(angle), Input);
            }

            Steps.Note(steps, Input);
            OverEccentricity.Add(1.0 - eccentricity, ulps);
            OverAnomaly.Add(Math.Abs(meanAnomaly), ulps);
            StepsOverEccentricity.Add(1.0 - eccentricity, steps);
        }
    }
}
