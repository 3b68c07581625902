using System.Globalization;

namespace Msisf.TestSupport;

/// <summary>Writes PDS3 maps of the Moon as tiles of 90 degrees of longitude, named as LROC's archive does.</summary>
internal static class PdsMapTiles
{
    /// <summary>The name of the tile that begins at a place.</summary>
    public static string Name(string map, string resolution, int west, int north, int height)
    {
        int centre = (10 * north) - (5 * height);
        return string.Create(
            CultureInfo.InvariantCulture, $"{map}_E{Math.Abs(centre):000}{(centre < 0 ? 'S' : 'N')}{(10 * west) + 450:0000}_{resolution}");
    }

    /// <summary>Writes one tile.</summary>
    /// <param name="folder">Where to.</param>
    /// <param name="map">Name of the map, before the centre.</param>
    /// <param name="type">SAMPLE_TYPE and SAMPLE_BITS.</param>
    /// <param name="perDegree">Pixels a degree.</param>
    /// <param name="top">Upper edge of the whole map, degrees.</param>
    /// <param name="valueOf">Stored value of a column, from 0 E, and a row, from the top.</param>
    /// <param name="place">Left and upper edge and height of the tile, degrees.</param>
    /// <param name="more">Further lines of the IMAGE object.</param>
    public static string Write(
        TemporaryFolder folder, string map, (string Type, int Bits) type, int perDegree, int top, Func<int, int, double> valueOf,
        (int West, int North, int Height) place, string more = "") => PdsMap.Write(
        folder, Name(map, "064P", place.West, place.North, place.Height), type.Type, type.Bits, perDegree,
        (column, row) => valueOf(column + (place.West * perDegree), row + ((top - place.North) * perDegree)),
        more, place.West, place.North, (90, place.Height));

    /// <summary>Writes eight tiles in two rows around the Moon.</summary>
    /// <returns>Their paths, from the north, then from the west.</returns>
    public static string[] WriteEight(
        TemporaryFolder folder, string map, (string Type, int Bits) type, int perDegree, int top, Func<int, int, double> valueOf,
        string more = "") =>
    [
        .. from north in (int[])[top, 0]
           from west in (int[])[0, 90, 180, 270]
           select Write(folder, map, type, perDegree, top, valueOf, (west, north, top), more),
    ];
}
