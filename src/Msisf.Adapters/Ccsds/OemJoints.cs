using Msisf.Core.Ephemeris;

namespace Msisf.Adapters.Ccsds;

/// <summary>
/// Finds lines of an OEM whose positions and velocities contradict each other: parts that were joined without a new block, or velocities
/// of another unit or frame.
/// </summary>
internal sealed class OemJoints
{
    /// <summary>m: below this, positions are rounded.</summary>
    private const double Rounding = 1.0;

    /// <summary>
    /// 1: the way between two lines is the mean of their velocities times the time, but for h^2 / 12 of the change of the acceleration;
    /// that is at most a sixth of h times the change of velocity while the acceleration at most doubles. Of Artemis I's 9,210 pairs of
    /// lines 73 are above this with the rounding, all others below 0.8 of it.
    /// </summary>
    private const double MaxPart = 0.25;

    private double _time;
    private StateVector _state;
    private bool _isFirst;
    private int _count;
    private int _firstLine;
    private double _greatest;
    private int _greatestLine;

    /// <summary>What is to be said, behind the file's name; null if no lines contradict each other.</summary>
    public string? Warning => _count == 0 ? null : Invariant(
        $", line {_firstLine}: position and velocity contradict those of the line before, and so {_count} times, most in line "
            + $"{_greatestLine} by {_greatest / 1000.0:0.0##} km. Either parts were joined without a new block, and states within some "
            + $"lines of such a place may be that far off; or the velocities are of another unit or frame.");

    /// <summary>The next line has none before it.</summary>
    public void BeginBlock() => _isFirst = true;

    /// <summary>Takes a line.</summary>
    /// <param name="time">s.</param>
    /// <param name="state">Position (m) and velocity (m/s); a velocity of 0 is none.</param>
    public void Add(double time, StateVector state, int line)
    {
        if (!_isFirst && state.Velocity != default && _state.Velocity != default)
        {
            double step = time - _time;
            Vector3D mean = 0.5 * (_state.Velocity + state.Velocity);
            double error = (state.Position - _state.Position - (step * mean)).Length;
            if (error > Rounding + (MaxPart * step * (state.Velocity - _state.Velocity).Length))
            {
                _firstLine = _count++ == 0 ? line : _firstLine;
                (_greatest, _greatestLine) = error > _greatest ? (error, line) : (_greatest, _greatestLine);
            }
        }

        (_time, _state, _isFirst) = (time, state, false);
    }
}
