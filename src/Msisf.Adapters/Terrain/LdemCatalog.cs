using System.Globalization;
using Msisf.Core.Errors;

namespace Msisf.Adapters.Terrain;

/// <summary>Finds the elevation model of a resolution.</summary>
public static class LdemCatalog
{
    private static readonly EnumerationOptions Labels = new() { MatchCasing = MatchCasing.CaseInsensitive, IgnoreInaccessible = true };

    /// <summary>
    /// The label to use. With an explicit path: that label, the label of that image, or what that folder has; else the first
    /// of the folders that has one. In a folder LDEM_[res].LBL comes first, then any whole-Moon label of that resolution, by name.
    /// </summary>
    /// <param name="pixelsPerDegree">The resolution.</param>
    /// <param name="explicitPath">A label, an image, or a folder (--ldem); null to search the folders.</param>
    /// <param name="folders">Where to look otherwise, first choice first; they need not exist.</param>
    /// <exception cref="BadInputException">There is none (the message says where it looked), or the explicit one has another resolution.</exception>
    public static LdemLabel Find(int pixelsPerDegree, string? explicitPath, IReadOnlyList<string> folders)
    {
        if (explicitPath is not null && !Directory.Exists(explicitPath))
        {
            LdemLabel label = Read(explicitPath);
            return label.PixelsPerDegree == pixelsPerDegree ? label : throw new BadInputException(string.Create(
                CultureInfo.InvariantCulture,
                $"{label.LabelPath}: an elevation model of {label.PixelsPerDegree} px/deg, but {pixelsPerDegree} px/deg are asked for. Give --res {label.PixelsPerDegree}, or another model."));
        }

        IReadOnlyList<string> places = explicitPath is null ? folders : [explicitPath];
        foreach (string folder in places.Where(Directory.Exists))
        {
            if (FindIn(folder, pixelsPerDegree) is { } found)
            {
                return found;
            }
        }

        throw new BadInputException(string.Create(
            CultureInfo.InvariantCulture,
            $"No elevation model of {pixelsPerDegree} px/deg in {string.Join(", ", places)}: put LDEM_{pixelsPerDegree}.LBL and .IMG there, name them with --ldem, or make a synthetic one with 'msis ldem synthesize --res {pixelsPerDegree} --seed 1'."));
    }

    /// <summary>The label of a named model.</summary>
    /// <param name="labelOrImage">Path of the label, or of the image beside it.</param>
    /// <exception cref="BadInputException">It is missing, or no label of a cylindrical lunar model.</exception>
    public static LdemLabel Read(string labelOrImage) => LdemLabelReader.ReadFile(LabelOf(labelOrImage));

    private static LdemLabel? FindIn(string folder, int pixelsPerDegree)
    {
        string usual = Path.Combine(folder, string.Create(CultureInfo.InvariantCulture, $"LDEM_{pixelsPerDegree}.LBL"));
        if (FileNames.FindIgnoringCase(usual) is { } label)
        {
            LdemLabel found = LdemLabelReader.ReadFile(label);
            return found.PixelsPerDegree == pixelsPerDegree ? found : throw new BadInputException(string.Create(
                CultureInfo.InvariantCulture, $"{label}: by its name a model of {pixelsPerDegree} px/deg, but MAP_RESOLUTION is {found.PixelsPerDegree}. Rename it."));
        }

        return Directory.EnumerateFiles(folder, "*.LBL", Labels)
            .Order(StringComparer.Ordinal)
            .Select(TryRead)
            .FirstOrDefault(other => other is { CoversWholeMoon: true } && other.PixelsPerDegree == pixelsPerDegree);
    }

    /// <summary>A folder may hold labels of anything: one that is no cylindrical lunar model is no candidate.</summary>
    private static LdemLabel? TryRead(string labelPath)
    {
        try
        {
            return LdemLabelReader.ReadFile(labelPath);
        }
        catch (BadInputException)
        {
            return null;
        }
    }

    private static string LabelOf(string path)
    {
        if (!Path.GetExtension(path).Equals(".IMG", StringComparison.OrdinalIgnoreCase))
        {
            return path;
        }

        // An image without a label beside it can have its label attached.
        return FileNames.FindIgnoringCase(Path.ChangeExtension(path, ".LBL")) ?? path;
    }
}
