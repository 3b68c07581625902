using Msisf.Core.Numerics;

namespace Msisf.Stress.Reference;

/// <summary>
/// The camera of thesis section 8.2 by its printed formulas, to some 30 digits (docs/deviations.md, row 7). The inputs count as exact.
/// </summary>
public sealed class PreciseCamera
{
    private readonly int _width;
    private readonly int _height;
    private readonly PreciseVector _direction;
    private readonly PreciseVector _right;
    private readonly PreciseVector _up;

    /// <param name="positionBodyFixed">m.</param>
    /// <param name="moonFromCamera">qx, qy, qz, q0 of about length 1.</param>
    /// <param name="fieldOfView">rad, horizontal.</param>
    /// <param name="width">px.</param>
    /// <param name="height">px.</param>
    public PreciseCamera(
        Vector3D positionBodyFixed, (double X, double Y, double Z, double W) moonFromCamera, double fieldOfView, int width, int height)
    {
        _width = width;
        _height = height;
        Position = PreciseVector.From(positionBodyFixed);
        (DoubleWord sine, DoubleWord cosine) = PreciseMath.SinCos(fieldOfView / 2.0);
        DoubleWord aspect = (DoubleWord)width / height;
        _direction = aspect * 0.5 * cosine / sine * Rotated(moonFromCamera, new PreciseVector(-1.0, 0.0, 0.0));
        _right = aspect * Rotated(moonFromCamera, new PreciseVector(0.0, 1.0, 0.0));
        _up = Rotated(moonFromCamera, new PreciseVector(0.0, 0.0, 1.0));
    }

    /// <summary>m, MOON_ME.</summary>
    public PreciseVector Position { get; }

    /// <summary>The viewing direction of length 1, MOON_ME.</summary>
    public PreciseVector Forward => _direction.Normalized();

    /// <summary>The direction of a pixel's ray, MOON_ME (thesis eq. 8.15).</summary>
    public PreciseVector DirectionThrough(int x, int y) =>
        _direction
        + ((DoubleWord)(1 + _height - (2 * y)) / (2 * _height) * _up)
        + ((DoubleWord)((2 * x) - 1 - _width) / (2 * _width) * _right);

    /// <summary>
    /// Where a point is in the image, px from a pixel's centre to the right and down (thesis eq. 9.20); it lies in front.
    /// </summary>
    public (DoubleWord Right, DoubleWord Down) PlaceFrom(int x, int y, PreciseVector point)
    {
        PreciseVector seen = point - Position;
        PreciseVector onPlane = PreciseVector.Dot(_direction, _direction) / PreciseVector.Dot(seen, _direction) * seen;
        DoubleWord right = (DoubleWord)_width * PreciseVector.Dot(onPlane, _right) / PreciseVector.Dot(_right, _right);
        DoubleWord up = (DoubleWord)_height * PreciseVector.Dot(onPlane, _up);
        return (right + (0.5 * (1.0 + _width)) - x, 0.5 * (1.0 + _height) - up - y);
    }

    /// <summary>Whether a point lies in front of the camera.</summary>
    public bool IsInFront(PreciseVector point) => PreciseVector.Dot(point - Position, _direction).High > 0.0;

    /// <summary>q [0, v] q* over q q*.</summary>
    private static PreciseVector Rotated((double X, double Y, double Z, double W) q, PreciseVector v)
    {
        PreciseVector imaginary = new(q.X, q.Y, q.Z);
        DoubleWord square = PreciseVector.Dot(imaginary, imaginary) + ((DoubleWord)q.W * q.W);
        PreciseVector once = 2.0 / square * PreciseVector.Cross(imaginary, v);
        return v + (q.W * once) + PreciseVector.Cross(imaginary, once);
    }
}
