namespace Msisf.Core.Tiles.Selection;

/// <summary>Where a piece of the surface can lie in the half planes of a <see cref="PolarView"/>.</summary>
/// <param name="Near">Minimum <see cref="PolarPoint.Arc"/>.</param>
/// <param name="Far">Maximum arc.</param>
/// <param name="Azimuth">Azimuth of the middle, rad.</param>
/// <param name="HalfWidth">Half of the range of azimuths, rad; pi or more is the whole circle.</param>
/// <param name="MinSlope">Minimum slope of the lines of sight to the piece.</param>
/// <param name="MaxSlope">Maximum slope of the lines of sight to the piece.</param>
internal readonly record struct PolarBounds(
    double Near, double Far, double Azimuth, double HalfWidth, double MinSlope, double MaxSlope)
{
    /// <summary>
    /// The bounds of the piece if it is seen higher by a small angle: slopes are cotangents of the angle from the axis.
    /// </summary>
    /// <param name="angle">rad.</param>
    public PolarBounds Raised(double angle) => this with { MaxSlope = MaxSlope + (angle * (1.0 + (MaxSlope * MaxSlope))) };

    /// <summary>Whether one ray from the viewpoint can meet both.</summary>
    public bool CanShareRayWith(in PolarBounds other)
    {
        if (MinSlope > other.MaxSlope || other.MinSlope > MaxSlope)
        {
            return false;
        }

        double apart = Math.Abs(Azimuth - other.Azimuth);
        return Math.Min(apart, (2.0 * Math.PI) - apart) <= HalfWidth + other.HalfWidth;
    }
}
