using System.Net;
using System.Text;
using Msisf.Adapters.Illumination;
using Msisf.Adapters.IO;
using Msisf.Core.Illumination;

namespace Msisf.App.Illumination;

/// <summary>Writes pages that show maps and points. They need no other file and no network.</summary>
internal sealed class IlluminationPage(IlluminationSettings settings, string version)
{
    private const string Style =
        "body{font:15px sans-serif;margin:2em;max-width:70em}figure{display:inline-block;margin:0 2em 2em 0;vertical-align:top}"
            + "img{image-rendering:pixelated;border:1px solid #888}figcaption{max-width:32em}svg{background:#fff;border:1px solid #888}"
            + "td,th{padding:.2em .8em;text-align:right}";

    /// <summary>Writes a PNG of each map, with legend and scale bar, and a page of all; returns the page's path.</summary>
    public string WriteMaps(IReadOnlyList<LightMap> maps, MapPlacement placement)
    {
        StringBuilder body = new();
        foreach (LightMap map in maps)
        {
            string name = map.Name + ".png";
            AtomicFile.Write(Path.Combine(settings.Folder, name), stream => LightMapPicture.Write(stream, map, placement));
            body.Append(
                CultureInfo.InvariantCulture,
                $"<figure><img src=\"{name}\" alt=\"{Text(map.Meaning)}\">"
                    + $"<figcaption>{Text(map.Name)}: {Text(map.Meaning)}</figcaption></figure>\n");
        }

        return Write("maps.html", "Light of a region", body.ToString());
    }

    /// <summary>Writes a page with two plots of each point; returns its path.</summary>
    public string WritePoints(IReadOnlyList<PointResult> results, LightConditions conditions)
    {
        StringBuilder body = new();
        foreach (PointResult result in results)
        {
            string title = string.Create(
                CultureInfo.InvariantCulture, $"{result.Point.Name ?? result.Point.Identity}, {result.Height:R} m over the ground");
            body.Append(CultureInfo.InvariantCulture, $"<h2>{Text(title)}</h2>\n");
            body.Append(
                CultureInfo.InvariantCulture,
                $"<p>Sun in view {100.0 * result.Light.LitSteps / settings.Times.Count:F2} % of the time; longest "
                    + $"time without it {PointSpan.LongestOf(result.Spans, false)?.Hours ?? 0.0:F1} h, with it "
                    + $"{PointSpan.LongestOf(result.Spans, true)?.Hours ?? 0.0:F1} h.</p>\n");
            body.Append("<figure>").Append(LightPlot(result)).Append(
                "<figcaption>Visible part of the Sun's disc over time.</figcaption></figure>\n");
            body.Append("<figure>").Append(HorizonPlot(result, conditions)).Append(
                "<figcaption>Horizon (grey) with the paths of the Sun (orange) and the Earth (blue); degrees.</figcaption></figure>\n");
        }

        return Write("points.html", "Light of points", body.ToString());
    }

    private static string Text(string text) => WebUtility.HtmlEncode(text);

    private static string Number(double number) => number.ToString("F1", CultureInfo.InvariantCulture);

    /// <summary>A column of the plot for each 1000th of the time, as high as the mean visible part; dates below.</summary>
    private string LightPlot(PointResult result)
    {
        const int Width = 1000;
        const int Dates = 8;
        StringBuilder path = new();
        StringBuilder axis = new("<text x=\"2\" y=\"10\">100 %</text>");
        for (int date = 0; date < Dates; date++)
        {
            int x = date * Width / Dates;
            string time = settings.Times[(int)((long)date * (settings.Times.Count - 1) / Dates)].ToIsoUtc();
            axis.Append(
                CultureInfo.InvariantCulture,
                $"<path d=\"M{x} 100v4\" stroke=\"#000\"/><text x=\"{x + 2}\" y=\"113\">{time[..10]} {time[11..16]}</text>");
        }

        for (int x = 0; x < Width; x++)
        {
            int first = (int)((long)x * result.Parts.Length / Width);
            int end = Math.Max(first + 1, (int)(((long)x + 1) * result.Parts.Length / Width));
            double mean = 0.0;
            for (int step = first; step < Math.Min(end, result.Parts.Length); step++)
            {
                mean += result.Parts[step] / (end - first);
            }

            if (mean > 0.0)
            {
                path.Append(CultureInfo.InvariantCulture, $"M{x}.5 100v{Number(-100.0 * mean)}");
            }
        }

        return $"<svg width=\"{Width}\" height=\"118\" font-size=\"10\" role=\"img\"><title>Light</title>"
            + $"<path d=\"{path}\" stroke=\"#e08000\"/>{axis}</svg>";
    }

