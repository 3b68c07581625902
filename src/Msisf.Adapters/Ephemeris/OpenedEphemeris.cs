using Msisf.Core.Ephemeris;

namespace Msisf.Adapters.Ephemeris;

/// <summary>An ephemeris engine, with the kernels that it holds open until <see cref="Dispose"/>.</summary>
public sealed class OpenedEphemeris : IDisposable
{
    private readonly IDisposable _resources;

    internal OpenedEphemeris(IEphemeris engine, EphemerisChoice choice, string notice, IDisposable resources)
    {
        Engine = engine;
        Choice = choice;
        Notice = notice;
        _resources = resources;
    }

    /// <summary>The engine.</summary>
    public IEphemeris Engine { get; }

    /// <summary>Which engine it is; not <see cref="EphemerisChoice.Auto"/>.</summary>
    public EphemerisChoice Choice { get; }

    /// <summary>One line for the run's log: which engine, and why.</summary>
    public string Notice { get; }

    /// <inheritdoc/>
    public void Dispose() => _resources.Dispose();
}
