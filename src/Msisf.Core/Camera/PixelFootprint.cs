namespace Msisf.Core.Camera;

/// <summary>The width that a pixel of an image covers at a distance.</summary>
public sealed class PixelFootprint
{
    private readonly Vector3D _forward;
    private readonly double _cosCorner;

    /// <summary>Takes the image.</summary>
    /// <param name="positionBodyFixed">Where the rays come from, m, body-fixed.</param>
    /// <param name="forwardBodyFixed">Viewing direction, body-fixed, length 1.</param>
    /// <param name="tangent">Tangent of the angle of a pixel in the middle of the image.</param>
    /// <param name="cosCorner">Cosine of the angle between the viewing direction and a corner of the image.</param>
    internal PixelFootprint(Vector3D positionBodyFixed, Vector3D forwardBodyFixed, double tangent, double cosCorner)
    {
        PositionBodyFixed = positionBodyFixed;
        _forward = forwardBodyFixed;
        Tangent = tangent;
        _cosCorner = cosCorner;
    }

    /// <summary>Where the rays come from, m, body-fixed.</summary>
    public Vector3D PositionBodyFixed { get; }

    /// <summary>Tangent of the angle of a pixel in the middle of the image.</summary>
    public double Tangent { get; }

    /// <summary>Minimum width that a pixel covers across the line of sight anywhere in a ball, m; 0 if the camera is in it.</summary>
    /// <param name="ball">Centre (m, MOON_ME) and radius (m).</param>
    public double MinWidth((Vector3D CentreBodyFixed, double Radius) ball)
    {
        Vector3D toCentre = ball.CentreBodyFixed - PositionBodyFixed;
        double distance = toCentre.Length;

        // Towards the corners of a flat image a pixel covers a smaller angle: along the radius, by the square of the cosine.
        double cos = Math.Clamp(Vector3D.Dot(toCentre, _forward) / distance, _cosCorner, 1.0);
        return Math.Max(0.0, distance - ball.Radius) * Tangent * cos * cos;
    }

    /// <summary>Limits of <see cref="MinWidth"/> for all balls that lie in one and hold a point of a line, m.</summary>
    /// <param name="ball">Centre (m, MOON_ME) and radius (m).</param>
    /// <param name="from">One end of the line, m, body-fixed.</param>
    /// <param name="to">The other end.</param>
    internal (double Min, double Max) LimitsOfMinWidth((Vector3D CentreBodyFixed, double Radius) ball, Vector3D from, Vector3D to)
    {
        double nearest = Math.Max(0.0, (ball.CentreBodyFixed - PositionBodyFixed).Length - ball.Radius);
        double farthest = Math.Max((from - PositionBodyFixed).Length, (to - PositionBodyFixed).Length);
        return (nearest * Tangent * _cosCorner * _cosCorner, farthest * Tangent);
    }
}
