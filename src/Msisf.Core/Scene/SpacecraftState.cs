using Msisf.Core.Camera;
using Msisf.Core.Time;

namespace Msisf.Core.Scene;

/// <summary>
/// All that one frame needs to know of the spacecraft: the thesis's fixed state. <c>default</c> has no attitude and is not a state.
/// </summary>
/// <param name="Time">When.</param>
/// <param name="PositionBodyFixed">m, body-fixed.</param>
/// <param name="MoonFromCamera">Turns camera axes (looks along -x, y right, z up) into Moon axes.</param>
public readonly record struct SpacecraftState(Instant Time, Vector3D PositionBodyFixed, UnitQuaternion MoonFromCamera)
{
    /// <summary>
    /// The eight numbers of a fixed state in the thesis's order (section 6.3.2): MJD (days, UTC), position (m), quaternion.
    /// </summary>
    public static IReadOnlyList<string> NumberNames { get; } = ["MJD", "rx", "ry", "rz", "qx", "qy", "qz", "q0"];

    /// <summary>m: less than the nearest perihelion of a body with craters; a direction of length 1, or km, is found by it.</summary>
    public const double NearestSun = 1e10;

    /// <summary>Smallest <see cref="ExposureFactor"/>.</summary>
    public const double LeastExposure = 1e-6;

    /// <summary>Greatest <see cref="ExposureFactor"/>.</summary>
    public const double GreatestExposure = 1e6;

    /// <summary>How the camera moves about this time; null if that is not known or not wanted.</summary>
    public CameraMotion? Motion { get; init; }

    /// <summary>How the camera moves in all the time of an image that is scanned, or has jitter; null for others.</summary>
    public ScanPath? Path { get; init; }

    /// <summary>The noise of the frame's detector; null for the one that the detector's seed and this state give.</summary>
    public NoiseSeed? Noise { get; init; }

    /// <summary>By how much longer the frame is exposed than the run's settings say; null for as long.</summary>
    public double? ExposureFactor { get; init; }

    /// <summary>What a sky that fits the ground of this state needs to know; null where finite light does nothing to the ground.</summary>
    public SkyObserver? Sky { get; init; }

    /// <summary>The state to which the frame's flow leads; null without a flow.</summary>
    public FlowState? Flow { get; init; }

    /// <summary>
    /// m, MOON_ME: where the light's Sun is, at least <see cref="NearestSun"/> away; null for the place that the ephemeris gives.
    /// </summary>
    public Vector3D? SunPositionBodyFixed { get; init; }

    /// <summary>
    /// The eight numbers in the order of <see cref="NumberNames"/>, and the six of <see cref="Motion"/> if there is one;
    /// <see cref="FromNumbers"/> makes the same state of the time and those behind it, to the last bit, but for <see cref="Noise"/>,
    /// <see cref="ExposureFactor"/>, <see cref="SunPositionBodyFixed"/> and <see cref="Flow"/>.
    /// </summary>
    public double[] ToNumbers() =>
    [
        Time.Mjd, PositionBodyFixed.X, PositionBodyFixed.Y, PositionBodyFixed.Z, MoonFromCamera.X, MoonFromCamera.Y, MoonFromCamera.Z,
        MoonFromCamera.W, .. Motion?.ToNumbers() ?? [],
    ];

    /// <summary>Checks and takes a position of the Sun.</summary>
    /// <param name="position">m, body-fixed.</param>
    /// <exception cref="BadInputException">It is not finite, or nearer than <see cref="NearestSun"/>.</exception>
    public static Vector3D CheckedSun(Vector3D position) => position.Length is >= NearestSun and < double.PositiveInfinity
        ? position
        : throw new BadInputException(Invariant(
            $"the Sun is {position.Length:G3} m from the body's centre; metres are needed, at least {NearestSun:G3}. The Sun is 1.5e11 m "
                + $"from the Moon: multiply a direction by that."));

    /// <summary>Checks and takes an exposure factor.</summary>
    /// <exception cref="BadInputException">It is outside <see cref="LeastExposure"/> to <see cref="GreatestExposure"/>.</exception>
    public static double CheckedExposure(double factor) => factor is >= LeastExposure and <= GreatestExposure
        ? factor
        : throw new BadInputException(Invariant(
            $"the exposure factor is {factor:R}; {LeastExposure:R} to {GreatestExposure:R} is possible."));

    /// <summary>Checks and takes the seven numbers behind the time, or these and the six of a motion.</summary>
    /// <param name="numbers">In the order of <see cref="NumberNames"/>, then of <see cref="CameraMotion.NumberNames"/>.</param>
    /// <param name="isRounded">Whether the quaternion may be rounded to a few decimals.</param>
    /// <exception cref="BadInputException">
    /// The position or the motion is not finite, or the quaternion is not a rotation.
    /// </exception>
    /// <exception cref="ArgumentException">Neither seven nor thirteen numbers.</exception>
    public static SpacecraftState FromNumbers(Instant time, ReadOnlySpan<double> numbers, bool isRounded = false)
    {
        int count = NumberNames.Count - 1;
        if (numbers.Length != count && numbers.Length != count + CameraMotion.NumberNames.Count)
        {
            throw new ArgumentException($"{numbers.Length} numbers for a state of {count}.", nameof(numbers));
        }

        return new SpacecraftState(
            time,
            new Vector3D(Guard.Finite(numbers[0], "rx (m)"), Guard.Finite(numbers[1], "ry (m)"), Guard.Finite(numbers[2], "rz (m)")),
            UnitQuaternion.FromComponents(numbers[3], numbers[4], numbers[5], numbers[6], isRounded))
        {
            Motion = numbers.Length == count ? null : CameraMotion.FromNumbers(numbers[count..]),
        };
    }
}

/// <summary>
/// Which noise a frame's detector has, whatever the frame's state: Monte Carlo runs draw other noises of one state. <c>default</c> is one
/// of them too.
/// </summary>
/// <param name="Number">The user's number; each makes a series of its own.</param>
/// <param name="Step">Number of the frame in that series.</param>
public readonly record struct NoiseSeed(ulong Number, ulong Step);
