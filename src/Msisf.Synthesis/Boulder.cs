using Msisf.Core.Terrain;

namespace Msisf.Synthesis;

/// <summary>A boulder on the ground: the part above it of a rounded, a blocky or an angular body with three different axes.</summary>
/// <param name="Centre">Direction of its middle, body-fixed, length 1.</param>
/// <param name="Narrow">Horizontal direction in which it is narrower, body-fixed, length 1.</param>
/// <param name="Radius">m: half of its length.</param>
/// <param name="WidthPart">Its width, in lengths.</param>
/// <param name="Height">m over the ground.</param>
/// <param name="Form">Its form.</param>
internal readonly record struct Boulder(
    Vector3D Centre, Vector3D Narrow, double Radius, double WidthPart, double Height, BoulderForm Form)
{
    /// <summary>Height over the ground in a direction of length 1, m; 0 beside it.</summary>
    public double HeightAt(Vector3D direction)
    {
        Vector3D from = (MoonConstants.ReferenceRadius / Radius) * (direction - Centre);
        double across = Vector3D.Dot(from, Narrow) / WidthPart;
        double along = Vector3D.Dot(from, Vector3D.Cross(Centre, Narrow));
        return Height * Form.HeightAt(along, across);
    }
}

/// <summary>The form of a boulder in units of half its length, half its width and its height over the ground.</summary>
/// <remarks>
/// Worn blocks are rounded, fresh ones angular (J. B. Garvin et al., in: Lunar Planet. Sci. XII (1981), 308, distinguish such shapes on
/// planets); all are buried in part. The forms here are three bodies that such blocks are between.
/// </remarks>
internal sealed class BoulderForm
{
    private const int Sides = 7;
    private const int Tops = 3;
    private const double DeepestBurial = 0.8; // of the height over the ground
    private const double Blocky = 4.0;

    // Heights over half lengths: steeper sides than this, narrower than the ground's cells, would show these as teeth.
    private const double Steepest = 3.0;

    private readonly double _power;
    private readonly double _burial;
    private readonly (double Along, double Across, double Top)[] _planes = [];

    /// <summary>Draws a form.</summary>
    public BoulderForm(ref SplitMix64 random)
    {
        double kind = random.NextUniform();
        _burial = DeepestBurial * random.NextUniform();
        _power = kind < 1.0 / 3.0 ? 2.0 : Blocky;
        if (kind < 2.0 / 3.0)
        {
            return;
        }

        // Steep sides all around, a top that leans a little, and planes that cut edges off.
        _planes = new (double, double, double)[Sides + Tops];
        for (int side = 0; side < Sides; side++)
        {
            (double sin, double cos) = PortableMath.SinCosDegrees(360.0 * (side + (0.8 * random.NextUniform())) / Sides);
            double steepness = 2.0 + random.NextUniform();
            double distance = 0.7 + (0.25 * random.NextUniform());
            _planes[side] = (steepness * cos, steepness * sin, steepness * distance);
        }

        for (int top = 0; top < Tops; top++)
        {
            (double sin, double cos) = PortableMath.SinCosDegrees(360.0 * random.NextUniform());
            double slope = top == 0 ? 0.35 * random.NextUniform() : 0.8 + (0.8 * random.NextUniform());
            _planes[Sides + top] = (slope * cos, slope * sin, top == 0 ? 0.85 : 1.3 + (0.3 * random.NextUniform()));
        }
    }

    /// <summary>Height at a place, 0 to 1; 0 beside the boulder.</summary>
    public double HeightAt(double along, double across)
    {
        double square = (along * along) + (across * across);
        if (square >= 1.0)
        {
            return 0.0;
        }

        if (_planes.Length == 0)
        {
            double body = _power == Blocky
                ? 1.0 - ((along * along * along * along) + (across * across * across * across))
                : 1.0 - square;
            double height = _power == Blocky ? Math.Sqrt(Math.Sqrt(Math.Max(0.0, body))) : Math.Sqrt(body);
            return Math.Max(0.0, Math.Min(((1.0 + _burial) * height) - _burial, Steepest * (1.0 - Math.Sqrt(square))));
        }

        double lowest = Math.Min(1.0, Steepest * (1.0 - Math.Sqrt(square)));
        foreach ((double toAlong, double toAcross, double top) in _planes)
        {
            lowest = Math.Min(lowest, top - (toAlong * along) - (toAcross * across));
        }

        return Math.Max(0.0, lowest);
    }
}
