using Msisf.Core.Terrain;

namespace Msisf.Synthesis;

/// <summary>One cell of <see cref="CraterCells"/>.</summary>
/// <param name="Band">Counted from the south.</param>
/// <param name="Column">Counted from longitude 0.</param>
/// <param name="Columns">Number of columns of the band.</param>
/// <param name="SouthSine">Sine of the southern border's latitude.</param>
/// <param name="NorthSine">Sine of the northern border's latitude.</param>
internal readonly record struct CraterCell(int Band, int Column, int Columns, double SouthSine, double NorthSine)
{
    /// <summary>Area of the cell on the reference sphere, m2.</summary>
    public double Area =>
        2.0 * Math.PI * MoonConstants.ReferenceRadius * MoonConstants.ReferenceRadius * (NorthSine - SouthSine) / Columns;

    /// <summary>A place in the cell; equal areas of the unit square are equal areas of the cell.</summary>
    /// <param name="up">[0, 1).</param>
    /// <param name="right">[0, 1).</param>
    public (double SinLatitude, double LongitudeDegrees) Place(double up, double right) =>
        (SouthSine + (up * (NorthSine - SouthSine)), (Column + right) * 360.0 / Columns);
}
