namespace Msisf.Adapters.CameraExport;

/// <summary>
/// The times of a scan as USGSCSM has them, s. Those of lines and nodes count from the middle of the scan, so that they have digits enough.
/// </summary>
/// <param name="Start">Middle of the first exposure, TDB past J2000.</param>
/// <param name="Center">Middle of the scan, the same.</param>
/// <param name="FirstLine">The upper edge of the image.</param>
/// <param name="OfLine">From a line to the line below; negative where the image grows upwards.</param>
/// <param name="FirstNode">The first node of the motion.</param>
/// <param name="Sun">Its position (m) and velocity (m/s) in the middle, in the body's axes.</param>
internal sealed record ScanTimes(
    double Start, double Center, double FirstLine, double OfLine, double FirstNode, double OfNode,
    (Vector3D Position, Vector3D Velocity) Sun)
{
    public static ScanTimes Of(ExportedFrame frame)
    {
        (ExportedScan scan, ScanNodes nodes) = (frame.Scan!, frame.Csm!.Nodes);
        double length = (scan.Count - 1) * scan.Period;
        double start = frame.TdbSeconds + scan.FirstSeconds;
        double center = start + (0.5 * length);
        double first = start - center; // not half the length: the centre is rounded
        Vector3D sun = frame.SunPosition;
        Vector3D last = scan.States[^1].SunPositionBodyFixed ?? sun;
        return new ScanTimes(
            start,
            center,
            first + (scan.GrowsUpwards ? length + (0.5 * scan.Period) : -0.5 * scan.Period),
            scan.GrowsUpwards ? -scan.Period : scan.Period,
            first + (nodes.First * scan.Period),
            nodes.Spacing * scan.Period,
            (0.5 * (sun + last), length > 0.0 ? (last - sun) / length : default));
    }

    /// <summary>m/s: the velocities at positions at equal intervals.</summary>
    public static Vector3D[] Velocities(Vector3D[] positions, double interval) =>
    [
        .. positions.Select((_, i) => (Before: Math.Max(0, i - 1), After: Math.Min(i + 1, positions.Length - 1)))
            .Select(node => (positions[node.After] - positions[node.Before]) / ((node.After - node.Before) * interval)),
    ];
}
