using Msisf.Adapters.Terrain;
using Msisf.App.Settings.Specs;
using Msisf.Core.Errors;
using Msisf.Core.Render;
using Msisf.Core.Terrain;

namespace Msisf.App.Settings;

/// <summary>Reads which elevation model <c>--ldem</c> and <c>--res</c> mean.</summary>
internal static class ModelChoice
{
    /// <summary>The resolution of the run's model: a polar map has its own.</summary>
    /// <exception cref="UsageException">The options contradict the map that --ldem names.</exception>
    public static GridResolution ResolutionOf(OptionValues values, RendererKind renderer)
    {
        if (SurfaceOptions.Ldem.ReadIfGiven(values) is not { } path || LdemCatalog.TryReadMap(path)?.Polar is not { } map)
        {
            return SurfaceOptions.Resolution.Read(values);
        }

        if (values.IsGiven(SurfaceOptions.Resolution))
        {
            throw new UsageException(
                $"{SurfaceOptions.Resolution.Name} has no meaning with --ldem {path}, a polar map of {map.Resolution}. Leave it out.")
                .About(SurfaceOptions.Resolution, SurfaceOptions.Ldem);
        }

        return renderer == RendererKind.Native ? map.Resolution : throw new UsageException(
            $"--ldem {path} is a polar map, which POV-Ray can't draw: its patterns are tiles of latitude and longitude. "
                + $"Add --renderer native, or take a model of the whole Moon.")
            .About(SurfaceOptions.Ldem, RendererOptions.Renderer);
    }
}
