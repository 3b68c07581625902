using Msisf.Core.Numerics;
using Msisf.Core.Terrain;

namespace Msisf.Core.Tests.Support;

/// <summary>Ground of waves of all lengths, of which cells show those of four cells and more.</summary>
internal sealed class WavyDetail : IGroundDetail
{
    private const double Slope = 0.03;
    private const int LongestWave = 17; // log2 of m

    public string Name => "WAVES";

    public (double Min, double Max) RadiusLimits => (MoonConstants.ReferenceRadius - 8e3, MoonConstants.ReferenceRadius + 8e3);

    /// <summary>How often blocks were computed.</summary>
    public int Blocks => _blocks;

    private int _blocks;

    public void ReadRadii(PolarStereographic map, int firstLine, int firstSample, int side, Span<double> radii)
    {
        Interlocked.Increment(ref _blocks);
        for (int i = 0; i < side * side; i++)
        {
            radii[i] = RadiusAt(map.DirectionOf(firstLine + (i / side), firstSample + (i % side)), map.MetresPerPixel);
        }
    }

    public void ReadBrightness(PolarStereographic map, int firstLine, int firstSample, int side, Span<float> factors) =>
        factors.Fill(1.0f);

    public double RadiusAt(Vector3D direction, double cell)
    {
        double height = 0.0;
        for (int wave = LongestWave; Math.ScaleB(1.0, wave) >= 4.0 * cell; wave--)
        {
            double length = Math.ScaleB(1.0, wave);
            (double sin, double cos) = Math.SinCos(1.7 * wave);
            Vector3D along = new(cos, 0.8 * sin, (0.6 * sin) + 0.3);
            height += Slope * length * Math.Sin(
                2.0 * Math.PI * MoonConstants.ReferenceRadius / length * Vector3D.Dot(along, direction));
        }

        return MoonConstants.ReferenceRadius + height;
    }
}
