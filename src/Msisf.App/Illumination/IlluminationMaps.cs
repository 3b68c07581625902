using Msisf.Adapters.Illumination;
using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.Core.Illumination;
using Msisf.Core.Maps;
using Msisf.Core.Time;

namespace Msisf.App.Illumination;

/// <summary>Turns the lights of cells into maps, and writes them.</summary>
/// <param name="grid">Where the cells lie.</param>
internal sealed class IlluminationMaps(IlluminationSettings settings, MapGrid grid, LightMapFiles files, ProgramHost host)
{
    /// <summary>days: the Moon's nodes go around once; what gets no light in that time is called permanently shadowed.</summary>
    public const double LongEnough = 18.6 * 365.25;

    /// <summary>Writes the maps of each height, and a page that shows them.</summary>
    public void Write(IReadOnlyList<CellLights> results)
    {
        List<LightMap> maps = [];
        foreach (CellLights cells in results)
        {
            string suffix = results.Count == 1 ? string.Empty : string.Create(CultureInfo.InvariantCulture, $"_{cells.Height:R}m");
            maps.AddRange(MapsOf(cells).Select(map => map with { Name = map.Name + suffix }));
        }

        foreach (string path in WriteAll(maps))
        {
            host.Results.WriteLine(path);
        }

        host.Results.WriteLine(new IlluminationPage(settings, host.Version).WriteMaps(maps, grid));
        foreach (CellLights cells in results)
        {
            Summarise(cells);
        }
    }

    private IEnumerable<string> WriteAll(IReadOnlyList<LightMap> maps)
    {
        switch (settings.Format)
        {
            case MapFormat.Fits:
                string all = PathOf("illumination.fits");
                files.WriteFits(all, maps);
                yield return all;
                break;
            case MapFormat.GeoTiff:
                foreach (LightMap map in maps)
                {
                    files.WriteGeoTiff(PathOf($"{map.Name}.tif"), map, host.Environment("MSISF_GDAL"));
                    yield return PathOf($"{map.Name}.tif");
                }

                break;
            default:
                foreach (LightMap map in maps)
                {
                    files.WriteNpy(PathOf($"{map.Name}.npy"), map);
                    yield return PathOf($"{map.Name}.npy");
                }

                files.WriteJson(PathOf("maps.json"), [.. maps.Select(map => (map, $"{map.Name}.npy"))]);
                yield return PathOf("maps.json");
                break;
        }

        string PathOf(string name) => Path.Combine(settings.Folder, name);
    }

