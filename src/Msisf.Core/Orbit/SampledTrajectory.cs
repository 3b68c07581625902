using Msisf.Core.Ephemeris;
using Msisf.Core.Time;

namespace Msisf.Core.Orbit;

/// <summary>A trajectory from a file of states. As thread-safe as its ephemeris.</summary>
public sealed class SampledTrajectory : ITrajectory
{
    private readonly IReadOnlyList<TrajectoryBlock> _blocks;
    private readonly BlockTimes _times;
    private readonly IEphemeris _ephemeris;

    /// <summary>Takes the file's blocks.</summary>
    /// <param name="blocks">In the order of the file, each with at least one sample.</param>
    /// <param name="source">The file's name, for messages.</param>
    /// <param name="ephemeris">Where other centres are, and how the Moon turns.</param>
    public SampledTrajectory(IReadOnlyList<TrajectoryBlock> blocks, string source, IEphemeris ephemeris)
    {
        (_blocks, _ephemeris) = (blocks, ephemeris);
        _times = new BlockTimes([.. blocks.Select(block => block.Samples.Cover)], source, ephemeris.TimeScale);
    }

    /// <inheritdoc/>
    public TdbCover Cover => _times.Cover;

    /// <inheritdoc/>
    public StateVector StateJ2000(TdbTime time)
    {
        TrajectoryBlock block = _blocks[_times.Find(time)];
        StateVector state = block.Samples.At(time);
        if (block.MoonMeFromFrame is { } moonMeFromFrame)
        {
            state = TurningMoon.ToJ2000(state, moonMeFromFrame, time, _ephemeris);
        }

        if (block.Center == CelestialBody.Moon.NaifNumber)
        {
            return state;
        }

        StateVector center = _ephemeris.StateOf(block.Center, time);
        return new StateVector(center.Position + state.Position, center.Velocity + state.Velocity);
    }
}

/// <summary>A part of a trajectory, whose states are of one frame and centre.</summary>
/// <param name="Center">NAIF's number of the body about which they are.</param>
/// <param name="MoonMeFromFrame">
/// For a frame that turns with the Moon, the constant rotation to MOON_ME; null for J2000's axes.
/// </param>
public sealed record TrajectoryBlock(StateSamples Samples, int Center, RotationMatrix? MoonMeFromFrame);
