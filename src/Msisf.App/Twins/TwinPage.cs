using System.Net;
using System.Text;
using Msisf.Core.Comparison;

namespace Msisf.App.Twins;

/// <summary>Writes the page of a twin. It needs no other file and no network.</summary>
internal sealed class TwinPage(TwinResult result)
{
    private const string Style =
        "body{font:15px sans-serif;margin:2em}figure{display:inline-block;margin:0 1em 1em 0;vertical-align:top}"
            + "img{image-rendering:pixelated;border:1px solid #888;max-width:none}figcaption{max-width:22em}"
            + "td,th{padding:.2em .8em;text-align:right}svg{border:1px solid #888;background:#fff}";

    /// <summary>Differences are drawn to this part of the real image's brightest level, ratios as far from 1.</summary>
    private const double Span = 0.2;

    private int Samples => result.Plan.Pixels.Samples;

    private int Lines => result.Plan.Pixels.Lines;

    public void Write(TextWriter writer)
    {
        string title = Text($"Twin of {Path.GetFileName(result.Label.Path)}");
        writer.Write(
            $"<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{title}</title><style>{Style}</style></head>\n"
                + $"<body><h1>{title}</h1>\n");
        writer.Write(Invariant(
            $"<p>{Text(result.Label.Kind)}, {Text(result.Camera.Name)}, {Samples} x {Lines} px, band {result.Band.Index + 1}"));
        writer.Write(Invariant(
            $"{(result.Band.Nanometres is { } band ? $" ({band:R} nm)" : string.Empty)}; drawn by msis {Text(result.Version)}, "
                + $"--reflectance {Text(result.Settings.Native.ReflectanceText)}.</p>\n"));
        if (result.Comparison is { } comparison)
        {
            WriteComparison(writer, comparison);
        }
        else
        {
            TwinPicture picture = new(result.Drawn, Samples);
            writer.Write(Figure(
                picture.Element(result.Drawn, 0.0, TwinPicture.WhiteOf(result.Drawn), isTwoSided: false, "The twin"), "The twin"));
        }

        writer.Write("</body></html>\n");
    }

    /// <summary>A number; a dash where it has no value, as the correlation of an image without contrast.</summary>
    private static string Number(double? number, string format) => number?.ToString(format, CultureInfo.InvariantCulture) ?? "&ndash;";

    private static string Percent(double? part, string format) =>
        part is { } known ? $"{Number(100.0 * known, format)} %" : Number(null, format);

    private static string Text(string text) => WebUtility.HtmlEncode(text);

    private static string Figure(string picture, string caption) => $"<figure>{picture}<figcaption>{caption}</figcaption></figure>\n";

    private void WriteComparison(TextWriter writer, TwinComparison found)
    {
        ImageAgreement agreement = found.Agreement;
        writer.Write(Invariant(
            $"<p><b>Correlation {Number(agreement.Correlation, "F4")}, relative rms {Percent(agreement.Rms, "F2")}</b> over "
                + $"{agreement.Count} pixels "
                + $"after one factor ({agreement.Factor:G6}). {ShiftText(found.Whole)}</p>\n"));
        WritePictures(writer, found);
        writer.Write("<h2>By phase angle</h2>\n<table><tr><th>degrees</th><th>pixels</th><th>real / twin</th><th>correlation</th>"
            + "<th>relative rms</th></tr>\n");
        foreach (PhaseAgreement part in found.ByPhase)
        {
            writer.Write(Invariant(
                $"<tr><td>{part.Low:F0} to {part.High:F0}</td><td>{part.Agreement.Count}</td><td>{Number(part.Ratio, "F3")}</td>"
                    + $"<td>{Number(part.Agreement.Correlation, "F3")}</td><td>{Percent(part.Agreement.Rms, "F1")}</td></tr>\n"));
        }

        writer.Write(Invariant(
            $"</table>\n<p>Ratios are to that of the whole image; each row's correlation and rms are after a factor of its own.</p>\n"
                + $"<h2>Shifts of blocks of {ShiftFinder.BlockSide} px</h2>\n"));
        WriteBlocks(writer, found.Blocks, new TwinPicture(found.Real, Samples).LiesOnSide);
    }