    private IEnumerable<LightMap> MapsOf(CellLights cells)
    {
        double steps = settings.Times.Count;
        double hours = settings.StepHours;
        double start = settings.Times[0].Mjd;
        double days = settings.Times.Step / Duration.Day;
        yield return Of("lit", string.Empty, "Part of the time with any of the Sun in view.", light => light.LitSteps / steps);
        yield return Of("disc", string.Empty, "Mean visible part of the Sun's disc, by area.", light => light.DiscPart);
        yield return Of("longest_dark", "h", "Longest time without Sun, a whole number of steps.", light => hours * light.Dark.Count);
        yield return Of("longest_dark_start", "d", "Days from the interval's start to the longest time without Sun.",
            light => OfRun(light.Dark, light.Dark.First));
        yield return Of("longest_dark_end", "d", "Days from the interval's start to the end of the longest time without Sun.",
            light => OfRun(light.Dark, light.Dark.End));
        yield return Of("longest_light", "h", "Longest time with Sun, a whole number of steps.", light => hours * light.Light.Count);
        yield return Of("longest_light_start", "d", "Days from the interval's start to the longest time with Sun.",
            light => OfRun(light.Light, light.Light.First));
        yield return Of("longest_light_end", "d", "Days from the interval's start to the end of the longest time with Sun.",
            light => OfRun(light.Light, light.Light.End));
        yield return Of("nights", string.Empty, FormattableString.Invariant(
            $"Times without Sun that are longer than {settings.NightLimit} h."), light => light.Nights);
        yield return Of("flux_horizontal", "W/m2", "Mean light on a horizontal plane.", light => light.Horizontal.Mean);
        yield return Of("flux_horizontal_max", "W/m2", "Greatest light on a horizontal plane.", light => light.Horizontal.Greatest);
        yield return Of("flux_tracking", "W/m2", "Mean light on a plane turned to the Sun.", light => light.Tracking.Mean);
        yield return Of("flux_tracking_max", "W/m2", "Greatest light on a plane turned to the Sun.", light => light.Tracking.Greatest);
        if (settings.Plane is { } plane)
        {
            string name = string.Create(
                CultureInfo.InvariantCulture,
                $"a plane tilted by {plane.Tilt:R} degrees, its normal at {plane.Azimuth:R} degrees from north over east");
            yield return Of("flux_plane", "W/m2", $"Mean light on {name}.", light => light.Fixed.Mean);
            yield return Of("flux_plane_max", "W/m2", $"Greatest light on {name}.", light => light.Fixed.Greatest);
        }

        yield return Of("earth", string.Empty, "Part of the time with any of the Earth in view.", light => light.EarthSteps / steps);
        yield return Of("earth_whole", string.Empty, "Part of the time with all of the Earth in view.",
            light => light.WholeEarthSteps / steps);
        yield return Of("sun_and_earth", string.Empty, "Part of the time with any of the Sun and any of the Earth in view.",
            light => light.BothSteps / steps);
        yield return Of("never_lit", string.Empty, FormattableString.Invariant(
            $"1 where no light comes in the {settings.Times.Length / Duration.Day:R} days from MJD {start:R}."),
            light => light.LitSteps == 0 ? 1 : 0);
        yield return new LightMap("slope", "degree", "Slope of the ground.", [.. cells.Slopes.Select(
            slope => (float)double.RadiansToDegrees(Math.Atan(slope)))])
        { Height = cells.Height };

        double OfRun(StepRun run, int step) => run.Count > 0 ? days * step : double.NaN;

        LightMap Of(string name, string unit, string meaning, Func<PlaceLight, double> value)
        {
            float[] values = new float[cells.Lights.Length];
            Array.Fill(values, float.NaN);
            foreach (int cell in cells.Ground)
            {
                values[cell] = (float)value(cells.Lights[cell]);
            }

            return new LightMap(name, unit, meaning, values) { Height = cells.Height };
        }
    }

    private void Summarise(CellLights cells)
    {
        PlaceLight[] lights = cells.Lights;
        int[] dark = [.. cells.Ground.Where(cell => lights[cell].LitSteps == 0)];
        double area = dark.Sum(cell => grid.AreaOf(cell / grid.Samples, cell % grid.Samples)) / 1e6; // m2 in a km2
        int best = cells.Ground.MaxBy(cell => lights[cell].LitSteps);
        int ground = cells.Ground.Count();
        string shadow = settings.Times.Length / Duration.Day >= LongEnough ? "permanently shadowed" : "never lit in the interval";
        string outside = ground == lights.Length ? string.Empty : Invariant(
            $" {lights.Length - ground} cells lie outside the models and have no data.");
        host.Log.Note(Invariant(
            $"{cells.Height:R} m over the ground: {dark.Length} of {ground} cells ({area:G6} km2) {shadow}; the best cell, line "
                + $"{best / grid.Samples}, sample {best % grid.Samples}, is lit "
                + $"{100.0 * lights[best].LitSteps / settings.Times.Count:F2} % of the time.{outside}"));
    }
}

/// <summary>The light of the cells of a map.</summary>
/// <param name="Height">m over the ground.</param>
/// <param name="Slopes">Tangents of the ground's slope; NaN where the models have no ground.</param>
internal sealed record CellLights(double Height, PlaceLight[] Lights, float[] Slopes)
{
    /// <summary>The cells with ground.</summary>
    public IEnumerable<int> Ground => Enumerable.Range(0, Slopes.Length).Where(cell => !float.IsNaN(Slopes[cell]));
}
