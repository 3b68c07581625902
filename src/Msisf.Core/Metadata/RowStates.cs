namespace Msisf.Core.Metadata;

/// <summary>The states of an image's rows, as files hold them.</summary>
public static class RowStates
{
    /// <summary>
    /// What the numbers of a row are: s after the image's time; position (m), the quaternion that turns camera axes (looks along -x, y
    /// right,
    /// z up) into those of the body, position of the light (m).
    /// </summary>
    public static IReadOnlyList<string> Names { get; } = ["seconds", "x", "y", "z", "qx", "qy", "qz", "q0", "sunX", "sunY", "sunZ"];

    /// <summary>The numbers of all rows, row by row from the top; empty for an image of one state.</summary>
    public static double[] Of(FrameMetadata frame)
    {
        if (frame.Scan is null)
        {
            return [];
        }

        double[] numbers = new double[Names.Count * frame.Camera.Height];
        for (int row = 0; row < frame.Camera.Height; row++)
        {
            Of(frame, row + 1).CopyTo(numbers, row * Names.Count);
        }

        return numbers;
    }

    /// <summary>The numbers of a row.</summary>
    /// <param name="frame">The image.</param>
    /// <param name="y">1 to the image's height.</param>
    public static double[] Of(FrameMetadata frame, int y)
    {
        (Vector3D position, UnitQuaternion turn, double seconds, Vector3D? sun) = frame.Camera.BandAt(y).Camera.State;
        Vector3D light = sun ?? position;
        return [seconds, position.X, position.Y, position.Z, turn.X, turn.Y, turn.Z, turn.W, light.X, light.Y, light.Z];
    }
}
