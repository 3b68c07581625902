namespace Msisf.Core.Layers;

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