    private static string ShiftText(ImageShift? shift) => shift is { } found
        ? Invariant(
            $"The twin fits best moved by {found.Right:F2} px along the samples and {found.Down:F2} px along the lines (correlation "
                + $"{found.Correlation:F4}; unmoved {found.Unshifted:F4}).")
        : Invariant($"No shift within {ShiftFinder.Reach} px fits best.");

    private void WritePictures(TextWriter writer, TwinComparison found)
    {
        float factor = (float)found.Agreement.Factor;
        float[] twin = Of(found.Real, (real, drawn) => factor * drawn);
        float[] difference = Of(found.Real, (real, drawn) => real - (factor * drawn));
        float[] ratio = Of(found.Real, (real, drawn) => real / (factor * drawn));
        double white = TwinPicture.WhiteOf(found.Real);
        TwinPicture picture = new(found.Real, Samples);
        if (picture.LiesOnSide)
        {
            writer.Write("<p>The strips lie on their side: lines run from left to right, samples downwards.</p>\n");
        }

        writer.Write(Figure(picture.Element(found.Real, 0.0, white, isTwoSided: false, "The real image"), "The real image"));
        writer.Write(Figure(picture.Element(twin, 0.0, white, isTwoSided: false, "The twin"), "The twin, times the factor"));
        writer.Write(Figure(
            picture.Element(difference, -Span * white, Span * white, isTwoSided: true, "The difference"),
            Invariant($"Real less twin, {-Span * white:G3} (blue) to {Span * white:G3} (red)")));
        writer.Write(Figure(
            picture.Element(ratio, 1.0 - Span, 1.0 + Span, isTwoSided: true, "The ratio"),
            Invariant($"Real / twin, {1.0 - Span:F1} (blue) to {1.0 + Span:F1} (red)")));
    }

    /// <summary>A number for each pixel that both images have.</summary>
    private float[] Of(float[] real, Func<float, float, float> number) =>
        [.. real.Zip(result.Drawn, (r, d) => ImageAgreement.IsIn(r, d) ? number(r, d) : float.NaN)];

    /// <summary>An arrow for each block, ten times as long as its shift, on the outline of the image.</summary>
    private void WriteBlocks(TextWriter writer, IReadOnlyList<BlockShift> blocks, bool liesOnSide)
    {
        const double longest = 900.0;
        const double stretch = 10.0;
        double scale = longest / Math.Max(Samples, Lines);
        (double X, double Y) Turned(double samples, double lines) =>
            liesOnSide ? (scale * lines, scale * samples) : (scale * samples, scale * lines);
        (double width, double height) = Turned(Samples, Lines);
        StringBuilder svg = new();
        svg.Append(
            CultureInfo.InvariantCulture,
            $"<svg width=\"{width:F0}\" height=\"{height:F0}\" overflow=\"visible\" role=\"img\"><title>Shifts</title>");
        foreach (BlockShift block in blocks)
        {
            (double x, double y) = Turned(block.Left + (0.5 * block.Width), block.Top + (0.5 * block.Height));
            svg.Append(CultureInfo.InvariantCulture, $"<circle cx=\"{x:F1}\" cy=\"{y:F1}\" r=\"1.5\" fill=\"#888\"/>");
            if (block.Shift is { } shift)
            {
                (double right, double down) = Turned(stretch * shift.Right, stretch * shift.Down);
                svg.Append(
                    CultureInfo.InvariantCulture, $"<path d=\"M{x:F1} {y:F1}l{right:F1} {down:F1}\" stroke=\"#c00\"/>");
            }
        }

        writer.Write(svg.Append("</svg>\n").ToString());
        double[] ofSamples = [.. blocks.Where(block => block.Shift is not null).Select(block => block.Shift!.Value.Right)];
        double[] ofLines = [.. blocks.Where(block => block.Shift is not null).Select(block => block.Shift!.Value.Down)];
        string medians = ofSamples.Length == 0 ? string.Empty : Invariant(
            $"; medians {Median(ofSamples):F2} px along the samples, {Median(ofLines):F2} px along the lines");
        writer.Write(Invariant(
            $"<p>Arrows are ten times as long as the shifts. {ofSamples.Length} of {blocks.Count} blocks have one{medians}. Where all "
                + $"blocks agree, the pointing is off; where they differ, the terrain is.</p>\n"));
    }

    private static double Median(double[] numbers)
    {
        double[] sorted = [.. numbers.Order()];
        return 0.5 * (sorted[(sorted.Length - 1) / 2] + sorted[sorted.Length / 2]);
    }
}
