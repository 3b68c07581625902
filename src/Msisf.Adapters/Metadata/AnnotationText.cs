using Msisf.Core.Metadata;

namespace Msisf.Adapters.Metadata;

/// <summary>The text block of an annotated image (thesis figure 9.1), with rounded numbers; the meta file has all digits.</summary>
internal static class AnnotationText
{
    /// <summary>The lines of the block, in ASCII: the built-in font has no more.</summary>
    public static string[] Lines(FrameMetadata frame)
    {
        UnitQuaternion orientation = frame.Camera.MoonFromCamera;
        return
        [
            Format($"Simulation time:    {frame.SimulationTime.ToIsoUtc()} (MJD {frame.SimulationTime.Days:R})"),
            Format($"S/C position:       {Components(frame.Camera.PositionBodyFixed)} m"),
            Format($"S/C orientation:    {orientation.X:F6}, {orientation.Y:F6}, {orientation.Z:F6}, {orientation.W:F6} (x, y, z, r)"),
            Format($"Sun position:       {Components(frame.SunPositionBodyFixed)} m"),
            Format($"Flight altitude:    {frame.FlightAltitude:F0} m ({frame.HeightOverTerrain:F0} m over the terrain)"),
            Format($"Elevation model:    {frame.Elevation.ProductId}{(frame.Elevation.IsSynthetic ? " (SYNTHETIC)" : string.Empty)}"),
            Format($"Surface resolution: {frame.Elevation.Resolution}{Drawn(frame.Elevation)}"),
            Format($"Field of view:      {frame.FieldOfViewDegrees:R} deg"),
            Format($"MSIS version:       {frame.Version}"),
        ];
    }

    /// <summary>The levels of detail, where the model itself is not all that was drawn.</summary>
    private static string Drawn(DrawnElevation elevation) => elevation.CoarsestDrawn == elevation.Resolution ? string.Empty
        : elevation.CoarsestDrawn == elevation.FinestDrawn ? Format($", drawn at {elevation.FinestDrawn.NumberText}")
        : Format($", drawn at {elevation.CoarsestDrawn.NumberText} to {elevation.FinestDrawn.NumberText}");

    private static string Components(Vector3D v) => Format($"{v.X:F0}, {v.Y:F0}, {v.Z:F0}");

    private static string Format(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
