namespace Msisf.Adapters.Raster.Pds;

/// <summary>The direction in which a PDS3 label counts longitudes.</summary>
internal static class PdsLongitudes
{
    private const string Direction = "POSITIVE_LONGITUDE_DIRECTION";
    private const string Center = "CENTER_LONGITUDE";

    /// <summary>Bytes: labels are shorter.</summary>
    private const int LongestLabel = 65536;

    /// <summary>Requires that a map counts to the east, as all longitudes here do.</summary>
    /// <exception cref="BadInputException">It counts to the west.</exception>
    public static void RequireEast(PdsObject projection) => projection.CheckText(Direction, "EAST", "EAST is needed");

    /// <summary>
    /// Requires that GDAL, whose driver does not look at the direction, puts the map where its label does: it counts to the east, or its
    /// middle is the same both ways.
    /// </summary>
    /// <param name="path">The label, or the file that it is attached to.</param>
    /// <exception cref="BadInputException">GDAL would mirror the map's place.</exception>
    public static void RequireGdals(string path)
    {
        if (ProjectionOf(path) is { } projection && projection.Find(Direction) is { Word: "WEST" }
            && projection.OptionalNumber(Center, PdsUnit.Degree) is { } west && west % 180.0 != 0.0)
        {
            double east = 360.0 - (west - (360.0 * Math.Floor(west / 360.0)));
            throw projection.WrongValue(Direction, Invariant(
                $"GDAL takes longitudes as east. Write {Direction} = EAST and {Center} = {east:R} into a copy of the label"));
        }
    }

    private static PdsObject? ProjectionOf(string path)
    {
        try
        {
            using FileStream stream = File.OpenRead(path);
            return PdsLabelParser.Parse(PdsLabelParser.TextOf(stream, LongestLabel), path).FindObject("IMAGE_MAP_PROJECTION");
        }
        catch (Exception exception) when (exception is BadInputException || exception.IsFileError())
        {
            return null; // GDAL reads what it can
        }
    }
}
