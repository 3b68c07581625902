using Msisf.Core.Numerics;
using Msisf.Core.Terrain;

namespace Msisf.Synthesis;

/// <summary>Means of the invented detail over the cells of a model.</summary>
internal static class DetailMeans
{
    /// <summary>Places along a side of a cell at most whose mean is that of the cell; fewer where the ground has wide cells.</summary>
    private const int MostPlacesASide = 20;

    /// <summary>
    /// Cells of the ground along a side of a cell of the model, if narrower ones are drawn: what is too small for them has a mean near 0.
    /// </summary>
    private const double CellsASide = 48.0;

    /// <summary>m: width of the cells in which a mean is computed that is the same for all narrower ones.</summary>
    public static double CellFor(double spacing, double cell) =>
        Math.Max(cell, Math.ScaleB(1.0, (int)Math.Floor(Math.Log2(spacing / CellsASide))));

    /// <summary>Mean of the detail over a cell, m.</summary>
    /// <param name="model">The model.</param>
    /// <param name="maria">Where the ground is smoother.</param>
    /// <param name="layer">The detail in cells of the width for means.</param>
    /// <param name="cell">m: that width.</param>
    /// <param name="line">The model's line.</param>
    /// <param name="sample">Its sample.</param>
    public static double Of(ITerrainGrid model, MareMask maria, DetailLayer layer, double cell, int line, int sample)
    {
        int fours = (int)Math.Ceiling(0.25 * model.Projection.Resolution.MetresPerPixel / cell);
        GroundPoints places = GroundPoints.Within(model, line, sample, Math.Min(4 * fours, MostPlacesASide));
        float[] fractions = new float[places.Count];
        float[] heights = new float[places.Count];
        Vector3D middle = model.Projection.DirectionOf(line, sample);
        double farthest = 0.0;
        for (int i = 0; i < fractions.Length; i++)
        {
            fractions[i] = (float)maria.At(places.Latitudes[i], places.Longitudes[i]);
            farthest = Math.Max(farthest, (places[i] - middle).LengthSquared);
        }

        layer.AddTo(places.X, places.Y, places.Z, middle, Math.Sqrt(farthest), fractions, heights);
        double sum = 0.0;
        foreach (float height in heights)
        {
            sum += height;
        }

        return sum / heights.Length;
    }
}
