using System.Text;
using Msisf.Core.Camera;
using Msisf.Core.Metadata;

namespace Msisf.Adapters.Metadata;

/// <summary>The element of a meta file that says when, and in which state, the rows of a scanned image were exposed.</summary>
internal static class ScanXml
{
    /// <summary>The lines, each after an LF; empty for a frame.</summary>
    /// <param name="frame">The image.</param>
    /// <param name="grid">The rows that are named.</param>
    /// <param name="digits">Of the numbers.</param>
    public static string Lines(FrameMetadata frame, PixelGrid grid, LongEDigits digits)
    {
        if (frame.Scan is not { } scan)
        {
            return string.Empty;
        }

        StringBuilder text = new();
        text.Append(
            CultureInfo.InvariantCulture,
            $"\n    <Scan kind=\"{WordOf(scan.Kind)}\" exposures=\"{scan.Count}\" period=\"{scan.Period:R}\" stages=\"{scan.Stages}\"")
            .Append(scan.Kind == ScanKind.PushFrame ? $" flip=\"{(scan.FlipsFramelets ? "yes" : "no")}\">" : ">");
        for (int row = 0; row < grid.Rows; row++)
        {
            int y = grid.PixelY(row);
            double[] numbers = RowStates.Of(frame, y);
            text.Append(CultureInfo.InvariantCulture, $"\n      <Row v=\"{y}\" mjd=\"")
                .Append(LongE.ToText(frame.SimulationTime.After(numbers[0]).Days, digits)).Append('"');
            for (int i = 0; i < numbers.Length; i++)
            {
                text.Append(' ').Append(RowStates.Names[i]).Append("=\"").Append(LongE.ToText(numbers[i], digits)).Append('"');
            }

            text.Append(" />");
        }

        return text.Append("\n    </Scan>").ToString();
    }

    /// <summary>The kind of a word; null for another word.</summary>
    internal static ScanKind? KindOf(string word) =>
        Enum.GetValues<ScanKind>().Cast<ScanKind?>().FirstOrDefault(kind => WordOf(kind!.Value) == word);

    private static string WordOf(ScanKind kind) => kind switch
    {
        ScanKind.LineScan => "line-scan",
        ScanKind.PushFrame => "push-frame",
        ScanKind.RollingShutter => "rolling-shutter",
        _ => throw new ArgumentOutOfRangeException(nameof(kind), kind, "Not a kind of scan."),
    };
}
