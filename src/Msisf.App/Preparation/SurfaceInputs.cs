using Msisf.Adapters.Raster.Albedo;
using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Metadata;
using Msisf.Core.Render;

namespace Msisf.App.Preparation;

/// <summary>The maps of the surface's reflectance that a run draws with.</summary>
/// <param name="Albedo">Map of the reflectance; null for none. Disposed with this object.</param>
/// <param name="Sites">Maps that count before it where they have data, the finest last. Disposed with this object.</param>
/// <param name="Hapke">Map of Hapke's parameters; null for none.</param>
internal sealed record SurfaceInputs(
    OpenedAlbedoMap? Albedo, IReadOnlyList<OpenedAlbedoMap> Sites, HapkeMapFile? Hapke, IReadOnlyList<InputFile> Files) : IDisposable
{
    /// <summary>The maps of the reflectance as one input; null for none.</summary>
    public InputFile? WholeAlbedo => Albedo is null ? null : OpenedAlbedoMap.WholeOf([Albedo, .. Sites]);

    /// <summary>Releases the maps' pages that were read.</summary>
    public void ReleasePages()
    {
        Albedo?.ReleasePages();
        foreach (OpenedAlbedoMap site in Sites)
        {
            site.ReleasePages();
        }
    }

    /// <summary>Opens the maps.</summary>
    /// <param name="host">Knows the folder of the installation, and receives log messages.</param>
    /// <exception cref="MsisfException">A map can't be used.</exception>
    public static SurfaceInputs Open(RenderSettings settings, ProgramHost host)
    {
        HapkeMapFile? hapke = settings is { Renderer: RendererKind.Native, Native.HapkeMap: { } path }
            ? NativeOptions.HapkeMap.NamedInErrors(() => HapkeMapFile.Read(path))
            : null;
        IReadOnlyList<OpenedAlbedoMap> maps = AlbedoSource.Open(settings, host);
        List<InputFile> files = [.. maps.SelectMany(map => map.Files)];
        if (hapke is not null)
        {
            files.Add(new InputFile(InputKind.HapkeMap, Path.GetFileName(settings.Native.HapkeMap!), hapke.FileBytes, hapke.Sha256));
        }

        return new SurfaceInputs(maps.Count > 0 ? maps[0] : null, [.. maps.Skip(1)], hapke, files);
    }

    /// <summary>Closes the maps of the reflectance.</summary>
    public void Dispose()
    {
        Albedo?.Dispose();
        foreach (OpenedAlbedoMap site in Sites)
        {
            site.Dispose();
        }
    }
}
