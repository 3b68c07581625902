using Msisf.Adapters.Camera;
using Msisf.App.Settings;

namespace Msisf.Server;

/// <summary>GET /v1/models: the names that requests may use.</summary>
internal sealed class ModelsEndpoint(FrameService frames)
{
    public Task AnswerAsync(HttpContext context) => JsonBody.SendAsync(context.Response, new ModelsAnswer(
        frames.Names.Models.All.Select(model => new ModelAnswer(
            model.Name,
            model.Resolution.PixelsPerDegree,
            model.Resolution.MetresPerPixel,
            model.IsSynthetic,
            model.IsWholeMoon,
            model.Path,
            model.Ldem.SingleOrDefault())),
        frames.Names.Models.OneSurface.Select(model => model.Name),
        frames.Names.Maps.Where(name => !IsHapke(name)),
        frames.Names.Maps.Where(IsHapke),
        frames.Names.Cameras.Select(Described),
        frames.Settings.Catalogues.Keys.Select(name => new CatalogueAnswer(name)),
        NativeOptions.Reflectance.Words,
        NativeOptions.Layers.Words,
        frames.Settings.MaxPixels));

    public static CameraAnswer Described(CameraFile camera) => new(
        camera.Name, camera.Model.Width, camera.Model.Height, camera.FieldOfViewDegrees, camera.Description);

    private static bool IsHapke(string name) => name.StartsWith("WAC_HAPKEPARAM", StringComparison.OrdinalIgnoreCase);
}

/// <summary>The names that requests may use.</summary>
/// <param name="OneSurface">The models that are drawn as one surface.</param>
/// <param name="MaxPixels">Pixels of the largest image.</param>
internal sealed record ModelsAnswer(
    IEnumerable<ModelAnswer> Models, IEnumerable<string> OneSurface, IEnumerable<string> AlbedoMaps, IEnumerable<string> HapkeMaps,
    IEnumerable<CameraAnswer> Cameras, IEnumerable<CatalogueAnswer> Catalogues, IEnumerable<string> Reflectances,
    IEnumerable<string> Layers, int MaxPixels);

/// <summary>An elevation model.</summary>
/// <param name="PixelsPerDegree">Null of models that are not in degrees.</param>
/// <param name="Ldem">Its name for --ldem; null of one that --res finds.</param>
internal sealed record ModelAnswer(
    string Name, int? PixelsPerDegree, double MetresPerPixel, bool Synthetic, bool WholeMoon, string Path, string? Ldem);

/// <summary>A camera.</summary>
/// <param name="Width">Pixels, as the height.</param>
/// <param name="FieldOfView">Degrees, horizontal.</param>
internal sealed record CameraAnswer(string Name, int Width, int Height, double FieldOfView, string? Description);

/// <summary>A catalogue of craters.</summary>
internal sealed record CatalogueAnswer(string Name);
