namespace Msisf.Core.Numerics;

/// <summary>Every tolerance of the program, with its unit and the reason for its size.</summary>
public static class Tolerances
{
    /// <summary>
    /// 1: how far a quaternion's length may be from 1. Users print 7 digits; a real mistake (a swapped or missing component) is far
    /// larger.
    /// </summary>
    public const double UnitQuaternionLength = 1e-6;

    /// <summary>
    /// 1: how far the length of a quaternion in an attitude file may be from 1: that of five decimals. The standard's own examples are
    /// off by 2e-6.
    /// </summary>
    public const double PrintedQuaternionLength = 1e-5;

    /// <summary>
    /// 1: how far a quaternion's length may be from 1, or a matrix from a rotation, if the user says that its numbers are rounded: that of
    /// two decimals.
    /// </summary>
    public const double RoundedRotation = 0.01;

    /// <summary>
    /// 1: how far a matrix that a user gives may be from a rotation: as <see cref="UnitQuaternionLength"/>, 7 decimals and some room.
    /// </summary>
    public const double RotationMatrixEntry = 1e-6;

    /// <summary>
    /// 1: how far from 1 the length may be after four components were divided by it. Each component is rounded by half a unit in the last
    /// place, and the length is rounded too.
    /// </summary>
    public const double RoundedUnitLength = 4.0 / (1L << 52);

    /// <summary>1, parts of a step: within this a time interval's end counts as reached, as MATLAB's colon does.</summary>
    public const double IntervalSteps = 1e-9;

    /// <summary>
    /// 1: how far a frame kernel's matrix may be from a rotation: that of three decimals. Like CSPICE, the reader makes it one before use.
    /// </summary>
    public const double PrintedMatrix = 1e-3;

    /// <summary>
    /// rad: the minimum field of view. A viewing direction is rounded by about 4e-16 rad; an image 2500 times as wide still has distinct
    /// directions.
    /// </summary>
    public const double MinFieldOfView = 1e-12;

    /// <summary>
    /// 1: below this, a pixel's illumination direction counts as undefined. It limits the sine of the Sun's zenith angle times the sine
    /// of the angle between ground line and line of sight; only the component that the image shows counts (of the normal of their plane,
    /// the part perpendicular to the viewing axis). Hit point and Sun direction are rounded by about 1e-15 rad, so at the limit the angle
    /// is wrong by up to 1e-8 rad. On the ground the limit is 0.17 m around the sub-solar point.
    /// </summary>
    public const double IlluminationDirectionSine = 1e-7;

    /// <summary>
    /// 1: below this sine of the zenith's angle to the polar axis or to the target, an azimuth counts as undefined. Points and directions
    /// are rounded by about 1e-15 rad, so at the limit the azimuth is wrong by up to 1e-6 rad. On the ground the limit is 2 mm.
    /// </summary>
    public const double AzimuthSine = 1e-9;

    /// <summary>m: how far a label's sphere may be from its OFFSET. Both are printed to 0.1 m; a wrong sphere is off by metres.</summary>
    public const double LabelRadius = 1e-3;

    /// <summary>
    /// 1, parts of MAXIMUM - MINIMUM: how far a float sample may pass a label's limits, which are printed with few digits.
    /// </summary>
    public const double FloatSampleLimits = 1e-3;

    /// <summary>
    /// 1, sine of an angle: vectors with a smaller angle between them count as parallel. Rounding their components to doubles turns them
    /// by up to a quarter of this.
    /// </summary>
    public const double ParallelSine = 1e-15;

    /// <summary>
    /// 1, sine of an angle: what is nearer to the line of sight than this points neither up nor down in the image. A camera that looks
    /// straight down from 1 m sees its target off by 4e-9 rad, because positions are rounded.
    /// </summary>
    public const double UpAlongBoresight = 1e-6;

    /// <summary>
    /// m: limits how far rounding moves a mesh vertex; twice the 2^-7 m step of the lattice on which vertices lie
    /// (docs/pattern-format.md).
    /// </summary>
    public const double VertexLattice = 0.016;

    /// <summary>
    /// rad: limits the error of a cap's radius: <see cref="VertexLattice"/> seen from the Moon's centre (9.2e-9 rad), and the rounding of
    /// the cap's own sine and cosine.
    /// </summary>
    public const double CapRadius = 2e-8;

    /// <summary>
    /// m: limits the rounding error of a surface point in light space, of a sum of two of its components, and of a line through two such
    /// points.
    /// </summary>
    public const double LightPoint = 4e-9;

    /// <summary>
    /// 1: minimum cosine of an incidence or emission angle in Hapke's roughness correction; smaller ones are replaced by it. Towards 0
    /// the quotients become 0 / 0; at this value 7 digits are left, and the radiance factor is 1e-9 or no longer changes.
    /// </summary>
    public const double GrazingCosine = 1e-9;

    /// <summary>1: slope below which rounding of the normal, a few 1e-16, decides in which direction the ground falls.</summary>
    public const double LevelSlope = 1e-14;

    /// <summary>
    /// Cosine of incidence, by which a facet must differ from a right angle to the Sun so that each point of it has the same sign: far
    /// above rounding.
    /// </summary>
    public const double FacingOfFacet = 1e-6;

    /// <summary>
    /// 1, parts of an interval's greatest number: what rounding may add to its ends, of which a few thousand operations use a millionth.
    /// </summary>
    public const double IntervalRounding = 1e-9;
}
