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
        Ask(kernels => _cspice.StateOf(kernels, naifNumber, _body, time.Seconds), () => TimeScale.InstantOf(time));

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

    private T Ask<T>(Func<IReadOnlyList<string>, T> question, Func<Instant> time)
    {
        try
        {
            return question(Open());
        }
        catch (SpiceException exception)
        {
            KernelCover? cover = ReadCover();
            throw cover is null || cover.Contains(time()) ? exception : cover.Outside(time(), exception);
        }
    }

    /// <summary>
    /// The times that the kernels cover, which CSPICE's errors do not tell; null if the built-in reader can't read the kernels.
    /// </summary>
    private KernelCover? ReadCover()
    {
        try
        {
            using BuiltInKernels readable = new(Open(), _body);
            return readable.Ephemeris.Cover;
        }
        catch (MsisfException)
        {
            // CSPICE takes kernels that the built-in reader does not know; then its own message has to do.
            return null;
        }
    }
}
