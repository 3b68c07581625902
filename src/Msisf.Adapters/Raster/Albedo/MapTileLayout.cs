using System.Globalization;
using Msisf.Adapters.Raster.Pds;
using Msisf.Core.Errors;
using Msisf.Core.Render.Photometry;

namespace Msisf.Adapters.Raster.Albedo;

/// <summary>
/// Where the tiles of a map lie in the map that they make up: to whole pixels, without overlap, and without a hole between them.
/// </summary>
internal sealed class MapTileLayout
{
    private MapTileLayout(PlacedMapTile[] tiles, int width, int height, MapExtent extent) =>
        (Tiles, Width, Height, Extent) = (tiles, width, height, extent);

    /// <summary>The tiles, from the north, then from the west.</summary>
    public IReadOnlyList<PlacedMapTile> Tiles { get; }

    /// <summary>Pixels of the map from west to east.</summary>
    public int Width { get; }

    /// <summary>Pixels of the map from north to south.</summary>
    public int Height { get; }

    /// <summary>What the map shows.</summary>
    public MapExtent Extent { get; }

    /// <summary>Lays the tiles of a map side by side.</summary>
    /// <exception cref="BadInputException">They differ in what must be the same, overlap, or leave a hole between them.</exception>
    public static MapTileLayout Of(MapTileSet set)
    {
        PdsMapLabel[] labels = [.. set.Labels];
        CheckAlike(labels);
        double perDegree = labels[0].PixelsPerDegree;
        (double west, double span) = MapTileMeridian.Find(labels);
        double north = labels.Max(label => label.NorthDegrees);
        MapTileEdges columns = MapTileEdges.Of(
            [.. labels.Select(label => (MapTileMeridian.From(west, label) * perDegree, label.LineSamples))]);
        MapTileEdges rows = MapTileEdges.Of([.. labels.Select(label => ((north - label.NorthDegrees) * perDegree, label.Lines))]);
        double slack = MapTileEdges.Tolerance / perDegree;
        bool isFullCircle = span > 360.0 - slack;
        CheckCover(set, labels, columns, rows, isFullCircle, edge => west + (edge / perDegree), edge => north - (edge / perDegree));
        PlacedMapTile[] tiles =
        [
            .. labels.Select((label, i) => new PlacedMapTile(
                    label, columns.Positions[columns.Tiles[i].First], rows.Positions[rows.Tiles[i].First]))
                .OrderBy(tile => tile.Row).ThenBy(tile => tile.Column),
        ];
        (int width, int height) = (columns.Positions[^1], rows.Positions[^1]);
        MapExtent extent = new(
            double.DegreesToRadians(west),
            double.DegreesToRadians(north),
            double.DegreesToRadians(isFullCircle ? 360.0 : width / perDegree),
            double.DegreesToRadians(Math.Abs((height / perDegree) - (north + 90.0)) < slack ? north + 90.0 : height / perDegree));
        return new MapTileLayout(tiles, width, height, extent);
    }

    /// <summary>All tiles mean the same by a value, and are of one scale.</summary>
    private static void CheckAlike(PdsMapLabel[] labels) =>
        new PdsAgreement("tile", "map").Require(
            labels, label => label.LabelPath,
            ("MAP_RESOLUTION", label => label.PixelsPerDegree),
            ("SAMPLE_TYPE", label => label.SampleType),
            ("SAMPLE_BITS", label => label.SampleBits),
            ("SCALING_FACTOR", label => label.ScalingFactor),
            ("OFFSET", label => label.Offset),
            ("UNIT", label => label.Unit));

    /// <summary>No place has two tiles, and no place without one lies between two of them.</summary>
    private static void CheckCover(
        MapTileSet set, PdsMapLabel[] labels, MapTileEdges columns, MapTileEdges rows, bool isFullCircle,
        Func<double, double> longitude, Func<double, double> latitude)
    {
        int[,] cover = new int[rows.Values.Length - 1, columns.Values.Length - 1];
        string Place(int row, int column) => string.Create(
            CultureInfo.InvariantCulture,
            $"latitude {latitude(rows.Values[row + 1]):0.####} to {latitude(rows.Values[row]):0.####}, "
                + $"longitude {longitude(columns.Values[column]):0.####} to {longitude(columns.Values[column + 1]):0.####}");
        for (int i = 0; i < labels.Length; i++)
        {
            for (int row = rows.Tiles[i].First; row < rows.Tiles[i].End; row++)
            {
                for (int column = columns.Tiles[i].First; column < columns.Tiles[i].End; column++)
                {
                    if (cover[row, column] is not 0 and int taken)
                    {
                        throw new BadInputException(
                            $"{labels[taken - 1].LabelPath} and {labels[i].LabelPath}: both show {Place(row, column)}. "
                                + $"Take one of them away.");
                    }

                    cover[row, column] = i + 1;
                }
            }
        }

        int[] allRows = [.. Enumerable.Range(0, rows.Values.Length - 1)];
        int[] allColumns = [.. Enumerable.Range(0, columns.Values.Length - 1)];
        foreach ((int row, int column) in allRows.SelectMany(row => allColumns.Select(column => (row, column))))
        {
            bool IsBeside(IEnumerable<int> others) => others.Any(other => cover[row, other] != 0);
            bool IsOver(IEnumerable<int> others) => others.Any(other => cover[other, column] != 0);
            bool isBetween = (isFullCircle && IsBeside(allColumns))
                || (IsBeside(allColumns.Take(column)) && IsBeside(allColumns.Skip(column)))
                || (IsOver(allRows.Take(row)) && IsOver(allRows.Skip(row)));
            if (cover[row, column] == 0 && isBetween)
            {
                throw new BadInputException(
                    $"{Path.GetDirectoryName(Path.GetFullPath(labels[0].LabelPath))}: of {set.Name} no tile shows {Place(row, column)}, "
                        + $"which lies between others. Put the missing tile there.");
            }
        }
    }
}
