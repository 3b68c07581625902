using Msisf.App.Settings.Specs;
using Msisf.Core.Ephemeris;
using Msisf.Core.Render;
using Msisf.Core.Terrain;

namespace Msisf.App.Settings;

/// <summary>Reads which body is drawn, and refuses what is known of the Moon only.</summary>
internal static class BodyChoice
{
    /// <summary>The body.</summary>
    /// <param name="resolution">The resolution of the elevation model.</param>
    /// <exception cref="UsageException">Another option has no meaning with the body.</exception>
    public static CelestialBody Read(OptionValues values, RendererKind renderer, GridResolution resolution)
    {
        CelestialBody body = CelestialBody.Of(SurfaceOptions.Body.Read(values));
        if (body.IsMoon)
        {
            return body;
        }

        if (renderer != RendererKind.Native)
        {
            throw Refused(body, "needs --renderer native: POV-Ray's patterns are those of the Moon.", RendererOptions.Renderer);
        }

        if (!values.IsGiven(SurfaceOptions.Ldem))
        {
            throw Refused(body, $"needs {SurfaceOptions.Ldem.Name} with the label of a model of {body.Name}.", SurfaceOptions.Ldem);
        }

        if (SurfaceOptions.Ldem.ReadAll(values).Count > 1)
        {
            throw Refused(body, $"is drawn from one model; several {SurfaceOptions.Ldem.Name} are of the Moon only.", SurfaceOptions.Ldem);
        }

        if (resolution.PixelsPerDegree is null)
        {
            throw Refused(body, "needs a model of latitude and longitude: other maps are read of the Moon only.", SurfaceOptions.Ldem);
        }

        OptionSpec[] orbits = [CameraOptions.KeplerSet, CameraOptions.StateVectors];
        if (orbits.FirstOrDefault(values.IsGiven) is { } orbit)
        {
            throw Refused(
                body,
                $"can't be combined with {orbit.Name}: orbits are computed with the Moon's gravity. Give positions.",
                orbit);
        }

        if (values.IsGiven(NativeOptions.Refine))
        {
            throw Refused(
                body, $"can't be combined with {NativeOptions.Refine.Name}: what it invents is the Moon's. Leave it out.",
                NativeOptions.Refine);
        }

        OptionSpec[] maps = [AlbedoOptions.Map, NativeOptions.HapkeMap];
        return maps.FirstOrDefault(option => values.Text(option) is { } text && text != AlbedoOptions.NoMap) is { } map
            ? throw Refused(body, $"can't be combined with {map.Name}: the known maps are those of the Moon. Leave it out.", map)
            : body;
    }

    private static UsageException Refused(CelestialBody body, string reason, OptionSpec other) =>
        (UsageException)new UsageException($"{SurfaceOptions.Body.Name} {body.Name.ToLowerInvariant()} {reason}")
            .About(SurfaceOptions.Body, other);
}