    private static string HorizonPlot(PointResult result, LightConditions conditions)
    {
        const double Width = 1080.0;
        const double Height = 240.0;
        double low = result.Horizon.Min(at => at.Elevation);
        double high = result.Horizon.Max(at => at.Elevation);
        Vector3D[][] paths = [[.. conditions.SunBodyFixed.Take(MostPoints)], [.. conditions.EarthMoonMe.Take(MostPoints)]];
        List<(double X, double Elevation)>[] seen =
            [.. paths.Select(path => path.Select(position => Place(result.Frame, position)).ToList())];
        (low, high) = (Math.Min(low, seen[0].Min(at => at.Elevation)) - 1.0, Math.Max(high, seen[0].Max(at => at.Elevation)) + 1.0);
        double Y(double elevation) => Height * (high - elevation) / (high - low);
        StringBuilder svg = new();
        svg.Append(
            CultureInfo.InvariantCulture,
            $"<svg width=\"{Width:F0}\" height=\"{Height:F0}\" role=\"img\"><title>Horizon</title><path fill=\"#999\" d=\"M0 {Height:F0}");
        foreach (HorizonSample at in result.Horizon)
        {
            svg.Append(CultureInfo.InvariantCulture, $"L{Number(at.Azimuth * Width / 360.0)} {Number(Y(at.Elevation))}");
        }

        svg.Append(CultureInfo.InvariantCulture, $"L{Width:F0} {Number(Y(result.Horizon[0].Elevation))}V{Height:F0}Z\"/>");
        foreach ((List<(double X, double Elevation)> path, string color) in seen.Zip(["#e08000", "#0060c0"]))
        {
            svg.Append(CultureInfo.InvariantCulture, $"<path fill=\"none\" stroke=\"{color}\" d=\"");
            double before = double.NaN;
            foreach ((double x, double elevation) in path)
            {
                svg.Append(Math.Abs(x - before) < 0.5 ? 'L' : 'M').Append(
                    CultureInfo.InvariantCulture, $"{Number(x * Width)} {Number(Y(elevation))}");
                before = x;
            }

            svg.Append("\"/>");
        }

        for (int degrees = (int)Math.Ceiling(low); degrees <= high; degrees += high - low > 20.0 ? 10 : 2)
        {
            svg.Append(CultureInfo.InvariantCulture, $"<text x=\"2\" y=\"{Number(Y(degrees))}\" font-size=\"10\">{degrees}</text>");
        }

        foreach (int azimuth in (int[])[90, 180, 270])
        {
            svg.Append(
                CultureInfo.InvariantCulture, $"<text x=\"{azimuth * 3}\" y=\"{Height - 4.0:F0}\" font-size=\"10\">{azimuth}</text>");
        }

        return svg.Append("</svg>").ToString();
    }

    private static (double X, double Elevation) Place(LocalFrame frame, Vector3D position)
    {
        Vector3D local = frame.ToLocal(position - frame.PositionBodyFixed);
        double turns = Math.Atan2(local.X, local.Y) / (2.0 * Math.PI);
        return (turns < 0.0 ? turns + 1.0 : turns, double.RadiansToDegrees(Math.Atan2(local.Z, double.Hypot(local.X, local.Y))));
    }

    /// <summary>Steps of a path that are drawn: more make a page that is slow to open.</summary>
    private const int MostPoints = 10_000;

    private string Write(string name, string title, string body)
    {
        string path = Path.Combine(settings.Folder, name);
        AtomicFile.WriteText(path, writer => writer.Write(
            $"<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{title}</title><style>{Style}</style></head>\n"
                + $"<body><h1>{title}</h1>\n<p>{settings.Times[0].ToIsoUtc()} to {settings.Times[settings.Times.Count - 1].ToIsoUtc()}, "
                + string.Create(CultureInfo.InvariantCulture, $"a step of {settings.StepHours:R} h; the Sun as a ")
                + (settings.IsPoint ? "point. " : "disc. ")
                + $"Made by msis {version}.</p>\n{body}</body></html>\n"));
        return path;
    }
}
