using Msisf.Core.Metadata;

namespace Msisf.Core.Layers;

/// <summary>Layer values of how the surface points of a row are lit, and of the angles to light and camera.</summary>
internal static class LightValues
{
    public static void Incidence(LayerRow row, int plane, double[] values) =>
        RowGeometry.FindAngles(row.Normals, row.ToLight, 1.0, row.Count, values);

    public static void Emission(LayerRow row, int plane, double[] values) =>
        RowGeometry.FindAngles(row.Normals, row.Sight, -1.0, row.Count, values);

    public static void Phase(LayerRow row, int plane, double[] values) =>
        RowGeometry.FindAngles(row.ToLight, row.Sight, -1.0, row.Count, values);

    /// <summary>Illumination direction in degrees, the same as in the meta file.</summary>
    public static void Direction(LayerRow row, int plane, double[] values)
    {
        VectorRow sight = row.Sight;
        double[] lengths = row.SightLengths;
        double[] radii = row.Radii;
        for (int i = 0; i < row.Count; i++)
        {
            double? angle = IlluminationDirection.At(
                row.Camera, sight[i], lengths[i], row.Points[i], radii[i], row.LightPositionBodyFixed);
            values[i] = double.RadiansToDegrees(angle ?? double.NaN);
        }
    }

    public static void State(LayerRow row, int plane, double[] values)
    {
        for (int i = 0; i < row.Count; i++)
        {
            values[i] = (double)row.Lights[i].State;
        }
    }

    public static void VisibleFraction(LayerRow row, int plane, double[] values)
    {
        for (int i = 0; i < row.Count; i++)
        {
            values[i] = row.Lights[i].VisibleFraction;
        }
    }
}

/// <summary>Layer values of the brightness of a row's pixels, also of those without surface.</summary>
internal static class ImageValues
{
    public static void RadianceFactor(LayerRow row, int plane, double[] values) => Copy(row, row.RadianceFactors, values);

    public static void Indirect(LayerRow row, int plane, double[] values) => Copy(row, row.IndirectFactors, values);

    public static void Electrons(LayerRow row, int plane, double[] values) => Copy(row, row.Electrons, values);

    /// <summary>0 also without a detector.</summary>
    public static void Saturation(LayerRow row, int plane, double[] values)
    {
        ReadOnlySpan<byte> saturated = row.Saturated;
        values.AsSpan(0, row.Camera.Width).Clear();
        for (int i = 0; i < saturated.Length; i++)
        {
            values[i] = saturated[i];
        }
    }

    public static void Radiance(LayerRow row, int plane, double[] values)
    {
        ReadOnlySpan<double> factors = row.RadianceFactors;
        Copy(row, factors, values);
        double ofUnit = row.RadianceOfUnitFactor ?? double.NaN;
        for (int i = 0; i < factors.Length; i++)
        {
            values[i] *= ofUnit;
        }
    }

    private static void Copy(LayerRow row, ReadOnlySpan<double> known, double[] values)
    {
        if (known.IsEmpty)
        {
            values.AsSpan(0, row.Camera.Width).Fill(double.NaN);
        }
        else
        {
            known.CopyTo(values);
        }
    }
}
