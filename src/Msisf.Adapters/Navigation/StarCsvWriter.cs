using Msisf.Adapters.Catalogues;
using Msisf.Adapters.Metadata;
using Msisf.Core.Sky;

namespace Msisf.Adapters.Navigation;

/// <summary>Writes the stars of a frame as CSV: a line each, with a heading. A vector is numbers with blanks between.</summary>
public static class StarCsvWriter
{
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
