using Msisf.Adapters.Camera;
using Msisf.App.Settings;

namespace Msisf.Server;

/// <summary>GET /v1/models: the names that requests may use.</summary>
internal sealed class ModelsEndpoint(FrameService frames)
{
    public Task AnswerAsync(HttpContext context) => JsonBody.SendAsync(context.Response, new
    {
        Models = frames.Names.Models.All.Select(model => new
        {
            model.Name,
            model.Resolution.PixelsPerDegree,
            model.Resolution.MetresPerPixel,
            Synthetic = model.IsSynthetic,
            WholeMoon = model.IsWholeMoon,
            model.Path,
            Ldem = model.Ldem.SingleOrDefault(),
        }),
        OneSurface = frames.Names.Models.OneSurface.Select(model => model.Name),
        AlbedoMaps = frames.Names.Maps.Where(name => !IsHapke(name)),
        HapkeMaps = frames.Names.Maps.Where(IsHapke),
        Cameras = frames.Names.Cameras.Select(Described),
        Catalogues = frames.Settings.Catalogues.Keys.Select(name => new { Name = name }),
        Reflectances = NativeOptions.Reflectance.Words,
        Layers = NativeOptions.Layers.Words,
        frames.Settings.MaxPixels,
    });

    public static object Described(CameraFile camera) => new
    {
        camera.Name,
        camera.Model.Width,
        camera.Model.Height,
        FieldOfView = camera.FieldOfViewDegrees,
        camera.Description,
    };

    private static bool IsHapke(string name) => name.StartsWith("WAC_HAPKEPARAM", StringComparison.OrdinalIgnoreCase);
}
