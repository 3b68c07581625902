using Msisf.Adapters.Illumination;
using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.Core.Illumination;

namespace Msisf.App.Illumination;

/// <summary>Turns the lights of cells into maps, and writes them.</summary>
internal sealed class IlluminationMaps(IlluminationSettings settings, MapPlacement placement, ProgramHost host)
{
    /// <summary>days: the Moon's nodes go around once; what gets no light in that time is called permanently shadowed.</summary>
    public const double LongEnough = 18.6 * 365.25;

    /// <summary>Writes the maps of each height, and a page that shows them.</summary>
    public void Write(IReadOnlyList<(double Height, PlaceLight[] Lights, float[] Slopes)> results)
    {
        List<LightMap> maps = [];
        foreach ((double height, PlaceLight[] lights, float[] slopes) in results)
        {
            string suffix = results.Count == 1 ? string.Empty : string.Create(CultureInfo.InvariantCulture, $"_{height:R}m");
            maps.AddRange(MapsOf(height, lights, slopes).Select(map => map with { Name = map.Name + suffix }));
        }

        foreach (string path in WriteAll(maps))
        {
            host.Results.WriteLine(path);
        }

        host.Results.WriteLine(new IlluminationPage(settings, host.Version).WriteMaps(maps, placement));
        foreach ((double height, PlaceLight[] lights, _) in results)
        {
            Summarise(height, lights);
        }
    }

    private IEnumerable<string> WriteAll(IReadOnlyList<LightMap> maps)
    {
        MapTimes times = new(
            settings.Times[0].ToIsoUtc(), settings.Times[settings.Times.Count - 1].ToIsoUtc(), settings.StepHours,
            settings.IsPoint ? "point" : "disc");
        if (settings.Format == MapFormat.Fits)
        {
            string path = Path.Combine(settings.Folder, "illumination.fits");
            LightMapFiles.WriteFits(path, maps, placement, times);
            return [path];
        }

        return maps.Select(map =>
        {
            bool isTiff = settings.Format == MapFormat.GeoTiff;
            string path = Path.Combine(settings.Folder, map.Name + (isTiff ? ".tif" : ".npy"));
            if (isTiff)
            {
                LightMapFiles.WriteGeoTiff(path, map, placement, times, host.Environment("MSISF_GDAL"));
            }
            else
            {
                LightMapFiles.WriteNpy(path, map, placement);
            }

            return path;
        });
    }

    private IEnumerable<LightMap> MapsOf(double height, PlaceLight[] lights, float[] slopes)
    {
        double steps = settings.Times.Count;
        double hours = settings.StepHours;
        double start = settings.Times[0].Days;
        double days = settings.Times.StepDays;
        yield return Of("lit", string.Empty, "Part of the time with any of the Sun in view.", light => light.LitSteps / steps);
        yield return Of("disc", string.Empty, "Mean visible part of the Sun's disc, by area.", light => light.DiscPart);
        yield return Of("longest_dark", "h", "Longest time without Sun, a whole number of steps.", light => hours * light.Dark.Count);
        yield return Of("longest_dark_start", "d", "Days from the interval's start to the longest time without Sun.",
            light => days * light.Dark.First);
        yield return Of("longest_dark_end", "d", "Days from the interval's start to the end of the longest time without Sun.",
            light => days * light.Dark.End);
        yield return Of("longest_light", "h", "Longest time with Sun, a whole number of steps.", light => hours * light.Light.Count);
        yield return Of("longest_light_start", "d", "Days from the interval's start to the longest time with Sun.",
            light => days * light.Light.First);
        yield return Of("longest_light_end", "d", "Days from the interval's start to the end of the longest time with Sun.",
            light => days * light.Light.End);
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
            $"1 where no light comes in the {settings.Times.LengthDays:R} days from MJD {start:R}."), light => light.LitSteps == 0 ? 1 : 0);
        yield return Map(
            "slope", "degree", "Slope of the ground.", slopes.Select(slope => (float)double.RadiansToDegrees(Math.Atan(slope))));

        LightMap Of(string name, string unit, string meaning, Func<PlaceLight, double> value) =>
            Map(name, unit, meaning, lights.Select(light => (float)value(light)));

        LightMap Map(string name, string unit, string meaning, IEnumerable<float> values) =>
            new(name, unit, meaning, [.. values]) { Height = height };
    }

    private void Summarise(double height, PlaceLight[] lights)
    {
        double square = placement.Cell * placement.Cell / 1e6;
        int dark = lights.Count(light => light.LitSteps == 0);
        int best = Enumerable.Range(0, lights.Length).MaxBy(cell => lights[cell].LitSteps);
        string shadow = settings.Times.LengthDays >= LongEnough ? "permanently shadowed" : "never lit in the interval";
        host.Log.Note(string.Create(
            CultureInfo.InvariantCulture,
            $"{height:R} m over the ground: {dark} of {lights.Length} cells ({dark * square:G6} km2 of the map) {shadow}; the best cell, "
                + $"line {best / placement.Samples}, sample {best % placement.Samples}, is lit "
                + $"{100.0 * lights[best].LitSteps / settings.Times.Count:F2} % of the time."));
    }
}
