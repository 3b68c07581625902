using Msisf.Adapters.Raster.Heights;
using Msisf.Core.Terrain;

namespace Msisf.App.Preparation;

/// <summary>
/// Compares a raster whose file does not say its unit with the model of the whole Moon in which it lies: feet, or steps of half a metre,
/// make a cliff along its border.
/// </summary>
internal static class UnitAgainstModel
{
    /// <summary>Places along a side of the raster.</summary>
    private const int PlacesASide = 12;

    /// <summary>m, rms: coarse models are off by less on most ground.</summary>
    private const double WorthALook = 200.0;

    /// <summary>1: a unit with which so small a part of the difference is left is the right one.</summary>
    private const double MuchBetter = 0.25;

    private static readonly (double Metres, string Name)[] Units = [(0.5, "steps of half a metre"), (0.3048, "feet")];

    /// <summary>Looks at all rasters whose unit nobody says.</summary>
    /// <exception cref="BadInputException">Another unit fits the model of the whole Moon much better.</exception>
    public static void Check(IReadOnlyList<ElevationModel> models)
    {
        if (models.FirstOrDefault(model => model.IsWholeMoon) is not { } moon)
        {
            return; // which another check reports
        }

        foreach (ElevationModel model in models)
        {
            if (!model.IsWholeMoon && MovedModel.RasterOf(model.Grid) is { HasUnit: false } raster)
            {
                Check(raster, moon);
            }
        }
    }

    private static void Check(GeoTiffGrid raster, ElevationModel moon)
    {
        (double Own, double Around)[] heights = [.. Places(raster).Select(place => (
            place.Radius - moon.Grid.ReferenceRadius, moon.GroundRadius(place.Direction) - moon.Grid.ReferenceRadius))];
        double metres = heights.Length == 0 ? 0.0 : Difference(heights, 1.0);
        if (metres < WorthALook)
        {
            return;
        }

        (double unit, string name) = Units.MinBy(one => Difference(heights, one.Metres));
        double other = Difference(heights, unit);
        if (other < Math.Min(MuchBetter * metres, WorthALook))
        {
            throw new BadInputException(Invariant(
                $"{raster.Files[0]}: its values look like {name}: as metres they are {metres:F0} m (rms) off {moon.Set.ProductId}, ")
                    + Invariant($"as {name} {other:F0} m. If the guess is right, add ,scale={unit:R} to its name; if they are ")
                    + "metres, ,scale=1.");
        }
    }

    /// <summary>m, rms.</summary>
    private static double Difference((double Own, double Around)[] heights, double unit) =>
        Math.Sqrt(heights.Average(pair => ((unit * pair.Own) - pair.Around) * ((unit * pair.Own) - pair.Around)));

    private static IEnumerable<(Vector3D Direction, double Radius)> Places(GeoTiffGrid raster)
    {
        GridWindow window = raster.Window;
        for (int i = 0; i < PlacesASide * PlacesASide; i++)
        {
            int line = window.FirstLine + ((window.Lines - 1) * (i / PlacesASide) / (PlacesASide - 1));
            int sample = window.FirstSample + (int)((long)(window.Samples - 1) * (i % PlacesASide) / (PlacesASide - 1));
            bool[] isGap = [true];
            double[] radius = [0.0];
            raster.ReadGaps(line, sample, isGap);
            if (!isGap[0])
            {
                raster.ReadRadii(line, sample, radius);
                yield return (raster.Projection.DirectionOf(line, sample), radius[0]);
            }
        }
    }
}
