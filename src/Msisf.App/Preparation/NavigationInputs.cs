using Msisf.Adapters.Catalogues;
using Msisf.Adapters.IO;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Errors;
using Msisf.Core.Metadata;
using Msisf.Core.Navigation;

namespace Msisf.App.Preparation;

/// <summary>What the truth for navigation of a run is made from.</summary>
/// <param name="Craters">Finds the craters of a frame; null without a catalogue.</param>
/// <param name="Files">The files that were read.</param>
internal sealed record NavigationInputs(CraterFinder? Craters, IReadOnlyList<InputFile> Files)
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
                new CraterCatalogue(CraterCatalogueReader.ReadAll(path, referenceRadius)), settings.Rim, settings.LeastDiameter))
            : null;
        return new NavigationInputs(craters, craters is null ? [] : [FileOf(settings.Craters!)]);
    }

    private static InputFile FileOf(string path) => FileErrors.ToBadInput(
        $"{path}: can't be read",
        () => new InputFile(
            InputKind.CraterCatalogue, Path.GetFileName(path), new FileInfo(path).Length, FileHash.Sha256Of(path)));
}
