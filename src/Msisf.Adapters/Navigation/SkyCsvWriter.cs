using Msisf.Adapters.Catalogues;
using Msisf.Adapters.Metadata;
using Msisf.Core.Sky;

namespace Msisf.Adapters.Navigation;

/// <summary>Writes what a frame shows of the sky as CSV: a line each, with a heading. A vector is numbers with blanks between.</summary>
public static class SkyCsvWriter
{
    /// <summary>Writes planets, the Earth and the Sun.</summary>
    /// <param name="writer">Receives the text.</param>
    public static void Write(TextWriter writer, BodiesOfFrame bodies)
    {
        writer.Write($"name,{string.Join(',', BodyFields.Names)}\n");
        foreach (BodyView view in bodies.Views)
        {
            writer.Write($"{view.Place.Body.Name},{string.Join(',', BodyFields.Of(view).Select(field => field.Value))}\n");
        }
    }

    /// <summary>Writes the stars.</summary>
    /// <param name="writer">Receives the text.</param>
    public static void Write(TextWriter writer, StarsOfFrame stars)
    {
        writer.Write($"id,{string.Join(',', StarFields.Names)}\n");
        foreach (StarView view in stars.Views)
        {
            writer.Write($"{CsvLine.Field(view.Star.Identity)},{string.Join(',', StarFields.Of(view).Select(field => field.Value))}\n");
        }
    }
}
