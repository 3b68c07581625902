using Msisf.Core.Scene;

namespace Msisf.App.DataSets;

/// <summary>A number that a data set draws for each image.</summary>
/// <param name="Key">Key in the data set's file.</param>
/// <param name="Section">Section of that key.</param>
/// <param name="Unit">Its unit; empty for a ratio.</param>
/// <param name="Least">Smallest possible.</param>
/// <param name="Greatest">Greatest possible.</param>
/// <param name="Default">How it is distributed where the file does not say it; null if it is not drawn then.</param>
/// <param name="Coordinate">Which coordinate of a point of the unit cube makes it.</param>
internal sealed record Quantity(
    string Key, string Section, string Unit, double Least, double Greatest, Distribution? Default, int Coordinate)
{
    /// <summary>Section of an image's state.</summary>
    public const string States = "states";

    /// <summary>Section of a pair's second image.</summary>
    public const string Pair = "pair";

    /// <summary>Coordinates of a point; the first two are of the place, some are of directions.</summary>
    public const int Coordinates = 16;

    /// <summary>First of two coordinates of the direction of a shift.</summary>
    public const int DirectionOfShift = 11;

    /// <summary>First of two coordinates of the axis of a turn.</summary>
    public const int AxisOfTurn = 14;

    private const double Farthest = 1e9;

    public static readonly Quantity Altitude = new("altitude", States, "m", 1.0, Farthest, null, 2);

    public static readonly Quantity OffNadir = new("off-nadir", States, "degrees", 0.0, 180.0, Distribution.Of(0.0), 3);

    public static readonly Quantity Azimuth = new("azimuth", States, "degrees", -360.0, 360.0, Distribution.Of(0.0, 360.0), 4);

    public static readonly Quantity Roll = new("roll", States, "degrees", -360.0, 360.0, Distribution.Of(0.0), 5);

    public static readonly Quantity SunElevation = new("sun-elevation", States, "degrees", -90.0, 90.0, null, 6);

    public static readonly Quantity SunAzimuth = new("sun-azimuth", States, "degrees", -360.0, 360.0, Distribution.Of(0.0, 360.0), 7);

    /// <summary>MJD, UTC.</summary>
    public static readonly Quantity Time = new("time", States, "MJD", -678575.0, 2973483.0, null, 8);

    public static readonly Quantity Exposure = new(
        "exposure-factor", States, "", SpacecraftState.LeastExposure, SpacecraftState.GreatestExposure, null, 9);

    public static readonly Quantity Shift = new("shift", Pair, "m", 0.0, Farthest, Distribution.Of(0.0), 10);

    public static readonly Quantity Turn = new("turn", Pair, "degrees", 0.0, 180.0, Distribution.Of(0.0), 13);

    public static IReadOnlyList<Quantity> All { get; } =
        [Altitude, OffNadir, Azimuth, Roll, SunElevation, SunAzimuth, Time, Exposure, Shift, Turn];
}
