using Msisf.Core.Ephemeris;

namespace Msisf.Adapters.Ephemeris;

/// <summary>An ephemeris engine, with the kernels that it holds open until <see cref="Dispose"/>.</summary>
public sealed class OpenedEphemeris : IDisposable
{
    private readonly IDisposable _resources;
    private readonly Lazy<KernelCatalogue> _catalogue;

    internal OpenedEphemeris(
        IEphemeris engine, EphemerisChoice choice, string notice, IDisposable resources, Func<KernelCatalogue> catalogue)
    {
        _catalogue = new Lazy<KernelCatalogue>(catalogue);
        Engine = engine;
        Choice = choice;
        Notice = notice;
        _resources = resources;
    }

    /// <summary>The engine.</summary>
    public IEphemeris Engine { get; }

    /// <summary>Which engine it is; not <see cref="EphemerisChoice.Auto"/>.</summary>
    public EphemerisChoice Choice { get; }

    /// <summary>What the kernels hold; read on first use.</summary>
    /// <exception cref="Core.Errors.BadInputException">A kernel can't be read.</exception>
    public KernelCatalogue Catalogue => _catalogue.Value;

    /// <summary>Frames of spacecraft and instruments, by the same engine.</summary>
    public ISpaceFrames Frames => Engine as ISpaceFrames ?? Catalogue.Frames;

    /// <summary>One line for the run's log: which engine, and why.</summary>
    public string Notice { get; }

    /// <inheritdoc/>
    public void Dispose()
    {
        _resources.Dispose();
        if (_catalogue.IsValueCreated)
        {
            _catalogue.Value.Dispose();
        }
    }
}
