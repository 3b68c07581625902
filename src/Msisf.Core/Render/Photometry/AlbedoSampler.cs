using Msisf.Core.Camera;

namespace Msisf.Core.Render.Photometry;

/// <summary>
/// Scales radiance factors by a map: I/F = A f(i, e, g) / f(i0, e0, g0), where A is the map's mean over the pixel and (i0, e0, g0) its
/// geometry. Where the map has no data, the law alone counts. Keeps buffers, so each thread needs its own object.
/// </summary>
internal sealed class AlbedoSampler
{
    private readonly MapFootprints _footprints = new();

    /// <summary>Scales the radiance factors of a row.</summary>
    /// <param name="points">The pixels, with the law's radiance factors.</param>
    /// <param name="camera">The camera that sees them.</param>
    /// <param name="samplesAcross">Samples along a pixel's edge.</param>
    /// <param name="map">The map.</param>
    /// <param name="factorOfReference">
    /// The law's radiance factor in the map's geometry, above 0; null if it differs from place to place
    /// (<see cref="SunlitPoints.ReferenceFactors"/>).
    /// </param>
    public void Scale(SunlitPoints points, PinholeCamera camera, int samplesAcross, AlbedoMap map, double? factorOfReference)
    {
        _footprints.Find(points, camera, samplesAcross, map);
        double perReference = 1.0 / (factorOfReference ?? 1.0);
        double offset = map.Offset * perReference;
        double step = map.Step * perReference;
        Span<double> factors = points.Factors.AsSpan(0, points.Count);
        MapLevelReader fine = default;
        MapLevelReader coarse = default;
        int current = -1;
        for (int i = 0; i < factors.Length; i++)
        {
            int level = (int)_footprints.Levels[i];
            if (level != current)
            {
                current = level;
                fine = new MapLevelReader(map, level);
                coarse = new MapLevelReader(map, Math.Min(level + 1, map.Levels.Count - 1));
            }

            double part = _footprints.Parts[i];
            int probes = (int)_footprints.Probes[i];
            double code = probes == 1
                ? Mixed(fine, coarse, part, _footprints.X[i], _footprints.Y[i])
                : MeanAlong(fine, coarse, part, i, probes);
            if (code > 0.0)
            {
                double scale = offset + (step * code);
                factors[i] *= factorOfReference is null ? scale / points.ReferenceFactors[i] : scale;
            }
        }
    }

    private static double Mixed(in MapLevelReader fine, in MapLevelReader coarse, double part, double x, double y)
    {
        double near = fine.At(x, y);
        if (part == 0.0)
        {
            return near;
        }

        double far = coarse.At(x, y);
        return near == 0.0 || far == 0.0 ? Math.Max(near, far) : near + (part * (far - near));
    }

    private double MeanAlong(in MapLevelReader fine, in MapLevelReader coarse, double part, int i, int probes)
    {
        double sum = 0.0;
        int count = 0;
        for (int probe = 0; probe < probes; probe++)
        {
            double along = ((probe + 0.5) / probes) - 0.5;
            double code = Mixed(
                fine, coarse, part, _footprints.X[i] + (along * _footprints.AxisX[i]), _footprints.Y[i] + (along * _footprints.AxisY[i]));
            sum += code;
            count += code > 0.0 ? 1 : 0;
        }

        return count == 0 ? 0.0 : sum / count;
    }
}
