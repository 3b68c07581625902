namespace Msisf.Core.Numerics;

/// <summary>Every tolerance of the program, with its unit and the reason for its size.</summary>
public static class Tolerances
{
    /// <summary>1: how far a quaternion's length may be from 1. Users print 7 digits; a real slip (a swapped or missing component) is far larger.</summary>
    public const double UnitQuaternionLength = 1e-6;

    /// <summary>1, parts of a step: within this a time interval's end counts as reached, as MATLAB's colon does.</summary>
    public const double IntervalSteps = 1e-9;

    /// <summary>1, sine of an angle: vectors this near to parallel count as parallel. Rounding their components to doubles turns them by up to a quarter of it.</summary>
    public const double ParallelSine = 1e-15;
}
