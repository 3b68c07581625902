using Msisf.Adapters.Illumination;
using Msisf.Adapters.IO;
using Msisf.Core.Illumination;
using Msisf.Core.Maps;
using Msisf.Core.Terrain;

namespace Msisf.App.Illumination;

/// <summary>
/// Compares maps of light with those of Mazarico et al. in LOLA's archive, cell by cell: permanent shadow with what is never lit, the mean
/// visible part of the Sun, and the best-lit places of both.
/// </summary>
/// <param name="directions">Their middles.</param>
internal sealed class NasaComparison(MapGrid region, IReadOnlyList<Vector3D> directions)
{
    /// <summary>Number of best places of each map in the report.</summary>
    private const int Best = 5;

    /// <summary>Smallest distance between best places, m.</summary>
    private const double Apart = 1000.0;

    private readonly List<string> _rows = ["map,quantity,msisf,nasa,unit"];

    /// <summary>Compares a map.</summary>
    /// <param name="cells">The light of the cells, on the ground.</param>
    /// <returns>A sentence that says the most important.</returns>
    /// <exception cref="BadInputException">The map shows no cell of the region.</exception>
    public string Add(NasaLightMap map, CellLights cells)
    {
        List<ComparedCell> both = [];
        PlaceLight[] lights = cells.Lights;
        foreach (int cell in cells.Ground)
        {
            if (map.At(directions[cell]) is { } value)
            {
                double ours = !map.IsOfShadow ? lights[cell].DiscPart : lights[cell].LitSteps == 0 ? 1.0 : 0.0;
                both.Add(new ComparedCell(cell, ours, value));
            }
        }

        if (both.Count == 0)
        {
            throw new BadInputException($"{map.Product}: no cell of the region lies on this map. Choose a region that it shows.");
        }

        Row(map, "cells compared", both.Count, both.Count, string.Empty);
        return map.IsOfShadow ? AddShadow(map, both) : AddLight(map, both);
    }

    /// <summary>Writes the table.</summary>
    /// <param name="path">A CSV.</param>
    public void Write(string path) => AtomicFile.WriteText(path, writer => _rows.ForEach(writer.WriteLine));

    private string AddShadow(NasaLightMap map, List<ComparedCell> both)
    {
        double ours = AreaOf(cell => cell.Ours > 0.5);
        double theirs = AreaOf(cell => cell.Theirs > 0.5);
        double shared = AreaOf(cell => cell.Ours > 0.5 && cell.Theirs > 0.5);
        Row(map, "in shadow for ever", ours, theirs, "km2");
        Row(map, "in shadow in both", shared, shared, "km2");
        Row(map, "in shadow in one alone", ours - shared, theirs - shared, "km2");
        return string.Create(
            CultureInfo.InvariantCulture,
            $"{map.Product}: {ours:F3} km2 of the cells are never lit here, {theirs:F3} km2 there, {shared:F3} km2 in both.");

        double AreaOf(Func<ComparedCell, bool> isWanted) => both.Where(isWanted).Sum(
            cell => region.AreaOf(cell.Cell / region.Samples, cell.Cell % region.Samples)) / 1e6; // m2 in a km2
    }

    private string AddLight(NasaLightMap map, List<ComparedCell> both)
    {
        double ours = both.Average(cell => cell.Ours);
        double theirs = both.Average(cell => cell.Theirs);
        double rms = Math.Sqrt(both.Average(cell => (cell.Ours - cell.Theirs) * (cell.Ours - cell.Theirs)));
        Row(map, "mean visible part of the Sun", ours, theirs, string.Empty);
        Row(map, "rms difference of it", rms, rms, string.Empty);
        AddBest(map, "msisf", both, cell => cell.Ours);
        AddBest(map, "nasa", both, cell => cell.Theirs);
        return string.Create(
            CultureInfo.InvariantCulture,
            $"{map.Product}: the mean visible part of the Sun is {ours:F4} here, {theirs:F4} there, rms difference {rms:F4}.");
    }

    /// <summary>Tells the cells with the greatest values that are far enough from each other.</summary>
    private void AddBest(NasaLightMap map, string whose, List<ComparedCell> both, Func<ComparedCell, double> value)
    {
        List<ComparedCell> best = [];
        foreach (ComparedCell cell in both.OrderByDescending(value).ThenBy(cell => cell.Cell))
        {
            if (best.All(other => (directions[other.Cell] - directions[cell.Cell]).Length * region.Projection.Radius >= Apart))
            {
                best.Add(cell);
                SelenographicPoint place = SelenographicPoint.Below(directions[cell.Cell]);
                string quantity = string.Create(
                    CultureInfo.InvariantCulture,
                    $"best {best.Count} of {whose} at {double.RadiansToDegrees(place.Latitude):F4} "
                        + $"{double.RadiansToDegrees(place.Longitude):F4}");
                Row(map, quantity, cell.Ours, cell.Theirs, string.Empty);
            }

            if (best.Count == Best)
            {
                break;
            }
        }
    }

    private void Row(NasaLightMap map, string quantity, double ours, double theirs, string unit) => _rows.Add(string.Create(
        CultureInfo.InvariantCulture, $"{map.Product},{quantity},{ours:R},{theirs:R},{unit}"));

    private readonly record struct ComparedCell(int Cell, double Ours, double Theirs);
}
