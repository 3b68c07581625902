using Msisf.Adapters.Fetching;
using Msisf.Core.Ephemeris;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>Finds the elevation model of a resolution.</summary>
public static class LdemCatalog
{
    private static readonly EnumerationOptions Labels = new() { MatchCasing = MatchCasing.CaseInsensitive, IgnoreInaccessible = true };

    /// <summary>
    /// Finds a model. An explicit path is a label, an image or a folder; otherwise the first folder that has a model counts. In a folder
    /// LDEM_[res].LBL comes first, then any whole-Moon label of that resolution, by name, then the first complete set of a split product.
    /// </summary>
    /// <param name="explicitPath">A label, an image, or a folder (--ldem); null to search the folders.</param>
    /// <param name="folders">Where to look otherwise, first choice first; they need not exist.</param>
    /// <param name="wayToName">How another model is named, for the message.</param>
    /// <param name="body">The body of which it must be; null for the Moon.</param>
    /// <exception cref="BadInputException">
    /// There is none (the message says where it looked), its parts don't make up a whole Moon, or the explicit one has another resolution
    /// or is of another body.
    /// </exception>
    public static LdemSet Find(
        int pixelsPerDegree, string? explicitPath, IReadOnlyList<string> folders, string wayToName = "name another one with --ldem",
        CelestialBody? body = null) =>
        TryFind(pixelsPerDegree, explicitPath, folders, body) ?? throw new BadInputException(
            $"No elevation model of {pixelsPerDegree} px/deg in {string.Join(", ", PlacesOf(explicitPath, folders))}. "
                + $"{WaysToGet(pixelsPerDegree, wayToName)}");

    /// <summary>Finds a model as <see cref="Find"/> does; null if there is none of that resolution.</summary>
    /// <inheritdoc cref="Find"/>
    public static LdemSet? TryFind(
        int pixelsPerDegree, string? explicitPath, IReadOnlyList<string> folders, CelestialBody? body = null)
    {
        if (explicitPath is not null && !Directory.Exists(explicitPath))
        {
            LdemLabel label = ReadCylindrical(explicitPath, body ?? CelestialBody.Moon);
            return label.PixelsPerDegree == pixelsPerDegree ? WithSiblings(label) : throw new BadInputException(
                $"{label.LabelPath}: an elevation model of {label.PixelsPerDegree} px/deg, but {pixelsPerDegree} px/deg are asked for. "
                    + $"Give --res {label.PixelsPerDegree}, or another model.");
        }

        BadInputException? incomplete = null;
        foreach (string folder in PlacesOf(explicitPath, folders).Where(Directory.Exists))
        {
            if (FindIn(folder, pixelsPerDegree, body ?? CelestialBody.Moon, ref incomplete) is { } found)
            {
                return found;
            }
        }

        return incomplete is null ? null : throw incomplete;
    }

    /// <summary>The models that <see cref="Find"/> finds in folders, one for each resolution, coarse ones first.</summary>
    /// <param name="explicitPath">A label, an image, or a folder (--ldem); null to search the folders.</param>
    /// <param name="folders">Where to look otherwise, first choice first; they need not exist.</param>
    public static IReadOnlyList<LdemSet> All(string? explicitPath, IReadOnlyList<string> folders) =>
        explicitPath is not null && !Directory.Exists(explicitPath)
            ? [Read(explicitPath)]
            :
            [
                .. PlacesOf(explicitPath, folders).Where(Directory.Exists)
                    .SelectMany(folder => LabelsIn(folder, ".LBL", CelestialBody.Moon))
                    .Select(label => label.PixelsPerDegree)
                    .Distinct()
                    .Order()
                    .Select(pixelsPerDegree => FindWhole(pixelsPerDegree, explicitPath, folders))
                    .OfType<LdemSet>(),
            ];

    /// <summary>A named model.</summary>
    /// <param name="labelOrImage">
    /// Path of the label, or of the image beside it; of a split product that of any part: the others count if all lie beside it.
    /// </param>
    /// <exception cref="BadInputException">
    /// It is missing, no label of a cylindrical lunar model, or its parts don't make up a whole Moon.
    /// </exception>
    public static LdemSet Read(string labelOrImage) => WithSiblings(ReadCylindrical(labelOrImage, CelestialBody.Moon));

    /// <summary>Resolution of a named model of any body, px/deg.</summary>
    /// <param name="labelOrImage">Path of a label, or of the image beside it.</param>
    /// <exception cref="BadInputException">It is missing, or no label of a cylindrical model.</exception>
    public static int ResolutionOf(string labelOrImage) => ReadCylindrical(labelOrImage, body: null).PixelsPerDegree;

    /// <summary>
    /// Resolution of the models of a folder, px/deg: the usual one if it has such a model, or none at all; otherwise that of its only ones.
    /// </summary>
    /// <param name="folder">The folder, which exists.</param>
    /// <param name="usual">px/deg: the resolution that counts among several.</param>
    /// <param name="body">The body of which they must be.</param>
    /// <exception cref="BadInputException">There are several others.</exception>
    public static int ResolutionIn(string folder, int usual, CelestialBody body)
    {
        int[] found = [.. LabelsIn(folder, ".LBL", body).Select(label => label.PixelsPerDegree).Distinct().Order()];
        return found.Length == 0 || found.Contains(usual) ? usual
            : found is [int only] ? only
            : throw new BadInputException(
                $"{folder}: it has elevation models of {string.Join(", ", found)} px/deg. Add --res with one of these numbers, or name a "
                    + "label.");
    }

