using Msisf.Core.Ephemeris;
using Msisf.Core.Orbit;
using Msisf.Stress.Reference;

namespace Msisf.Stress.Orbit;

/// <summary>Elements to state to elements, where single angles lose their meaning.</summary>
public sealed class ElementsStress : IStressTest
{
    /// <summary>
    /// 1, of the vector: six roundings of each axis of the ellipse, three of the place on it and one of the product, 1.1e-16 each at most,
    /// and the mean anomaly's own.
    /// </summary>
    private const double State = 2e-15;

    /// <summary>1, of the vector: twice that, as the state in between is rounded and its rounding changes the elements.</summary>
    private const double RoundTrip = 4e-15;

    /// <summary>
    /// 1 and rad: a state wrong by <see cref="State"/> turns and stretches the ellipse by up to about twice as much for e up to 1/2.
    /// </summary>
    private const double Elements = 6e-15;

    private const double Nearest = 1e-16;
    private const double Farthest = 1e-3;

    /// <inheritdoc/>
    public string Name => "elements";

    /// <inheritdoc/>
    public string Subject =>
        "Elements to state to elements: e, i and pi - i each exactly 0, from 1e-16 to 1e-3, or anything (e up to 1/2), "
            + "in all combinations; the state and what the elements mean without a single angle, against double-double.";

    /// <inheritdoc/>
    public StressReport Run(StressLength length, int seed)
    {
        int cases = length == StressLength.Full ? 1_000_000 : 3_000;
        Found all = SeededCases.Run(cases, seed, () => new Found());
        return all.ToReport(Name, cases);
    }

    private static double NearZero(CaseRandom random, double most) => random.Below(8) switch
    {
        0 => 0.0,
        < 6 => random.Logarithmic(Nearest, Farthest),
        _ => random.Between(Farthest, most),
    };

    private sealed class Found : IMeasure<Found>
    {
        private readonly WorstCase[] _worst = [.. Enumerable.Range(0, 7).Select(_ => new WorstCase())];
        private readonly SeriesBuilder _overEccentricity = new(Nearest, Farthest, 52, isLogarithmic: true);
        private readonly SeriesBuilder _overTilt = new(Nearest, Farthest, 52, isLogarithmic: true);
        private readonly SeriesBuilder _overRetrogradeTilt = new(Nearest, Farthest, 52, isLogarithmic: true);

        public void Try(int number, CaseRandom random)
        {
            double eccentricity = NearZero(random, 0.5);
            double tilt = NearZero(random, Math.PI / 2.0);
            Note(
                new KeplerElements(
                    random.Logarithmic(1.75e6, 1e8),
                    eccentricity,
                    random.Between(-Math.PI, Math.PI),
                    random.Between(-Math.PI, Math.PI),
                    random.Below(2) == 0 ? tilt : Math.PI - tilt,
                    random.Between(-Math.PI, Math.PI)),
                tilt);
        }

        public void Add(Found other)
        {
            for (int index = 0; index < _worst.Length; index++)
            {
                _worst[index].Add(other._worst[index]);
            }

            _overEccentricity.Add(other._overEccentricity);
            _overTilt.Add(other._overTilt);
            _overRetrogradeTilt.Add(other._overRetrogradeTilt);
        }

        public StressReport ToReport(string name, long cases) => new(
            name,
            cases,
            [
                _worst[0].ToFigure("position from elements, of its length", "", State),
                _worst[1].ToFigure("velocity from elements, of its length", "", State),
                _worst[2].ToFigure("position after the way to elements and back, of its length", "", RoundTrip),
                _worst[3].ToFigure("velocity after the way to elements and back, of its length", "", RoundTrip),
                _worst[4].ToFigure("eccentricity vector", "", Elements),
                _worst[5].ToFigure("normal of the orbit", "", Elements),
                _worst[6].ToFigure("M + omega + Omega cos i", "rad", Elements),
            ],
            [
                _overEccentricity.ToSeries("position after the way back", "of its length", "e", "", RoundTrip),
                _overTilt.ToSeries("position after the way back", "of its length", "i", "rad", RoundTrip),
                _overRetrogradeTilt.ToSeries("position after the way back", "of its length", "pi - i", "rad", RoundTrip),
            ]);

        /// <summary>
        /// By how much the spacecraft would move about the orbit's normal if one set of angles took the place of the other, rad. Next to
        /// the equator only this sum has a meaning.
        /// </summary>
        private static double TurnBetween(KeplerElements a, KeplerElements b)
        {
            DoubleWord inPlane = (DoubleWord)a.MeanAnomalyAtEpoch + a.ArgumentOfPeriapsis - b.MeanAnomalyAtEpoch - b.ArgumentOfPeriapsis;
            DoubleWord ofNode = PreciseMath.ToHalfTurn((DoubleWord)a.LongitudeOfAscendingNode - b.LongitudeOfAscendingNode);
            return PreciseMath.ToHalfTurn(inPlane + (PreciseMath.SinCos(b.Inclination).Cos * ofNode)).High;
        }

        private void Note(KeplerElements elements, double tilt)
        {
            PreciseOrbit orbit = new(elements);
            (PreciseVector position, PreciseVector velocity) = orbit.StateAt(default);
            StateVector state = new KeplerOrbit(elements).StateAt(0.0);
            KeplerElements back = StateConversion.ToElements(state);
            StateVector again = new KeplerOrbit(back).StateAt(0.0);
            PreciseOrbit backOrbit = new(back);
            double roundTrip = PreciseVector.RelativeError(PreciseVector.From(again.Position), position);
            double[] errors =
            [
                PreciseVector.RelativeError(PreciseVector.From(state.Position), position),
                PreciseVector.RelativeError(PreciseVector.From(state.Velocity), velocity),
                roundTrip,
                PreciseVector.RelativeError(PreciseVector.From(again.Velocity), velocity),
                PreciseVector.Distance(backOrbit.EccentricityVector, orbit.EccentricityVector),
                PreciseVector.Distance(backOrbit.Normal, orbit.Normal),
                Math.Abs(TurnBetween(back, elements)),
            ];
            for (int index = 0; index < errors.Length; index++)
            {
                _worst[index].Note(errors[index], () => OrbitText.Of(elements));
            }

            if (elements.Eccentricity is >= Nearest and <= Farthest)
            {
                _overEccentricity.Add(elements.Eccentricity, roundTrip);
            }

            if (tilt is >= Nearest and <= Farthest)
            {
                (elements.Inclination < 1.0 ? _overTilt : _overRetrogradeTilt).Add(tilt, roundTrip);
            }
        }
    }
}
