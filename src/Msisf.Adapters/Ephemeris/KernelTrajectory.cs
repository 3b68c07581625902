using System.Globalization;
using Msisf.Core.Ephemeris;
using Msisf.Core.Errors;
using Msisf.Core.Orbit;

namespace Msisf.Adapters.Ephemeris;

/// <summary>The trajectory of a spacecraft in SPK kernels.</summary>
public sealed class KernelTrajectory : ITrajectory
{
    private readonly IEphemeris _engine;
    private readonly int _number;
    private readonly string _name;

    /// <summary>Looks for the spacecraft.</summary>
    /// <param name="opened">The engine with its kernels.</param>
    /// <param name="spacecraft">Name or number.</param>
    /// <exception cref="BadInputException">No kernel has it; the message says what the kernels have.</exception>
    public KernelTrajectory(OpenedEphemeris opened, string spacecraft)
    {
        _engine = opened.Engine;
        _number = opened.Catalogue.SpacecraftOf(spacecraft, out TdbCover cover);
        _name = opened.Catalogue.Names.Describe(_number);
        Cover = cover;
    }

    /// <inheritdoc/>
    public TdbCover Cover { get; }

    /// <inheritdoc/>
    public StateVector StateJ2000(double tdbSeconds) => Cover.Contains(tdbSeconds)
        ? _engine.StateOf(_number, tdbSeconds)
        : throw new BadInputException(string.Create(
            CultureInfo.InvariantCulture,
            $"{_engine.TimeScale.ToUtc(tdbSeconds).ToIsoUtc()} is outside what the kernels have of {_name}: "
                + $"{new KernelCover(_engine.TimeScale, Cover).Describe()}. Choose a time inside, or other kernels."));
}
