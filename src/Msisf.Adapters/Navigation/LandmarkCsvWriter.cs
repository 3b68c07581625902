using Msisf.Adapters.Catalogues;
using Msisf.Adapters.Metadata;
using Msisf.Core.Navigation;

namespace Msisf.Adapters.Navigation;

/// <summary>Writes the landmarks of a frame as CSV: a line each, with a heading. A vector is three numbers with blanks between.</summary>
public static class LandmarkCsvWriter
{
    private static readonly LandmarkView None = new(new Landmark(1, "1", null, default, null), default, 0.0, 0.0)
    {
        IsLit = false,
        Range = 0.0,
        PixelScale = 0.0,
        Derivatives = default,
    };

    /// <summary>Writes the landmarks.</summary>
    /// <param name="writer">Receives the text.</param>
    /// <param name="referenceRadius">m: radius of the sphere over which heights are counted.</param>
    public static void Write(TextWriter writer, LandmarksOfFrame landmarks, double referenceRadius)
    {
        writer.Write($"number,id,name,{string.Join(',', LandmarkFields.Of(None, referenceRadius).Select(field => field.Name))}\n");
        foreach (LandmarkView view in landmarks.Views)
        {
            writer.Write(string.Join(
                ',',
                [
                    view.Landmark.Number.ToString(CultureInfo.InvariantCulture), CsvLine.Field(view.Landmark.Identity),
                    CsvLine.Field(view.Landmark.Name ?? string.Empty),
                    .. LandmarkFields.Of(view, referenceRadius).Select(field => field.Value),
                ]));
            writer.Write('\n');
        }
    }
}
