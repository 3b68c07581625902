using Msisf.Adapters.Raster.Albedo;
using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Errors;
using Msisf.Core.Metadata;
using Msisf.Core.Render;

namespace Msisf.App.Preparation;

/// <summary>The maps of the surface's reflectance that a run draws with.</summary>
/// <param name="Albedo">Map of the reflectance; null for none. Disposed with this object.</param>
/// <param name="Hapke">Map of Hapke's parameters; null for none.</param>
/// <param name="Files">The files of both.</param>
internal sealed record SurfaceInputs(OpenedAlbedoMap? Albedo, HapkeMapFile? Hapke, IReadOnlyList<InputFile> Files) : IDisposable
{
    /// <summary>Opens the maps.</summary>
    /// <param name="settings">The run's settings.</param>
    /// <param name="host">Knows the folder of the installation, and receives log messages.</param>
    /// <exception cref="MsisfException">A map can't be used.</exception>
    public static SurfaceInputs Open(RenderSettings settings, ProgramHost host)
    {
        HapkeMapFile? hapke = settings is { Renderer: RendererKind.Native, Native.HapkeMap: { } path }
            ? NativeOptions.HapkeMap.NamedInErrors(() => HapkeMapFile.Read(path))
            : null;
        OpenedAlbedoMap? albedo = AlbedoSource.Open(settings, host);
        List<InputFile> files = [.. albedo?.Files ?? []];
        if (hapke is not null)
        {
            files.Add(new InputFile(InputKind.HapkeMap, Path.GetFileName(settings.Native.HapkeMap!), hapke.FileBytes, hapke.Sha256));
        }

        return new SurfaceInputs(albedo, hapke, files);
    }

    /// <summary>Closes the map of the reflectance.</summary>
    public void Dispose() => Albedo?.Dispose();
}
