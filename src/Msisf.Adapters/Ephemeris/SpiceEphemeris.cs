using Msisf.Adapters.Interop;
using Msisf.Core.Ephemeris;
using Msisf.Core.Time;

namespace Msisf.Adapters.Ephemeris;

/// <summary>The engine that asks NAIF's CSPICE. Safe for several threads, which take turns.</summary>
public sealed class SpiceEphemeris : IEphemeris, ISpaceFrames, IDisposable
{
    private readonly CSpice _cspice;
    private readonly IReadOnlyList<string> _paths;
    private readonly CelestialBody _body;
    private readonly Lazy<TimeScale> _timeScale;
    private bool _isDisposed;

    /// <summary>Loads kernels into CSPICE, which must be started.</summary>
    /// <param name="paths">Absolute paths in load order; a later one wins over an earlier one.</param>
    /// <exception cref="BadInputException">None of them has the orientation of a body other than the Moon.</exception>
    internal SpiceEphemeris(CSpice cspice, IReadOnlyList<string> paths, CelestialBody body)
    {
        (_cspice, _paths, _body) = (cspice, paths, body);
        _timeScale = new Lazy<TimeScale>(() => LeapSecondsKernel.ReadScale(paths));
        cspice.Furnish(paths);
        if (!body.IsMoon && !cspice.HasVariable(paths, body.NaifNumber, PoleKernel.PoleItem))
        {
            Dispose();
            throw PoleKernel.Missing(body);
        }
    }

    /// <inheritdoc/>
    public string EngineName => _cspice.Version.Replace('_', ' ');

    /// <inheritdoc/>
    public TimeScale TimeScale => _timeScale.Value;

    /// <inheritdoc/>
    public Vector3D SunPositionBodyFixed(Instant time, Aberration aberration = Aberration.None) =>
        Ask(kernels => _cspice.SunPosition(kernels, _body, time.Tdb.Seconds, aberration), () => time);

    /// <inheritdoc/>
    public RotationMatrix BodyFromJ2000(TdbTime time) =>
        Ask(kernels => _cspice.FrameFromJ2000(kernels, _body.Frame, time.Seconds), () => TimeScale.InstantOf(time));

    /// <inheritdoc/>
    public Vector3D BodyRateJ2000(TdbTime time) =>
        Ask(kernels => _cspice.RateJ2000(kernels, _body.Frame, time.Seconds), () => TimeScale.InstantOf(time));

    /// <inheritdoc/>
    public RotationMatrix FrameFromJ2000(string frame, TdbTime time) =>
        _cspice.FrameFromJ2000(Open(), frame, time.Seconds);

    /// <inheritdoc/>
    public StateVector StateOf(int naifNumber, TdbTime time) =>
        Ask(
            kernels => _cspice.StateOf(kernels, naifNumber, _body, time.Seconds),
            () => TimeScale.InstantOf(time),
            engine => engine.StateOf(naifNumber, time));

    /// <summary>Unloads the kernels.</summary>
    public void Dispose()
    {
        if (!_isDisposed)
        {
            _isDisposed = true;
            _cspice.Unload(_paths);
        }
    }

    private IReadOnlyList<string> Open()
    {
        ObjectDisposedException.ThrowIf(_isDisposed, this);
        return _paths;
    }

    /// <param name="again">The same question to the other engine, whose error says what to do; null for none.</param>
    private T Ask<T>(Func<IReadOnlyList<string>, T> question, Func<Instant> time, Action<IEphemeris>? again = null)
    {
        try
        {
            return question(Open());
        }
        catch (SpiceException exception)
        {
            throw Explained(exception, time, again);
        }
    }

    /// <summary>An error with the advice that CSPICE's own lacks: which times the kernels cover, or what they do not have.</summary>
    private SpiceException Explained(SpiceException exception, Func<Instant> time, Action<IEphemeris>? again)
    {
        using BuiltInKernels? readable = Readable();
        if (readable is null)
        {
            return exception;
        }

        KernelCover cover = readable.Ephemeris.Cover;
        if (!cover.Contains(time()))
        {
            return cover.Outside(time(), exception);
        }

        try
        {
            again?.Invoke(readable.Ephemeris);
        }
        catch (SpiceException own)
        {
            return new SpiceException(own.Message, exception);
        }

        return exception;
    }

    /// <summary>The kernels as the built-in reader has them; null if it can't read them.</summary>
    private BuiltInKernels? Readable()
    {
        try
        {
            return new BuiltInKernels(Open(), _body);
        }
        catch (MsisfException)
        {
            // CSPICE takes kernels that the built-in reader does not know; then its own message has to do.
            return null;
        }
    }
}
