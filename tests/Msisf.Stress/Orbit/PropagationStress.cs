using Msisf.Core.Orbit;
using Msisf.Core.Time;
using Msisf.Stress.Reference;
using Msisf.Stress.Time;

namespace Msisf.Stress.Orbit;

/// <summary>Orbits followed over up to a million turns.</summary>
public sealed class PropagationStress : IStressTest
{
    /// <summary>
    /// rad: two units in the last place of pi, half a one for n dt less its turns, one for the sum with M0, half a one for the turn taken
    /// off that.
    /// </summary>
    private const double Phase = 8.9e-16;

    /// <summary>1, of the distance: what <see cref="ElementsStress"/> allows for a position whose phase is right.</summary>
    private const double Position = 2e-15;

    private const double MaxOrbits = 1e6;

    /// <summary>From here on the rounding of the time in seconds is what counts.</summary>
    private const double ManyOrbits = 1e3;

    private const double SecondsADay = 86400.0;

    /// <inheritdoc/>
    public string Name => "propagation";

    /// <inheritdoc/>
    public string Subject =>
        "Orbits with e up to 0.9 followed over up to 1e6 turns forwards and backwards, by seconds and by MJD; "
            + "phase and position against double-double.";

    /// <inheritdoc/>
    public StressReport Run(StressLength length, int seed)
    {
        int cases = length == StressLength.Full ? 1_000_000 : 3_000;
        Found all = SeededCases.Run(cases, seed, () => new Found());
        return new StressReport(
            Name,
            cases,
            [
                all.Phase.ToFigure("phase", "rad", Phase),
                all.PhaseOfTime.ToFigure("phase after 1e3 turns and more, over what half a unit of the time in seconds sweeps", "", 1.0),
                all.Position.ToFigure("position, over what the allowed phase and 2e-15 of the distance make", "", 1.0),
                all.PositionOfDates.ToFigure(
                    "position by MJD, over what half a unit of both dates and of the seconds between them makes beside it", "", 1.0),
                all.Metres.ToFigure("position by MJD", "m", limit: null),
            ],
            [
                all.PhaseOverOrbits.ToSeries("phase", "rad", "turns", "", Phase),
                all.MetresOverOrbits.ToSeries("position by MJD", "m", "turns", "", limit: null),
            ]);
    }

    private sealed class Found : IMeasure<Found>
    {
        public WorstCase Phase { get; } = new();

        public WorstCase PhaseOfTime { get; } = new();

        public WorstCase Position { get; } = new();

        public WorstCase PositionOfDates { get; } = new();

        public WorstCase Metres { get; } = new();

        public SeriesBuilder PhaseOverOrbits { get; } = new(1.0, MaxOrbits, 48, isLogarithmic: true);

        public SeriesBuilder MetresOverOrbits { get; } = new(1.0, MaxOrbits, 48, isLogarithmic: true);

        public void Try(int number, CaseRandom random)
        {
            KeplerElements elements = new(
                random.Logarithmic(1.75e6, 1e7),
                random.Between(0.0, 0.9),
                random.Between(-Math.PI, Math.PI),
                random.Between(-Math.PI, Math.PI),
                random.Between(0.0, Math.PI),
                random.Between(-Math.PI, Math.PI));
            double orbits = random.Sign() * random.Logarithmic(1.0, MaxOrbits);
            Note(elements, orbits, ProjectKernels.OfMjd(random.Between(41000.0, 62000.0)));
        }

        public void Add(Found other)
        {
            Phase.Add(other.Phase);
            PhaseOfTime.Add(other.PhaseOfTime);
            Position.Add(other.Position);
            PositionOfDates.Add(other.PositionOfDates);
            Metres.Add(other.Metres);
            PhaseOverOrbits.Add(other.PhaseOverOrbits);
            MetresOverOrbits.Add(other.MetresOverOrbits);
        }

        private static double Allowed(PreciseOrbit orbit, PreciseVector position, PreciseVector velocity) =>
            (PropagationStress.Phase / orbit.MeanMotion.High * velocity.Length.High) + (PropagationStress.Position * position.Length.High);

        private void Note(KeplerElements elements, double orbits, Instant epoch)
        {
            PreciseOrbit orbit = new(elements);
            double motion = orbit.MeanMotion.High;
            double seconds = orbits * 2.0 * Math.PI / motion;
            NoteSeconds(elements, orbit, orbits, seconds);

            double days = epoch.Mjd + (seconds / SecondsADay);
            if (days is > -600_000.0 and < 2_900_000.0)
            {
                NoteDates(elements, orbit, orbits, epoch, ProjectKernels.OfMjd(days));
            }
        }

        private void NoteSeconds(KeplerElements elements, PreciseOrbit orbit, double orbits, double seconds)
        {
            string Input() => FormattableString.Invariant($"{OrbitText.Of(elements)}, {seconds:R} s");
            double found = new MeanMotion(elements.SemiMajorAxis).MeanAnomalyAt(elements.MeanAnomalyAtEpoch, seconds);
            double phase = Math.Abs(PreciseMath.ToHalfTurn(found - orbit.MeanAnomalyAt(seconds)).High);
            Phase.Note(phase, Input);
            PhaseOverOrbits.Add(Math.Abs(orbits), phase);
            if (Math.Abs(orbits) >= ManyOrbits)
            {
                PhaseOfTime.Note(phase / (orbit.MeanMotion.High * Ulp.Of(seconds) / 2.0), Input);
            }

            (PreciseVector position, PreciseVector velocity) = orbit.StateAt(seconds);
            double distance = PreciseVector.Distance(PreciseVector.From(new KeplerOrbit(elements).PositionAt(seconds)), position);
            Position.Note(distance / Allowed(orbit, position, velocity), Input);
        }

        private void NoteDates(
            KeplerElements elements, PreciseOrbit orbit, double orbits, Instant epoch, Instant date)
        {
            DoubleWord time = date.SecondsSince(epoch);
            (PreciseVector position, PreciseVector velocity) = orbit.StateAt(time);
            string Input() => FormattableString.Invariant($"{OrbitText.Of(elements)}, MJD {epoch.Mjd:R} to {date.Mjd:R}");
            OrbitPropagator propagator = new(elements, epoch, OrbitFrame.MoonMe, ephemeris: null);
            double distance = PreciseVector.Distance(PreciseVector.From(propagator.PositionBodyFixed(date)), position);
            double timeUnits = Ulp.Of(time.High);
            double ofTime = timeUnits / 2.0 * velocity.Length.High;
            PositionOfDates.Note(distance / (ofTime + Allowed(orbit, position, velocity)), Input);
            Metres.Note(distance, Input);
            MetresOverOrbits.Add(Math.Abs(orbits), distance);
        }
    }
}
