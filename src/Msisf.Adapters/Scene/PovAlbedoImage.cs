using Msisf.Adapters.Render;
using Msisf.Core.Render.Photometry;

namespace Msisf.Adapters.Scene;

/// <summary>A level of a map of the Moon's reflectance as a 16-bit image for POV-Ray's image_map, with a row more over each pole.</summary>
public static class PovAlbedoImage
{
    /// <summary>Radiance factor that the image's white has with the Sun in the zenith, by Lambert's law.</summary>
    public static double DiffuseOf(AlbedoMap map) => (map.Offset + (map.Step * ushort.MaxValue)) / map.Reference.CosIncidence;

    /// <summary>Writes the image.</summary>
    /// <param name="stream">Receives it.</param>
    /// <param name="name">The map's name, for messages.</param>
    /// <exception cref="BadInputException">The map does not show the whole Moon, or a value is negative.</exception>
    public static void Write(Stream stream, string name, AlbedoMap map, int level)
    {
        if (!map.Extent.ReachesNorthPole || !map.Extent.ReachesSouthPole)
        {
            throw new BadInputException($"{name}: shows a part of the Moon; POV-Ray needs a map of all of it. Use --renderer native.");
        }

        AlbedoMapLevel wanted = map.Levels[level];
        double white = map.Offset + (map.Step * ushort.MaxValue);
        ReadOnlySpan<ushort> codes = wanted.Codes.Span;
        ushort[] greys = new ushort[codes.Length + (2 * wanted.Width)];
        for (int i = 0; i < codes.Length; i++)
        {
            double grey = (map.Offset + (map.Step * codes[i])) / white;
            greys[wanted.Width + i] = codes[i] != 0 && grey >= 0.0
                ? (ushort)Math.Min((grey * ushort.MaxValue) + 0.5, ushort.MaxValue)
                : throw new BadInputException(
                    $"{name}: has places without a reflectance, which POV-Ray can't draw. Use --renderer native.");
        }

        FillBeyondPole(greys.AsSpan(wanted.Width, wanted.Width), greys.AsSpan(0, wanted.Width));
        FillBeyondPole(greys.AsSpan(codes.Length, wanted.Width), greys.AsSpan(codes.Length + wanted.Width));
        PngWriter.Write(stream, greys, wanted.Width, GreyTransfer.Linear);
    }

    /// <summary>
    /// Beyond a pole lies the other side of its own row; POV-Ray would go on with the row at the other pole.
    /// </summary>
    private static void FillBeyondPole(ReadOnlySpan<ushort> row, Span<ushort> beyond)
    {
        for (int column = 0; column < row.Length; column++)
        {
            // With an odd number of columns the other side lies between two of them.
            int other = row[(column + (row.Length / 2)) % row.Length];
            int next = row[(column + ((row.Length + 1) / 2)) % row.Length];
            beyond[column] = (ushort)((other + next + 1) / 2);
        }
    }
}
