namespace Msisf.Core.Numerics;

/// <summary>Every tolerance of the program, with its unit and the reason for its size.</summary>
public static class Tolerances
{
    /// <summary>
    /// 1: how far a quaternion's length may be from 1. Users print 7 digits; a real slip (a swapped or missing component) is far larger.
    /// </summary>
    public const double UnitQuaternionLength = 1e-6;

    /// <summary>
    /// How far four components that were divided by their length may be from length 1: half a unit of the last place each, and the
    /// roundings of the length itself.
    /// </summary>
    public const double RoundedUnitLength = 4.0 / (1L << 52);

    /// <summary>1, parts of a step: within this a time interval's end counts as reached, as MATLAB's colon does.</summary>
    public const double IntervalSteps = 1e-9;

    /// <summary>
    /// 1: how far a frame kernel's matrix may be from a rotation. The engines shall agree to 1e-12, and CSPICE mends a worse matrix before
    /// use.
    /// </summary>
    public const double FrameMatrix = 1e-12;

    /// <summary>
    /// rad: the minimum field of view. A viewing direction is rounded by about 4e-16 rad; an image 2500 times that wide still has digits.
    /// </summary>
    public const double MinFieldOfView = 1e-12;

    /// <summary>
    /// 1: sine of the Sun's zenith angle times the sine between ground line and line of sight, as much as the image shows of it (the
    /// component across the viewing axis of the normal of their plane), below which a pixel's illumination direction counts as undefined.
    /// Hit point and Sun direction are rounded by about 1e-15 rad, so the angle that is left would be wrong by up to 1e-8 rad; on the
    /// ground it is 0.17 m around the sub-solar point.
    /// </summary>
    public const double IlluminationDirectionSine = 1e-7;

    /// <summary>m: how far a label's sphere may be from its OFFSET. Both are printed to 0.1 m; a wrong sphere is off by metres.</summary>
    public const double LabelRadius = 1e-3;

    /// <summary>
    /// 1, parts of MAXIMUM - MINIMUM: how far a float sample may pass a label's limits, which are printed with few digits.
    /// </summary>
    public const double FloatSampleLimits = 1e-3;

    /// <summary>
    /// 1, sine of an angle: vectors this near to parallel count as parallel. Rounding their components to doubles turns them by up to a
    /// quarter of it.
    /// </summary>
    public const double ParallelSine = 1e-15;

    /// <summary>
    /// m: twice the 2^-7 m step of the lattice on which mesh vertices lie (docs/pattern-format.md), so more than rounding moves one.
    /// </summary>
    public const double VertexLattice = 0.016;

    /// <summary>rad: the same at the lunar radius, and the rounding of a cap's own sine and cosine.</summary>
    public const double CapRadius = 2e-8;

    /// <summary>
    /// rad: added to the azimuths of an image for what lies within <see cref="VertexLattice"/> of its border, 20 m and more from the axis.
    /// </summary>
    public const double WindowMargin = 1e-3;

    /// <summary>
    /// m: a point of the surface in light space, a sum of two of its components, and a line through two such points are rounded by less.
    /// </summary>
    public const double LightPoint = 4e-9;

    /// <summary>
    /// 1: cosine of an incidence or emission angle below which Hapke's roughness takes this one. Towards 0 its quotients become 0 / 0;
    /// here 7 digits are left, and the radiance factor is 1e-9 or no longer changes.
    /// </summary>
    public const double GrazingCosine = 1e-9;
}
