using Msisf.Core.Detector.Noise;

namespace Msisf.Core.Detector;

/// <summary>
/// The tracks of a frame's cosmic rays: straight lines from an isotropic flux, so that the cosine of the angle to the detector's normal is
/// the root of a uniform number; each path leaves electrons in proportion to its length in each pixel.
/// </summary>
internal static class RayTracks
{
    private const double SquareCentimetresPerSquareMetre = 1e4;
    private const double MicrometresPerMetre = 1e6;

    /// <summary>Adds the electrons of a frame's rays.</summary>
    /// <param name="charge">Electrons of each pixel, by rows.</param>
    /// <param name="width">px.</param>
    /// <param name="settings">Settings of the detector, with cosmic rays and a pixel pitch.</param>
    public static void Add(Span<double> charge, int width, DetectorSettings settings, in NoiseSource noise)
    {
        if (settings.CosmicRays is not CosmicRays rays)
        {
            return;
        }

        int height = charge.Length / width;
        double area = width * height * settings.PixelPitch * settings.PixelPitch * SquareCentimetresPerSquareMetre;
        double count = PoissonDeviate.Of(rays.Rate * area * settings.ExposureTime, noise.Uniforms(NoiseKind.RayCount, 0).First);
        double depth = rays.Thickness / MicrometresPerMetre / settings.PixelPitch; // in pixels
        for (uint ray = 0; ray < count; ray++)
        {
            (double x, double y) = noise.Uniforms(NoiseKind.RayPosition, ray);
            (double u, double v) = noise.Uniforms(NoiseKind.RayDirection, ray);
            double cosine = Math.Sqrt(u);
            double length = depth * Math.Sqrt(1.0 - u) / cosine;
            (double sine, double cosineAzimuth) = PortableMath.SinCosDegrees(360.0 * v);
            double electrons = rays.ElectronsPerMicrometre * rays.Thickness / cosine;
            AddTrack(charge, width, x * width, y * height, length * cosineAzimuth, length * sine, electrons);
        }
    }

    /// <summary>Distributes the electrons of a track over the pixels that it crosses.</summary>
    private static void AddTrack(Span<double> charge, int width, double x, double y, double dx, double dy, double electrons)
    {
        int height = charge.Length / width;
        int column = Math.Min((int)x, width - 1);
        int row = Math.Min((int)y, height - 1);
        double done = 0.0;
        while (done < 1.0 && (uint)column < (uint)width && (uint)row < (uint)height)
        {
            double toColumn = CrossingOf(x, dx, column);
            double toRow = CrossingOf(y, dy, row);
            double next = Math.Min(1.0, Math.Min(toColumn, toRow));
            charge[(row * width) + column] += Math.Round(electrons * Math.Max(0.0, next - done));
            done = next;
            column += toColumn <= toRow ? Math.Sign(dx) : 0;
            row += toRow < toColumn ? Math.Sign(dy) : 0;
        }
    }

    /// <summary>Part of the track at which it leaves a column or row of pixels; infinity if it never does.</summary>
    private static double CrossingOf(double start, double step, int pixel) => step switch
    {
        > 0.0 => (pixel + 1 - start) / step,
        < 0.0 => (pixel - start) / step,
        _ => double.PositiveInfinity,
    };
}
