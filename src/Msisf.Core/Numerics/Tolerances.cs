namespace Msisf.Core.Numerics;

/// <summary>Every tolerance of the program, with its unit and the reason for its size.</summary>
public static class Tolerances
{
    /// <summary>1: how far a quaternion's length may be from 1. Users print 7 digits; a real slip (a swapped or missing component) is far larger.</summary>
    public const double UnitQuaternionLength = 1e-6;

    /// <summary>1, parts of a step: within this a time interval's end counts as reached, as MATLAB's colon does.</summary>
    public const double IntervalSteps = 1e-9;

    /// <summary>m: how far a label's sphere may be from its OFFSET. Both are printed to 0.1 m; a wrong sphere is off by metres.</summary>
    public const double LabelRadius = 1e-3;

    /// <summary>1, parts of MAXIMUM - MINIMUM: how far a float sample may pass a label's limits, which are printed with few digits.</summary>
    public const double FloatSampleLimits = 1e-3;
}
