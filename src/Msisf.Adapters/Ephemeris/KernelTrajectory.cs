using Msisf.Core.Ephemeris;
using Msisf.Core.Orbit;
using Msisf.Core.Time;

namespace Msisf.Adapters.Ephemeris;

/// <summary>The trajectory of a spacecraft in SPK kernels.</summary>
public sealed class KernelTrajectory : ITrajectory
{
    private readonly IEphemeris _engine;
    private readonly int _number;
    private readonly string _name;
    private readonly string _files;

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
        _files = string.Join(", ", opened.Catalogue.Files.Where(file => file.IdWord == "DAF/SPK" && file.Summaries.Any(
            summary => summary.Integers[0] == _number)).Select(file => file.FileName));
        _ = opened.Catalogue.SegmentsOf("DAF/SPK"); // names a damaged one, whichever engine reads it
    }

    /// <inheritdoc/>
    public TdbCover Cover { get; }

    /// <inheritdoc/>
    public StateVector StateJ2000(TdbTime time)
    {
        if (!Cover.Contains(time))
        {
            throw new BadInputException(Invariant(
                $"{_engine.TimeScale.InstantOf(time).ToIsoUtc()} is outside what the kernels have of {_name}: "
                    + $"{new KernelCover(_engine.TimeScale, Cover).Describe()}. Choose a time inside, or other kernels."));
        }

        StateVector state = _engine.StateOf(_number, time);
        return state.Position.IsFinite && state.Velocity.IsFinite
            ? state
            : throw new BadInputException($"{_files}: damaged kernel: the state of {_name} is not finite. Get the file anew.");
    }
}
