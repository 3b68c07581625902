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