    /// <summary>A named model of any body.</summary>
    /// <inheritdoc cref="Read"/>
    public static LdemSet ReadOfAnyBody(string labelOrImage) => WithSiblings(ReadCylindrical(labelOrImage, body: null));

    /// <summary>The label of a named polar map; null if the path is a folder, or another model's or file's.</summary>
    /// <param name="path">A label, an image, or anything else.</param>
    public static LdemLabel? TryReadMap(string path) =>
        File.Exists(path) && TryRead(FileNames.LabelOf(path)) is { Polar: not null } label ? label : null;

    private static LdemLabel ReadCylindrical(string labelOrImage, CelestialBody? body)
    {
        LdemLabel label = LdemLabelReader.ReadFile(FileNames.LabelOf(labelOrImage));
        if (body is not null && label.Body != body)
        {
            throw new BadInputException(
                $"{label.LabelPath}: a model of {label.Body.NameInText}, but one of {body.NameInText} is needed here. --body says of which "
                    + $"body an image is.");
        }

        return label.Polar is null ? label : throw new BadInputException(
            $"{label.LabelPath}: a map of the surroundings of a pole; a SIMPLE CYLINDRICAL model of the whole Moon is needed here.");
    }

    /// <summary>Null if its parts don't make up a whole Moon.</summary>
    private static LdemSet? FindWhole(int pixelsPerDegree, string? explicitPath, IReadOnlyList<string> folders) =>
        NullIfBad(() => TryFind(pixelsPerDegree, explicitPath, folders));

    private static IReadOnlyList<string> PlacesOf(string? explicitPath, IReadOnlyList<string> folders) =>
        explicitPath is null ? folders : [explicitPath];

    private static string WaysToGet(int pixelsPerDegree, string wayToName)
    {
        string real = LdemProducts.Resolutions.Contains(pixelsPerDegree)
            ? $"Get NASA's with 'msis fetch ldem --res {pixelsPerDegree}'"
            : $"NASA has models of {string.Join(", ", LdemProducts.Resolutions)} px/deg";
        string continued = pixelsPerDegree > LdemProducts.Resolutions[0] ? $" --base LDEM_{LdemProducts.Resolutions[0]}.LBL" : string.Empty;
        return $"{real}, {wayToName}, or make a synthetic one with 'msis ldem synthesize --res {pixelsPerDegree}{continued} --seed 1'.";
    }

    private static LdemSet? FindIn(
        string folder, int pixelsPerDegree, CelestialBody body, ref BadInputException? incomplete)
    {
        string usual = Path.Combine(folder, $"LDEM_{pixelsPerDegree}.LBL");
        if (FileNames.FindIgnoringCase(usual) is { } label)
        {
            LdemLabel found = ReadCylindrical(label, body);
            return found.PixelsPerDegree == pixelsPerDegree ? WithSiblings(found) : throw new BadInputException(
                $"{label}: by its name a model of {pixelsPerDegree} px/deg, but MAP_RESOLUTION is {found.PixelsPerDegree}. Rename it.");
        }

        LdemLabel[] others = [.. LabelsIn(folder, ".LBL", body).Where(other => other.PixelsPerDegree == pixelsPerDegree)];
        if (others.FirstOrDefault(other => other.CoversWholeMoon) is { } whole)
        {
            return LdemSet.Join([whole]);
        }

        foreach (IGrouping<string, LdemLabel> parts in others.GroupBy(ModelOf).OrderBy(parts => parts.Key, StringComparer.Ordinal))
        {
            try
            {
                return LdemSet.Join([.. parts]);
            }
            catch (BadInputException exception)
            {
                incomplete ??= exception; // another set, or another folder, may have a whole model
            }
        }

        return null;
    }

    /// <summary>
    /// The model that a label belongs to: with the parts beside it, if these make up the whole Moon or a band around it, otherwise itself.
    /// </summary>
    private static LdemSet WithSiblings(LdemLabel label)
    {
        if (label.CoversWholeMoon)
        {
            return LdemSet.Join([label]);
        }

        string folder = FileNames.FolderOf(label.LabelPath);
        IEnumerable<LdemLabel> siblings = LabelsIn(folder, Path.GetExtension(label.LabelPath), label.Body).Where(other =>
            other.PixelsPerDegree == label.PixelsPerDegree
            && !other.CoversWholeMoon
            && ModelOf(other) == ModelOf(label)
            && Path.GetFileName(other.LabelPath) != Path.GetFileName(label.LabelPath));
        LdemLabel[] all = [label, .. siblings];
        return LdemSet.Join(LdemSetChecks.AreComplete(all) ? all : [label], mayBePart: true);
    }

    /// <summary>The name that the parts of one model share. Parts whose names have no borders count as parts of one model.</summary>
    private static string ModelOf(LdemLabel label) =>
        LdemPartName.Of(label) is { HasBorders: true } name ? name.Model.ToUpperInvariant() : string.Empty;

    /// <summary>The labels of a body's cylindrical models in a folder, which may hold other labels too.</summary>
    private static IEnumerable<LdemLabel> LabelsIn(string folder, string extension, CelestialBody body) =>
        Directory.EnumerateFiles(folder, "*" + extension, Labels)
            .Order(StringComparer.Ordinal)
            .Select(TryRead)
            .OfType<LdemLabel>()
            .Where(label => label.Polar is null && label.Body == body);

    private static LdemLabel? TryRead(string labelPath) => NullIfBad(() => LdemLabelReader.ReadFile(labelPath));

    private static T? NullIfBad<T>(Func<T?> read)
        where T : class
    {
        try
        {
            return read();
        }
        catch (BadInputException)
        {
            return null;
        }
    }
}
