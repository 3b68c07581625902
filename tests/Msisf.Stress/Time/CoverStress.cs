using Msisf.Adapters.Ephemeris;
using Msisf.Core.Ephemeris;
using Msisf.Core.Numerics;
using Msisf.Core.Time;

namespace Msisf.Stress.Time;

/// <summary>Times inside and far outside what the kernels cover.</summary>
public sealed class CoverStress : IStressTest
{
    /// <summary>m: the Sun is seen from the Moon between perihelion and aphelion of the Earth, give or take the Moon's own orbit.</summary>
    private const double MinSunDistance = 1.460e11;
    private const double MaxSunDistance = 1.530e11;

    /// <summary>MJD: 1900-01-01 and 2051-01-01, the ends of the Moon's orientation in kernels/moon_pa_de421_1900-2050.bpc.</summary>
    private const double Start = 15020.0;
    private const double End = 70172.0;

    /// <summary>days: those ends are in TDB, a minute from UTC; within it either answer is right.</summary>
    private const double EndWidth = 100.0 / 86400.0;

    /// <inheritdoc/>
    public string Name => "cover";

    /// <inheritdoc/>
    public string Subject =>
        "The Sun at times inside the kernels' cover, outside it by 1e-6 s to 1e6 days, and at numbers that are no dates, up to 1e300, "
            + "infinite, NaN: a position, or an error that says what is wrong.";

    /// <inheritdoc/>
    public StressReport Run(StressLength length, int seed)
    {
        int cases = length == StressLength.Full ? 200_000 : 2_000;
        using BuiltInKernels kernels = ProjectKernels.Open();
        IEphemeris engine = kernels.Ephemeris;
        Found all = SeededCases.Run(cases, seed, () => new Found(engine));
        return new StressReport(
            Name,
            cases,
            [
                all.Inside.ToFigure("times inside without a position of the Sun", "", 0.0),
                all.Outside.ToFigure("times outside without an error that names the cover", "", 0.0),
                all.NoDates.ToFigure("numbers that are no dates without an error that says so", "", 0.0),
            ],
            []);
    }

    private static double NoDate(CaseRandom random) => random.Below(8) switch
    {
        0 => double.NaN,
        1 => double.PositiveInfinity,
        2 => double.NegativeInfinity,
        _ => random.Sign() * random.Logarithmic(2_973_484.0, 1e300),
    };

    private sealed class Found(IEphemeris engine) : IMeasure<Found>
    {
        public CaseCount Inside { get; } = new();

        public CaseCount Outside { get; } = new();

        public CaseCount NoDates { get; } = new();

        public void Try(int number, CaseRandom random)
        {
            double away = random.Logarithmic(1e-6 / 86400.0, 1e6);
            Note(random.Below(4) switch
            {
                0 => random.Between(Start, End),
                1 => Start - away,
                2 => End + away,
                _ => NoDate(random),
            });
        }

        public void Add(Found other)
        {
            Inside.Add(other.Inside);
            Outside.Add(other.Outside);
            NoDates.Add(other.NoDates);
        }

        private static bool Says(string? refusal, string text) => refusal?.Contains(text, StringComparison.Ordinal) == true;

        private void Note(double mjd)
        {
            Vector3D sun = default;
            string? refusal = Refusals.Of(() => sun = engine.SunPositionBodyFixed(ProjectKernels.OfMjd(mjd)));
            bool isPosition = refusal is null && sun.Length is > MinSunDistance and < MaxSunDistance;
            bool namesCover = Says(refusal, "is outside the kernels' cover: the kernels cover 1899-12-31");
            string Input() => MjdText.Of(mjd);
            if (!(mjd >= -678_575.0 && mjd < 2_973_484.0))
            {
                NoDates.Note(!Says(refusal, "is not a date; a number from -678575 (year 1)"), Input);
            }
            else if (mjd > Start + EndWidth && mjd < End - EndWidth)
            {
                Inside.Note(!isPosition, Input);
            }
            else
            {
                bool isAtAnEnd = mjd > Start - EndWidth && mjd < End + EndWidth;
                Outside.Note(!(namesCover || (isAtAnEnd && isPosition)), Input);
            }
        }
    }
}
