using Msisf.Core.Ephemeris;
using Msisf.Core.Numerics;
using Msisf.Core.Orbit;
using Msisf.Core.Terrain;
using Msisf.Stress.Reference;

namespace Msisf.Stress.Orbit;

/// <summary>State to elements to state, next to circular and equatorial orbits.</summary>
public sealed class StatesStress : IStressTest
{
    /// <summary>
    /// 1, of the vector: the roundings of elements (five angles below pi, each by up to 2.2e-16 and its sine's) and of the state made of
    /// them.
    /// </summary>
    private const double RoundTrip = 4e-15;

    /// <summary>1, of the axis and rad: some ten roundings of 1.1e-16 on the way from the state.</summary>
    private const double Elements = 3e-15;

    private const double Nearest = 1e-16;
    private const double Farthest = 1e-3;

    /// <inheritdoc/>
    public string Name => "states";

    /// <inheritdoc/>
    public string Subject =>
        "State to elements to state: orbits that miss the circle and the equator, in either sense of motion, "
            + "by 1e-16 to 1e-3 or by nothing in position and velocity; against double-double, without any angle.";

    /// <inheritdoc/>
    public StressReport Run(StressLength length, int seed)
    {
        int cases = length == StressLength.Full ? 1_000_000 : 3_000;
        Found all = SeededCases.Run(cases, seed, () => new Found());
        return all.ToReport(Name, cases);
    }

    private static double Missing(CaseRandom random) => random.Below(4) == 0 ? 0.0 : random.Sign() * random.Logarithmic(Nearest, Farthest);

    private sealed class Found : IMeasure<Found>
    {
        private readonly WorstCase[] _worst = [.. Enumerable.Range(0, 5).Select(_ => new WorstCase())];
        private readonly SeriesBuilder _overEccentricity = new(Nearest, Farthest, 52, isLogarithmic: true);
        private readonly SeriesBuilder _overTilt = new(Nearest, Farthest, 52, isLogarithmic: true);

        public void Try(int number, CaseRandom random)
        {
            double radius = random.Logarithmic(1.75e6, 1e8);
            double speed = Math.Sqrt(MoonConstants.GravitationalParameter / radius);
            (double sin, double cos) = Math.SinCos(random.Between(-Math.PI, Math.PI));
            double sense = random.Sign();
            double climb = Missing(random);
            double tilt = Missing(random);
            Vector3D position = radius * new Vector3D(cos, sin, Missing(random));
            Vector3D velocity = speed * new Vector3D((-sense * sin) + (climb * cos), (sense * cos) + (climb * sin), tilt);
            Note(new StateVector(position, (1.0 + Missing(random)) * velocity));
        }

        public void Add(Found other)
        {
            for (int index = 0; index < _worst.Length; index++)
            {
                _worst[index].Add(other._worst[index]);
            }

            _overEccentricity.Add(other._overEccentricity);
            _overTilt.Add(other._overTilt);
        }

        public StressReport ToReport(string name, long cases) => new(
            name,
            cases,
            [
                _worst[0].ToFigure("position after the way to elements and back, of its length", "", RoundTrip),
                _worst[1].ToFigure("velocity after the way to elements and back, of its length", "", RoundTrip),
                _worst[2].ToFigure("semi-major axis, of its length", "", Elements),
                _worst[3].ToFigure("eccentricity vector", "", Elements),
                _worst[4].ToFigure("normal of the orbit", "", Elements),
            ],
            [
                _overEccentricity.ToSeries("position after the way back", "of its length", "e", "", RoundTrip),
                _overTilt.ToSeries("position after the way back", "of its length", "sin i", "", RoundTrip),
            ]);

        private void Note(StateVector state)
        {
            KeplerElements elements = StateConversion.ToElements(state);
            StateVector again = new KeplerOrbit(elements).StateAt(0.0);
            PreciseState right = new(state);
            PreciseOrbit orbit = new(elements);
            double roundTrip = PreciseVector.RelativeError(PreciseVector.From(again.Position), PreciseVector.From(state.Position));
            double[] errors =
            [
                roundTrip,
                PreciseVector.RelativeError(PreciseVector.From(again.Velocity), PreciseVector.From(state.Velocity)),
                Math.Abs((elements.SemiMajorAxis - right.SemiMajorAxis).High / elements.SemiMajorAxis),
                PreciseVector.Distance(orbit.EccentricityVector, right.EccentricityVector),
                PreciseVector.Distance(orbit.Normal, right.Normal),
            ];
            for (int index = 0; index < errors.Length; index++)
            {
                _worst[index].Note(errors[index], () => OrbitText.Of(state));
            }

            _overEccentricity.Add(right.EccentricityVector.Length.High, roundTrip);
            _overTilt.Add(double.Hypot(right.Normal.X.High, right.Normal.Y.High), roundTrip);
        }
    }
}
