using Msisf.Adapters.Raster.Pds;
using Msisf.Core.Render.Photometry;

namespace Msisf.Adapters.Raster.Albedo;

/// <summary>A tile with its place in the map.</summary>
/// <param name="Column">The map's column of the tile's first one.</param>
/// <param name="Row">The map's row of the tile's first one.</param>
internal sealed record PlacedMapTile(PdsMapLabel Label, int Column, int Row);

/// <summary>
/// Where the tiles of a map lie in the map that they make up: to whole pixels, without overlap, and without a hole between them.
/// </summary>
/// <param name="Tiles">The tiles, from the north, then from the west.</param>
/// <param name="Width">Pixels of the map from west to east.</param>
/// <param name="Height">Pixels of the map from north to south.</param>
/// <param name="Extent">What the map shows.</param>
internal sealed record MapTileLayout(IReadOnlyList<PlacedMapTile> Tiles, int Width, int Height, MapExtent Extent)
{
    /// <summary>Lays the tiles of a map side by side.</summary>
    /// <exception cref="BadInputException">They differ in what must be the same, overlap, or leave a hole between them.</exception>
    public static MapTileLayout Of(MapTileSet set)
    {
        PdsMapLabel[] labels = [.. set.Labels];
        PdsAgreement.Require(
            labels, label => label.LabelPath, "tile", "map",
            ("MAP_RESOLUTION", label => label.PixelsPerDegree),
            ("SAMPLE_TYPE", label => label.SampleType),
            ("SCALING_FACTOR", label => label.ScalingFactor),
            ("OFFSET", label => label.Offset),
            ("UNIT", label => label.Unit));
        double perDegree = labels[0].PixelsPerDegree;
        (double west, double span) = FindMeridian(labels);
        double north = labels.Max(label => label.NorthDegrees);
        MapTileEdges columns = MapTileEdges.Of([.. labels.Select(label => (EastOf(west, label) * perDegree, label.LineSamples))]);
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

    /// <summary>
    /// The meridian at which the map begins: the western edge of the tiles from which all of them reach the least far; of several the one
    /// with the least number.
    /// </summary>
    /// <returns>The east longitude, degrees, as its label has it, and how far the tiles reach, degrees.</returns>
    /// <exception cref="BadInputException">From no edge on all tiles end within a turn.</exception>
    private static (double West, double Span) FindMeridian(PdsMapLabel[] labels)
    {
        double slack = MapTileEdges.Tolerance / labels[0].PixelsPerDegree;
        (double West, double Span) best = (0.0, double.PositiveInfinity);
        foreach (double west in labels.Select(label => label.WestDegrees).Order())
        {
            double span = labels.Max(label => EastOf(west, label) + (label.LineSamples / label.PixelsPerDegree));
            best = span < best.Span - slack ? (west, span) : best;
        }

        return best.Span <= 360.0 + slack ? best : throw new BadInputException(
            $"{labels[0].LabelPath} and its {labels.Length - 1} other tiles reach more than once around the Moon from the left edge of "
                + $"any of them. Take away those that overlap.");
    }

    /// <summary>
    /// From a meridian eastwards to the left edge of a tile, degrees from 0 to 360; an edge just before the meridian is at it.
    /// </summary>
    private static double EastOf(double west, PdsMapLabel label)
    {
        double degrees = (label.WestDegrees - west) % 360.0;
        degrees = degrees < 0.0 ? degrees + 360.0 : degrees;
        return degrees > 360.0 - (MapTileEdges.Tolerance / label.PixelsPerDegree) ? degrees - 360.0 : degrees;
    }

    /// <summary>No place has two tiles, and no place without one lies between two of them.</summary>
    private static void CheckCover(
        MapTileSet set, PdsMapLabel[] labels, MapTileEdges columns, MapTileEdges rows, bool isFullCircle,
        Func<double, double> longitude, Func<double, double> latitude)
    {
        int[,] cover = new int[rows.Values.Length - 1, columns.Values.Length - 1];
        string Place(int row, int column) => Invariant(
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

/// <summary>
/// The edges of tiles along one axis. Labels round edges to parts of a pixel, so edges that nearly meet are one; where it lies to whole
/// pixels follows from the sizes of the tiles that end there.
/// </summary>
/// <param name="Values">The edges as the labels have them, pixels, in order.</param>
/// <param name="Positions">The edges to whole pixels, from 0.</param>
/// <param name="Tiles">For each tile the numbers of its first edge and of the edge at its end.</param>
internal sealed record MapTileEdges(double[] Values, int[] Positions, (int First, int End)[] Tiles)
{
    /// <summary>
    /// Pixels: edges nearer than this are one. A tile's rounded size can make more than half a pixel, a missing line is a whole one.
    /// </summary>
    public const double Tolerance = 0.75;

    /// <summary>Finds the edges of tiles.</summary>
    /// <param name="tiles">Beginning and size of each, pixels.</param>
    public static MapTileEdges Of((double Start, int Size)[] tiles)
    {
        List<double> values = [];
        foreach (double value in tiles.SelectMany(tile => (double[])[tile.Start, tile.Start + tile.Size]).Order())
        {
            if (values.Count == 0 || value > values[^1] + Tolerance)
            {
                values.Add(value);
            }
        }

        int EdgeAt(double value) => values.FindLastIndex(edge => edge <= value);
        (int First, int End)[] edges = [.. tiles.Select(tile => (EdgeAt(tile.Start), EdgeAt(tile.Start + tile.Size)))];
        int[] positions = new int[values.Count];
        for (int edge = 1; edge < positions.Length; edge++)
        {
            int ending = Array.FindIndex(edges, tile => tile.End == edge);
            positions[edge] = ending >= 0
                ? positions[edges[ending].First] + tiles[ending].Size
                : positions[edge - 1] + (int)Math.Round(values[edge] - values[edge - 1]);
        }

        return new MapTileEdges([.. values], positions, edges);
    }
}
