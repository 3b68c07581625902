using System.Runtime.InteropServices;
using System.Security.Cryptography;

namespace Msisf.Core.Camera;

/// <summary>
/// How a camera moves about the time of an image: its state at each time, and at the times of its exposures. As safe for several threads as
/// what it gets the states from.
/// </summary>
public sealed class ScanPath
{
    private const int DigestDigits = 32;

    private const int PartsOfFastest = 16;

    private readonly Func<double, CameraState> _stateAt;
    private readonly Func<double, CameraMotion?>? _motionAt;
    private readonly Jitter? _jitter;
    private readonly double _jitterStart;
    private readonly Mounting? _mounting;

    /// <summary>Takes a motion without any exposure.</summary>
    /// <param name="stateAt">The state some seconds after the image's time.</param>
    /// <param name="motionAt">How it moves then, where what gives the states says it; null for what does not.</param>
    public ScanPath(Func<double, CameraState> stateAt, Func<double, CameraMotion?>? motionAt = null)
        : this(stateAt, motionAt, null, 0.0, null)
    {
    }

    private ScanPath(
        Func<double, CameraState> stateAt, Func<double, CameraMotion?>? motionAt, Jitter? jitter, double jitterStart, Mounting? mounting) =>
        (_stateAt, _motionAt, _jitter, _jitterStart, _mounting, States) = (stateAt, motionAt, jitter, jitterStart, mounting, []);

    /// <summary>The states of the exposures, the first one's first.</summary>
    public IReadOnlyList<CameraState> States { get; private init; }

    /// <summary>The same motion with the states of exposures.</summary>
    /// <param name="scan">The exposures; null for one at the image's time.</param>
    /// <param name="jitter">Turns the camera; null for none.</param>
    /// <param name="jitterStart">s: what the jitter's times count at the image's time.</param>
    /// <param name="mounting">How the camera sits on the body that moves and shakes so; null for a camera that does it itself.</param>
    public ScanPath Of(Scan? scan, Jitter? jitter, double jitterStart, Mounting? mounting = null)
    {
        ScanPath path = new(_stateAt, _motionAt, jitter, jitterStart, mounting);
        return new ScanPath(_stateAt, _motionAt, jitter, jitterStart, mounting)
        {
            States = scan is null
                ? [path.At(0.0)]
                : [.. Enumerable.Range(0, scan.Count).Select(exposure => path.At(scan.SecondsOf(exposure)))],
        };
    }

    /// <summary>The state at a time, with jitter and mounting.</summary>
    /// <param name="seconds">s after the image's time.</param>
    public CameraState At(double seconds) => _mounting?.Of(OfBody(seconds)) ?? OfBody(seconds);

    /// <summary>How the camera moves at a time, with mounting; null where nothing says it, and with jitter.</summary>
    /// <param name="seconds">s after the image's time.</param>
    public CameraMotion? MotionAt(double seconds) => _jitter is not null || _motionAt?.Invoke(seconds) is not { } motion ? null
        : _mounting is { } mounting ? mounting.Of(motion, _stateAt(seconds).MoonFromCamera)
        : motion;

    /// <summary>
    /// The motion about the middle of a time: the camera turns as it does on average, and has the velocity of the middle where what gives
    /// the states says it, otherwise that on average.
    /// </summary>
    /// <param name="from">s after the image's time.</param>
    /// <param name="to">s, later.</param>
    public CameraMotion MotionBetween(double from, double to)
    {
        (CameraState before, CameraState after) = (OfBody(from), OfBody(to));
        CameraMotion motion = CameraMotion.Between(
            (before.PositionBodyFixed, before.MoonFromCamera), (after.PositionBodyFixed, after.MoonFromCamera), to - from);
        double middle = 0.5 * (from + to);
        motion = _motionAt?.Invoke(middle) is { } stated ? motion with { VelocityBodyFixed = stated.VelocityBodyFixed } : motion;
        return _mounting?.Of(motion, OfBody(middle).MoonFromCamera) ?? motion;
    }

    /// <summary>The motion where the camera turns fastest in a time, so that jitter is not averaged away.</summary>
    /// <param name="from">s after the image's time.</param>
    /// <param name="to">s, later.</param>
    public CameraMotion FastestMotion(double from, double to)
    {
        double part = (to - from) / PartsOfFastest;
        return _jitter is null
            ? MotionBetween(from, to)
            : Enumerable.Range(0, PartsOfFastest).Select(index => MotionBetween(from + (index * part), from + ((index + 1) * part)))
                .MaxBy(motion => motion.AngularVelocityCamera.Length);
    }

    private CameraState OfBody(double seconds)
    {
        CameraState state = _stateAt(seconds) with { Seconds = seconds };
        return _jitter is null ? state : state with { MoonFromCamera = _jitter.Turn(state.MoonFromCamera, _jitterStart + seconds) };
    }

    /// <summary>Tells the states of exposures from others: the first half of their SHA-256, hexadecimal.</summary>
    public string Digest()
    {
        using IncrementalHash hash = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);
        foreach ((Vector3D position, UnitQuaternion turn, double seconds, _) in States)
        {
            hash.AppendData(MemoryMarshal.AsBytes<double>(
                [position.X, position.Y, position.Z, turn.X, turn.Y, turn.Z, turn.W, seconds]));
        }

        return Convert.ToHexStringLower(hash.GetHashAndReset())[..DigestDigits];
    }
}
