using System.Net;
using System.Text;
using Msisf.Adapters.Illumination;
using Msisf.Adapters.IO;
using Msisf.Core.Illumination;
using Msisf.Core.Maps;

namespace Msisf.App.Illumination;

/// <summary>Writes pages that show maps and points. They need no other file and no network.</summary>
internal sealed class IlluminationPage(IlluminationSettings settings, string version)
{
    /// <summary>px: width of the plot of light.</summary>
    private const int LightWidth = 1000;

    /// <summary>Steps of a path that are drawn: more make a page that is slow to open.</summary>
    private const int MostSteps = 10_000;

    /// <summary>Limit on the steps of all points: with many points, fewer steps of each are drawn.</summary>
    private const int StepsOfAllPaths = 200_000;

    /// <summary>A month hour by hour.</summary>
    private const int LeastSteps = 720;

    private const string Style =
        "body{font:15px sans-serif;margin:2em;max-width:70em}figure{display:inline-block;margin:0 2em 2em 0;vertical-align:top}"
            + "img{image-rendering:pixelated;border:1px solid #888}figcaption{max-width:32em}svg{background:#fff;border:1px solid #888}"
            + "td,th{padding:.2em .8em;text-align:right}";

    /// <summary>Writes a PNG of each map, with legend and scale bar, and a page of all; returns the page's path.</summary>
    public string WriteMaps(IReadOnlyList<LightMap> maps, MapGrid grid)
    {
        foreach (LightMap map in maps)
        {
            AtomicFile.Write(
                Path.Combine(settings.Folder, map.Name + ".png"), stream => LightMapPicture.Write(stream, map, grid));
        }

        return Write("maps.html", "Light of a region", maps.Select(map =>
            $"<figure><img src=\"{map.Name}.png\" alt=\"{Text(map.Meaning)}\">"
                + $"<figcaption>{Text(map.Name)}: {Text(map.Meaning)}</figcaption></figure>\n"));
    }

    /// <summary>Writes a page with two plots of each point; returns its path.</summary>
    public string WritePoints(IReadOnlyList<PointResult> results, LightConditions conditions)
    {
        int steps = Math.Clamp(StepsOfAllPaths / results.Count, LeastSteps, MostSteps);
        Vector3D[][] paths = [[.. conditions.SunBodyFixed.Take(steps)], [.. conditions.EarthBodyFixed.Take(steps)]];
        return Write("points.html", "Light of points", results.Select(result => string.Create(
            CultureInfo.InvariantCulture,
            $"<h2>{Text(result.Point.Name ?? result.Point.Identity)}, {result.Height:R} m over the ground</h2>\n"
                + $"<p>Sun in view {100.0 * result.Light.LitSteps / settings.Times.Count:F2} % of the time; longest "
                + $"time without it {PointSpan.LongestOf(result.Spans, false)?.Hours ?? 0.0:F1} h, with it "
                + $"{PointSpan.LongestOf(result.Spans, true)?.Hours ?? 0.0:F1} h.</p>\n"
                + $"<figure>{LightPlot(result)}<figcaption>Visible part of the Sun's disc over time.</figcaption></figure>\n"
                + $"<figure>{HorizonPlot(result, paths)}<figcaption>Horizon (grey) with the paths of the Sun (orange) and the Earth "
                + $"(blue); degrees.</figcaption></figure>\n")));
    }

    private static string Text(string text) => WebUtility.HtmlEncode(text);

    private static string Number(double number) => number.ToString("F1", CultureInfo.InvariantCulture);

    /// <summary>The mean visible part of the Sun in each column of the plot of light.</summary>
    /// <param name="parts">The visible part at each step.</param>
    public static double[] MeansOf(float[] parts)
    {
        double[] means = new double[LightWidth];
        for (int x = 0; x < LightWidth; x++)
        {
            int first = (int)((long)x * parts.Length / LightWidth);
            int end = Math.Max(first + 1, (int)(((long)x + 1) * parts.Length / LightWidth));
            for (int step = first; step < end; step++)
            {
                means[x] += parts[step] / (end - first);
            }
        }

        return means;
    }

    /// <summary>A column of the plot for each 1000th of the time, as high as the mean visible part; dates below.</summary>
    private string LightPlot(PointResult result)
    {
        const int Dates = 8;
        StringBuilder path = new();
        StringBuilder axis = new("<text x=\"2\" y=\"10\">100 %</text>");
        for (int date = 0; date < Dates; date++)
        {
            int x = date * LightWidth / Dates;
            string time = settings.Times[(int)((long)date * (settings.Times.Count - 1) / Dates)].ToString() + "Z";
            axis.Append(
                CultureInfo.InvariantCulture,
                $"<path d=\"M{x} 100v4\" stroke=\"#000\"/><text x=\"{x + 2}\" y=\"113\">{time[..10]} {time[11..16]}</text>");
        }

        for (int x = 0; x < LightWidth; x++)
        {
            if (result.Means[x] > 0.0)
            {
                path.Append(CultureInfo.InvariantCulture, $"M{x}.5 100v{Number(-100.0 * result.Means[x])}");
            }
        }

        return $"<svg width=\"{LightWidth}\" height=\"118\" font-size=\"10\" role=\"img\"><title>Light</title>"
            + $"<path d=\"{path}\" stroke=\"#e08000\"/>{axis}</svg>";
    }

    private static string HorizonPlot(PointResult result, Vector3D[][] paths)
    {
        const double Width = 1080.0;
        const double Height = 240.0;
        const double Below = 5.0; // degrees of the paths that are shown below the lowest horizon
        List<(double X, double Elevation)>[] seen =
            [.. paths.Select(path => path.Select(position => Place(result.Frame, position)).ToList())];
        double horizon = result.Horizon.Min(at => at.Elevation);
        double low = Math.Clamp(seen[0].Min(at => at.Elevation), horizon - Below, horizon) - 1.0;
        double high = Math.Max(result.Horizon.Max(at => at.Elevation), seen.Max(path => path.Max(at => at.Elevation))) + 1.0;
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

        int each = high - low > 20.0 ? 10 : 2;
        for (int degrees = each * (int)Math.Ceiling(low / each); degrees <= high; degrees += each)
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

    private string Write(string name, string title, IEnumerable<string> body)
    {
        string path = Path.Combine(settings.Folder, name);
        AtomicFile.WriteText(path, writer =>
        {
            writer.Write(
                $"<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{title}</title><style>{Style}</style></head>\n"
                    + $"<body><h1>{title}</h1>\n"
                    + $"<p>{settings.Times[0]}Z to {settings.Times[settings.Times.Count - 1]}Z, "
                    + string.Create(CultureInfo.InvariantCulture, $"a step of {settings.StepHours:R} h; the Sun as a ")
                    + (settings.IsPoint ? "point. " : "disc. ")
                    + $"Made by msis {version}.</p>\n");
            foreach (string part in body)
            {
                writer.Write(part);
            }

            writer.Write("</body></html>\n");
        });
        return path;
    }
}
