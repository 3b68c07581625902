using Msisf.Core.Attitude;
using Msisf.Core.Numerics;

namespace Msisf.Stress.Attitude;

/// <summary>Attitudes that turn at a constant rate, over many steps.</summary>
public sealed class AttitudeStress : IStressTest
{
    /// <summary>
    /// 1: the four components of a product that was divided by its length are rounded three times, by half a unit of 1 at most in all.
    /// </summary>
    private const double Norm = 1e-15;

    /// <summary>
    /// 1, length of the difference of two unit quaternions: about ten roundings of axis, sine, product and length, of 1.1e-16 times numbers
    /// below 1, which rarely add up.
    /// </summary>
    private const double ClosedForm = 1e-15;

    /// <summary>
    /// 1, of a step: what is lost when attitudes are multiplied step by step instead. The step's own rounding comes back in each, so the
    /// loss grows with their number.
    /// </summary>
    private const double ProductPerStep = 2.5e-16;

    private const double StepSeconds = 1.0;
    private const int StepsAtOneRate = 1000;

    /// <inheritdoc/>
    public string Name => "attitude";

    /// <inheritdoc/>
    public string Subject =>
        "The attitude transition at each of many steps of 1 s, at random attitudes and rates of 1e-9 to 10 rad/s, "
            + "and the product of as many single steps; against q0 exp(w t / 2) in double-double.";

    /// <inheritdoc/>
    public StressReport Run(StressLength length, int seed)
    {
        int steps = length == StressLength.Full ? 10_000_000 : 30_000;
        Found all = SeededCases.Run(steps / StepsAtOneRate, seed, () => new Found(steps));
        all.MultiplySteps(new CaseRandom(seed, part: -1));
        return new StressReport(
            Name,
            steps,
            [
                all.Transition.ToFigure("transition, difference from the closed form", "", ClosedForm),
                all.Norm.ToFigure("length of the quaternion, difference from 1", "", Norm),
                all.ProductNorm.ToFigure("length of the product of single steps, difference from 1", "", Norm),
                all.Product.ToFigure(
                    "product of single steps, difference from the closed form over the number of steps", "", ProductPerStep),
            ],
            [
                all.OverSteps.ToSeries("transition", "of the quaternion", "steps of 1 s since the epoch", "", ClosedForm),
                all.ProductOverSteps.ToSeries("product of single steps", "of the quaternion", "steps", "", limit: null),
            ]);
    }

    private sealed class Found(int steps) : IMeasure<Found>
    {
        public WorstCase Transition { get; } = new();

        public WorstCase Norm { get; } = new();

        public WorstCase Product { get; } = new();

        public WorstCase ProductNorm { get; } = new();

        public SeriesBuilder OverSteps { get; } = new(1.0, steps, 48, isLogarithmic: true);

        public SeriesBuilder ProductOverSteps { get; } = new(1.0, steps, 48, isLogarithmic: true);

        /// <summary>One attitude, multiplied on and on; the closed form is asked at powers of 2^(1/8) only.</summary>
        public void MultiplySteps(CaseRandom random)
        {
            TurningAttitude right = TurningAttitude.Random(random);
            UnitQuaternion single = new AttitudeTransition(UnitQuaternion.Identity, right.Rate).At(StepSeconds);
            UnitQuaternion product = right.AtEpoch;
            double next = 1.0;
            for (int step = 1; step <= steps; step++)
            {
                product *= single;
                ProductNorm.Note(TurningAttitude.LengthError(product), Input(right, step * StepSeconds));
                if (step >= next || step == steps)
                {
                    double error = right.DistanceAt(step * StepSeconds, product);
                    Product.Note(error / step, Input(right, step * StepSeconds));
                    ProductOverSteps.Add(step, error);
                    next *= Math.Pow(2.0, 1.0 / 8.0);
                }
            }
        }

        /// <summary>An attitude with its rate, seen at some of the steps from the first to the last.</summary>
        public void Try(int number, CaseRandom random)
        {
            TurningAttitude right = TurningAttitude.Random(random);
            AttitudeTransition transition = new(right.AtEpoch, right.Rate);
            for (int step = 0; step < StepsAtOneRate; step++)
            {
                double seconds = StepSeconds * Math.Floor(random.Logarithmic(1.0, steps + 1.0));
                Note(right, seconds, transition.At(seconds));
            }
        }

        public void Add(Found other)
        {
            Transition.Add(other.Transition);
            Norm.Add(other.Norm);
            OverSteps.Add(other.OverSteps);
        }

        private static Func<string> Input(TurningAttitude right, double seconds) =>
            () => FormattableString.Invariant($"q0 = {right.AtEpoch}, w = {right.Rate} rad/s, {seconds:R} s");

        private void Note(TurningAttitude right, double seconds, UnitQuaternion found)
        {
            double error = right.DistanceAt(seconds, found);
            Transition.Note(error, Input(right, seconds));
            Norm.Note(TurningAttitude.LengthError(found), Input(right, seconds));
            OverSteps.Add(seconds / StepSeconds, error);
        }
    }
}
