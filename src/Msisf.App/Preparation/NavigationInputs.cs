using Msisf.Adapters.Catalogues;
using Msisf.Adapters.IO;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Metadata;
using Msisf.Core.Navigation;

namespace Msisf.App.Preparation;

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
                new CraterCatalogue(CraterCatalogueReader.ReadAll(path, referenceRadius)), settings.Rim, settings.LeastDiameter))
            : null;
        LandmarkFinder? landmarks = settings.Landmarks is { } list
            ? NavigationOptions.Landmarks.NamedInErrors(() => new LandmarkFinder(LandmarkReader.Read(list, referenceRadius)))
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
