using Msisf.Adapters.Catalogues;
using Msisf.Adapters.IO;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.Core.Illumination;
using Msisf.Core.Navigation;
using Msisf.Core.Terrain;
using Msisf.Core.Time;
using Msisf.Core.Tracing;

namespace Msisf.App.Illumination;

/// <summary>Tables of points: the light of each, its horizon by rays of the exact tracer, and its sunrises and sunsets.</summary>
internal sealed class PointTables(
    IlluminationSettings settings, Instant[] times, HorizonSurvey survey, LightSurvey lights, ElevationModel model,
    LightConditions conditions, Func<Instant, Vector3D> sunAt, ProgramHost host)
{
    /// <summary>Directions of a horizon's table: every half degree.</summary>
    private const int Azimuths = 720;

    /// <summary>Writes the tables and a page with plots.</summary>
    /// <exception cref="MsisfException">A point is outside the models, or the disk refuses.</exception>
    public void Write(IReadOnlyList<Landmark> points, IRunProgress progress, CancellationToken cancellation)
    {
        Vector3D[] directions = [.. points.Select(point => point.Direction)];
        List<PointResult> results = [];
        foreach (double height in settings.Heights)
        {
            PlaceHorizons horizons = survey.Find(directions, height, settings.Threads, null, cancellation);
            PointResult[] found = new PointResult[points.Count];
            ParallelOptions parallel = new() { MaxDegreeOfParallelism = settings.Threads, CancellationToken = cancellation };
            Parallel.ForAsync(0, points.Count, parallel, (point, _) =>
            {
                (PlaceLight light, float[] parts) = lights.At(directions, horizons, point);
                PlaceRays rays = survey.RaysFrom(LocalFrame.At(horizons.Radii[point] * directions[point]));
                float[] horizon = survey.HorizonOf(horizons, point);
                List<(bool, Instant)> events = EventsOf(rays, horizon, parts);
                found[point] = new PointResult(
                    points[point], height, rays.Frame, light, IlluminationPage.MeansOf(parts), HorizonAt(rays, horizon), events,
                    PointSpan.Of(times, parts[0] > 0.0f, events), double.RadiansToDegrees(Math.Atan(horizons.Slopes[point])));
                progress.Advance(points[point].Identity);
                return ValueTask.CompletedTask;
            }).GetAwaiter().GetResult();
            results.AddRange(found);
        }

        Write("points.csv", writer =>
        {
            writer.WriteLine(
                "id,name,height_m,lit,disc,longest_dark_h,longest_dark_start,longest_dark_end,longest_light_h,longest_light_start,"
                    + "longest_light_end,nights,flux_horizontal,flux_horizontal_max,flux_tracking,flux_tracking_max,flux_plane,"
                    + "flux_plane_max,earth,earth_whole,sun_and_earth,slope_deg");
            results.ForEach(result => writer.WriteLine(RowOf(result)));
        });
        Write("horizons.csv", writer =>
        {
            writer.WriteLine("id,height_m,azimuth_deg,elevation_deg,distance_m,model");
            foreach (PointResult result in results)
            {
                foreach (HorizonSample at in result.Horizon)
                {
                    writer.WriteLine(string.Create(
                        CultureInfo.InvariantCulture,
                        $"{IdOf(result)},{result.Height:R},{at.Azimuth:R},{at.Elevation:F5},{at.Distance:F0},{at.Model}"));
                }
            }
        });
        Write("sunrises.csv", writer =>
        {
            writer.WriteLine("id,height_m,event,utc");
            foreach (PointResult result in results)
            {
                foreach ((bool isRise, Instant time) in result.Events)
                {
                    writer.WriteLine(string.Create(
                        CultureInfo.InvariantCulture,
                        $"{IdOf(result)},{result.Height:R},{(isRise ? "sunrise" : "sunset")},{ToSecond(time)}"));
                }
            }
        });
        host.Results.WriteLine(new IlluminationPage(settings, host.Version).WritePoints(results, conditions));
    }

    private static string ToSecond(Instant time) => $"{time.Utc.RoundedTo(Duration.OfSeconds(1))}Z";

    private static string IdOf(PointResult result) => CsvLine.Field(result.Point.Identity);

    private void Write(string name, Action<TextWriter> write)
    {
        string path = Path.Combine(settings.Folder, name);
        AtomicFile.WriteText(path, write);
        host.Results.WriteLine(path);
    }

    private string RowOf(PointResult result)
    {
        PlaceLight light = result.Light;
        double steps = settings.Times.Count;
        string Longest(bool isLit) => PointSpan.LongestOf(result.Spans, isLit) is not { } span ? "0,,"
            : string.Create(CultureInfo.InvariantCulture, $"{span.Hours:F4},{ToSecond(span.Start)},{ToSecond(span.End)}");
        int nights = result.Spans.Count(span => !span.IsLit && span.Hours > settings.NightLimit);
        string plane = settings.Plane is null
            ? "," : string.Create(CultureInfo.InvariantCulture, $"{light.Fixed.Mean:F3},{light.Fixed.Greatest:F3}");
        return string.Create(
            CultureInfo.InvariantCulture,
            $"{IdOf(result)},{CsvLine.Field(result.Point.Name ?? string.Empty)},{result.Height:R},"
                + $"{light.LitSteps / steps:F6},{light.DiscPart:F6},{Longest(isLit: false)},{Longest(isLit: true)},{nights},"
                + $"{light.Horizontal.Mean:F3},{light.Horizontal.Greatest:F3},"
                + $"{light.Tracking.Mean:F3},{light.Tracking.Greatest:F3},{plane},{light.EarthSteps / steps:F6},"
                + $"{light.WholeEarthSteps / steps:F6},{light.BothSteps / steps:F6},{result.SlopeDegrees:F3}");
    }

    /// <summary>The horizon between rays that meet the ground and rays that do not, and what is there.</summary>
    private HorizonSample[] HorizonAt(PlaceRays rays, float[] stored)
    {
        IReadOnlyList<ITerrainGrid> models = model.Grid.Models;
        HorizonSample[] samples = new HorizonSample[Azimuths];
        for (int i = 0; i < Azimuths; i++)
        {
            double guess = Math.Atan(stored[(int)((long)i * HorizonSurvey.Columns / Azimuths)]);
            (double elevation, SurfaceHit hit) = rays.HorizonAt(2.0 * Math.PI * i / Azimuths, guess);
            bool isGround = hit.NormalBodyFixed != default;
            samples[i] = new HorizonSample(
                360.0 * i / Azimuths, double.RadiansToDegrees(elevation),
                isGround ? (hit.PointBodyFixed - rays.Frame.PositionBodyFixed).Length : double.NaN,
                !isGround ? string.Empty : hit.Facet.Part < models.Count ? models[hit.Facet.Part].ProductId : "seam");
        }

        return samples;
    }

    /// <summary>Sunrises and sunsets between steps at which the Sun is in view and steps at which it is not.</summary>
    private List<(bool IsRise, Instant Time)> EventsOf(PlaceRays rays, float[] horizon, float[] parts)
    {
        List<(bool, Instant)> events = [];
        for (int step = 1; step < times.Length; step++)
        {
            bool isRise = parts[step] > 0.0f;
            if (isRise != parts[step - 1] > 0.0f)
            {
                events.Add((isRise, lights.ChangeBetween(
                    rays, horizon, times[step - 1], times[step], isRise, sunAt)));
            }
        }

        return events;
    }
}

/// <summary>The light of a point at one height.</summary>
internal sealed record PointResult(
    Landmark Point, double Height, LocalFrame Frame, PlaceLight Light, double[] Means, HorizonSample[] Horizon,
    IReadOnlyList<(bool IsRise, Instant Time)> Events, IReadOnlyList<PointSpan> Spans, double SlopeDegrees);

/// <summary>The horizon of a point in one direction.</summary>
/// <param name="Azimuth">Degrees from north over east.</param>
/// <param name="Elevation">Degrees.</param>
/// <param name="Distance">m: to the obstacle; not a number if there is none.</param>
/// <param name="Model">Model of the obstacle.</param>
internal readonly record struct HorizonSample(double Azimuth, double Elevation, double Distance, string Model);
