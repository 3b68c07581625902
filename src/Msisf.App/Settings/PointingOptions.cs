using Msisf.Adapters.Input;
using Msisf.App.Settings.Specs;
using Msisf.Core.Attitude;
using Msisf.Core.Ephemeris;
using Msisf.Core.Terrain;

namespace Msisf.App.Settings;

/// <summary>The options of a camera that is given by place and target, without quaternions.</summary>
internal static class PointingOptions
{
    public static TextSpec Position { get; } = new(
        "--position", DecidesBytes.ByStates, "LAT,LON,HEIGHT|NAME,HEIGHT",
        "Camera by latitude, longitude (degrees, east) or the name of a place (msis places), and height: m over the "
            + "sphere of 1737400 m, or terrain+m over the terrain");

    public static TextSpec LookAt { get; } = new(
        "--look-at", DecidesBytes.ByStates, "LAT,LON[,HEIGHT]|NAME[,HEIGHT]|nadir|sun|horizon:AZIMUTH",
        "With --position: what the camera looks at; a place without a height lies on the terrain; azimuths are degrees "
            + "clockwise from north")
    {
        Words = ["nadir", "sun", "horizon:"],
        Default = "nadir",
    };

    public static TextSpec OffNadir { get; } = new(
        "--off-nadir", DecidesBytes.ByStates, "ANGLE[,AZIMUTH]",
        "With --position, in place of --look-at: the line of sight's angle from the nadir (degrees), towards an azimuth (clockwise from "
            + "north; 0 if left out)");

    public static ChoiceSpec<UpDirection> Up { get; } = new(
        "--up", DecidesBytes.ByStates, [("zenith", UpDirection.Zenith), ("north", UpDirection.North), ("sun", UpDirection.Sun)],
        "With --position: what points up in the image; looking straight at or away from it, north does")
    {
        Default = UpDirection.Zenith,
    };

    public static NumberSpec Roll { get; } = new(
        "--roll", DecidesBytes.ByStates,
        "DEGREES", "With --position: turn the camera about its line of sight, clockwise as seen from behind it")
    {
        Default = 0.0,
    };

    /// <summary>The options that only a camera given by its place has.</summary>
    public static OptionSpec[] OfPosition { get; } = [LookAt, OffNadir, Up, Roll];

    /// <summary>Reads where the camera is.</summary>
    /// <exception cref="MsisfException">The value is wrong.</exception>
    public static SurfacePlace ReadPosition(OptionValues values) =>
        Position.Named(() => PointingText.ParsePosition(Position.Read(values), Body(values)));

    /// <summary>Reads how the camera points.</summary>
    /// <exception cref="MsisfException">A value is wrong, or two options contradict each other.</exception>
    public static CameraPointing ReadPointing(OptionValues values)
    {
        if (values.IsGiven(LookAt) && values.IsGiven(OffNadir))
        {
            throw new UsageException("--look-at and --off-nadir exclude each other: both say where the camera looks. Leave one out.");
        }

        CameraPointing direction = OffNadir.ReadIfGiven(values) is { } angle
            ? OffNadir.Named(() => PointingText.ParseOffNadir(angle))
            : LookAt.Named(() => PointingText.ParseTarget(LookAt.Read(values), Body(values)));
        return direction with { Up = Up.Read(values), Roll = double.DegreesToRadians(Roll.Read(values)) };
    }

    private static CelestialBody Body(OptionValues values) => CelestialBody.Of(SurfaceOptions.Body.Read(values));
}
