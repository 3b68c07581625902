using Msisf.Core.Errors;

namespace Msisf.Adapters.Raster.Albedo;

/// <summary>Finds the meridian at which a map of several tiles begins.</summary>
internal static class MapTileMeridian
{
    /// <summary>
    /// The western edge of the tiles from which all of them reach the least far; of several the one with the least number.
    /// </summary>
    /// <returns>The east longitude, degrees, as its label has it, and how far the tiles reach, degrees.</returns>
    /// <exception cref="BadInputException">From no edge on all tiles end within a turn.</exception>
    public static (double West, double Span) Find(PdsMapLabel[] labels)
    {
        double slack = MapTileEdges.Tolerance / labels[0].PixelsPerDegree;
        (double West, double Span) best = (0.0, double.PositiveInfinity);
        foreach (double west in labels.Select(label => label.WestDegrees).Order())
        {
            double span = labels.Max(label => From(west, label) + (label.LineSamples / label.PixelsPerDegree));
            if (span < best.Span - slack)
            {
                best = (west, span);
            }
        }

        return best.Span <= 360.0 + slack ? best : throw new BadInputException(
            $"{labels[0].LabelPath} and its {labels.Length - 1} other tiles reach more than once around the Moon from the left edge of "
                + $"any of them. Take away those that overlap.");
    }

    /// <summary>
    /// From a meridian eastwards to the left edge of a tile, degrees from 0 to 360; an edge just before the meridian is at it.
    /// </summary>
    public static double From(double west, PdsMapLabel label)
    {
        double degrees = (label.WestDegrees - west) % 360.0;
        degrees = degrees < 0.0 ? degrees + 360.0 : degrees;
        return degrees > 360.0 - (MapTileEdges.Tolerance / label.PixelsPerDegree) ? degrees - 360.0 : degrees;
    }
}
