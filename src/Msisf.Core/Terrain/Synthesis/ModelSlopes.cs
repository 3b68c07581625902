namespace Msisf.Core.Terrain.Synthesis;

/// <summary>Median slopes of an elevation model between neighbouring samples, as tangents; null where the model has too little of the terrain.</summary>
/// <param name="Highlands">Tangent, where the mare fraction is 0.</param>
/// <param name="Maria">Tangent, where the mare fraction is 1.</param>
internal sealed record ModelSlopes(double? Highlands, double? Maria)
{
    private const int LeastCount = 200; // samples; a median of fewer says little
    private const int NorthernmostDegree = 60; // nearer the poles the samples of a line crowd together

    /// <summary>Measures a model on lines and samples about a degree apart.</summary>
    /// <param name="model">Any resolution.</param>
    /// <param name="maria">Its mare mask.</param>
    public static ModelSlopes Of(IElevationGrid model, MareMask maria)
    {
        int resolution = model.PixelsPerDegree;
        int around = 360 * resolution;
        double spacing = Spacing(resolution);
        double[] radii = new double[around];
        double[] southern = new double[around];
        List<double> highlandSlopes = [];
        List<double> mareSlopes = [];
        for (int degree = -NorthernmostDegree; degree <= NorthernmostDegree; degree++)
        {
            int line = (90 - degree) * resolution;
            double latitude = 90.0 - ((line + 0.5) / resolution);
            double cosLatitude = PortableMath.SinCosDegrees(latitude).Cos;
            int east = (int)Math.Round(1.0 / cosLatitude);
            model.ReadRadii(line, 0, radii);
            model.ReadRadii(line + 1, 0, southern);
            for (int sample = 0; sample < around; sample += resolution)
            {
                double fraction = maria.At(latitude, (sample + 0.5) / resolution);
                List<double>? slopes = fraction <= 0.0 ? highlandSlopes : fraction >= 1.0 ? mareSlopes : null;
                double toEast = (radii[(sample + east) % around] - radii[sample]) / (east * spacing * cosLatitude);
                double toSouth = (southern[sample] - radii[sample]) / spacing;
                slopes?.Add(Math.Sqrt((toEast * toEast) + (toSouth * toSouth)));
            }
        }

        return new ModelSlopes(Median(highlandSlopes), Median(mareSlopes));
    }

    /// <summary>m between neighbouring lines of a model.</summary>
    public static double Spacing(double pixelsPerDegree) => MoonConstants.ReferenceRadius * Math.PI / (180.0 * pixelsPerDegree);

    private static double? Median(List<double> values)
    {
        values.Sort();
        return values.Count < LeastCount ? null : values[values.Count / 2];
    }
}
