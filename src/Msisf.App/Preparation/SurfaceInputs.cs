using Msisf.Adapters.Catalogues;
using Msisf.Adapters.IO;
using Msisf.Adapters.Raster.Albedo;
using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Metadata;
using Msisf.Core.Navigation;
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

    public void Dispose()
    {
        Albedo?.Dispose();
        foreach (OpenedAlbedoMap site in Sites)
        {
            site.Dispose();
        }
    }
}

/// <summary>What the truth for navigation of a run is made from.</summary>
/// <param name="Craters">Finds the craters of a frame; null without a catalogue.</param>
/// <param name="Landmarks">Finds the landmarks of a frame; null without a list.</param>
/// <param name="Files">The files that were read.</param>
internal sealed record NavigationInputs(CraterFinder? Craters, LandmarkFinder? Landmarks, IReadOnlyList<InputFile> Files)
{
    /// <summary>Reads the files.</summary>
    /// <param name="settings">The settings; null for none.</param>
    /// <param name="referenceRadius">m: radius of the body.</param>
    /// <returns>Null if no such truth is wanted.</returns>
    /// <exception cref="MsisfException">A file can't be used.</exception>
    public static NavigationInputs? Open(NavigationSettings? settings, double referenceRadius)
    {
        if (settings is null)
        {
            return null;
        }

        CraterFinder? craters = settings.Craters is { } path
            ? NavigationOptions.Craters.NamedInErrors(() => new CraterFinder(
                new CraterCatalogue(CraterCatalogueReader.ReadAll(path, referenceRadius, settings.Columns)), settings.Rim,
                settings.LeastDiameter))
            : null;
        LandmarkFinder? landmarks = settings.Landmarks is { } list
            ? NavigationOptions.Landmarks.NamedInErrors(() => new LandmarkFinder(
                LandmarkReader.Read(list, referenceRadius, given: settings.Columns)))
            : null;
        return new NavigationInputs(
            craters,
            landmarks,
            [
                .. settings.Craters is { } catalogue ? [FileOf(InputKind.CraterCatalogue, catalogue)] : (InputFile[])[],
                .. settings.Landmarks is { } points ? [FileOf(InputKind.Landmarks, points)] : (InputFile[])[],
            ]);
    }

    private static InputFile FileOf(InputKind kind, string path) => FileErrors.ToBadInput(
        $"{path}: can't be read",
        () => new InputFile(kind, Path.GetFileName(path), new FileInfo(path).Length, FileHash.Sha256Of(path)));
}
