namespace Msisf.Adapters.Interop;

/// <summary>Kernels that stay loaded in CSPICE until <see cref="Dispose"/>.</summary>
internal sealed class KernelSet : IDisposable
{
    private readonly CSpice _cspice;
    private readonly IReadOnlyList<string> _paths;
    private bool _isDisposed;

    /// <summary>Furnishes kernels.</summary>
    /// <param name="cspice">Started.</param>
    /// <param name="paths">Absolute paths in load order; a later one wins over an earlier one.</param>
    /// <exception cref="Core.Errors.SpiceException">CSPICE refuses a kernel; none stays loaded.</exception>
    public KernelSet(CSpice cspice, IReadOnlyList<string> paths)
    {
        _cspice = cspice;
        _paths = paths;
        cspice.Furnish(paths);
    }

    /// <summary>Absolute paths in load order.</summary>
    public IReadOnlyList<string> Paths
    {
        get
        {
            ObjectDisposedException.ThrowIf(_isDisposed, this);
            return _paths;
        }
    }

    public void Dispose()
    {
        if (!_isDisposed)
        {
            _isDisposed = true;
            _cspice.Unload(_paths);
        }
    }
}
