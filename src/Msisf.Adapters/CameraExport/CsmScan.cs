using Msisf.Core.Camera;

namespace Msisf.Adapters.CameraExport;

/// <summary>A scan as USGSCSM has it: the detector of all exposures, and the camera's motion at equal intervals.</summary>
/// <param name="Sensor">The detector and lens.</param>
/// <param name="Misfit">px: what a line-scan leaves of a rolling shutter, whose rows it has as one row that turns.</param>
internal sealed record CsmScan(CsmSensor Sensor, ScanNodes Nodes, double Misfit)
{
    /// <summary>px: errors up to it are promised, and not worth a warning.</summary>
    public const double Promised = 1e-3;

    /// <summary>Part of the least height over the terrain within which ground may be seen.</summary>
    private const double NearestGround = 0.5;

    /// <summary>Makes it.</summary>
    public static CsmScan Of(CameraModel camera, ExportedScan scan)
    {
        RollingRow? rolling = scan.Kind == ScanKind.RollingShutter ? RollingRow.Of(camera) : null;
        CameraModel exposed = rolling?.Line ?? camera;
        CsmSensor sensor = CsmSensor.Of(exposed, scan);
        (Vector3D Direction, RenderingPoint Point)[] seen = [.. Corners(exposed)];
        double range = NearestGround * Math.Abs(scan.HeightOverTerrain);
        (Vector3D Position, UnitQuaternion Turn)[] poses = [.. scan.States.Select((state, row) => (
            state.PositionBodyFixed, rolling is null ? OpenCvOf(state) : OpenCvOf(state) * rolling.Turns[row]))];
        ScanNodes nodes = ScanNodes.Of(poses, (exposure, other) => Shift(poses[exposure], other));
        return new CsmScan(
            sensor, nodes with { Poses = [.. nodes.Poses.Select(pose => (pose.Position, sensor.BodyFrom(pose.Turn)))] },
            rolling?.Misfit ?? 0.0);

        double Shift((Vector3D Position, UnitQuaternion Turn) pose, (Vector3D Position, UnitQuaternion Turn) other)
        {
            UnitQuaternion turn = other.Turn.Conjugate * pose.Turn;
            Vector3D moved = other.Turn.Conjugate * (pose.Position - other.Position) / range;
            return seen.Max(corner =>
            {
                Vector3D at = (turn * corner.Direction) + moved;
                return exposed.TryToImage(at.X / at.Z, at.Y / at.Z, out RenderingPoint there)
                    ? double.Hypot(there.X - corner.Point.X, there.Y - corner.Point.Y)
                    : double.PositiveInfinity;
            });
        }
    }

    /// <summary>How exact it is, one line for the user.</summary>
    /// <param name="name">Name of the image.</param>
    /// <param name="period">s from one exposure to the next.</param>
    public string Describe(string name, double period) => Invariant(
        $"Camera model of {name}: {Nodes.Poses.Count} nodes of its motion, {Nodes.Spacing * period:G4} s apart")
        + (Nodes.Error == 0.0 ? ", exact in each row." : Invariant($"; off by {Nodes.Error:G1} px at most between them."))
        + (Misfit <= Promised ? string.Empty : Invariant(
            $" As a line-scan has one focal length for all rows, a rolling shutter is off by up to {Misfit:G2} px too; the narrower its "
                + $"view the less."));

    /// <summary>Turns OpenCV's camera axes into the body's.</summary>
    private static UnitQuaternion OpenCvOf(CameraState state) => state.MoonFromCamera * States.StateTables.CameraFromOpenCv;

    /// <summary>Ends and middle of the first and last rows: directions of length 1 along OpenCV's axes, and points of the image.</summary>
    private static IEnumerable<(Vector3D Direction, RenderingPoint Point)> Corners(CameraModel camera) =>
        from x in (double[])[1.0, 0.5 * (1.0 + camera.Width), camera.Width]
        from y in (double[])[1.0, camera.Height]
        let ideal = camera.ToIdeal(x, y)
        select (new Vector3D(ideal.Right, ideal.Down, 1.0).Normalized(), new RenderingPoint(x, y));
}

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
