using Msisf.Core.Ephemeris;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>
/// The labels of one elevation model: those of the parts of a model of the whole Moon or of a band around it, or one label, which may be of
/// a part or of a polar map. Immutable.
/// </summary>
public sealed class LdemSet
{
    private LdemSet(LdemLabel[] parts, string productId, ushort[] partOfDegree) =>
        (Parts, ProductId, PartOfDegree) = (parts, productId, partOfDegree);

    /// <summary>The labels, from the north, then from the west.</summary>
    public IReadOnlyList<LdemLabel> Parts { get; }

    /// <summary>Whether it covers the whole Moon; if not it is a polar map, a band between two latitudes, or a part.</summary>
    public bool IsWholeMoon => Parts[0].Polar is null && !PartOfDegree.Contains(LdemSetChecks.Nothing);

    /// <summary>PRODUCT_ID; of a split product without the part's borders, e.g. "LDEM_512".</summary>
    public string ProductId { get; }

    /// <summary>Samples a degree; 0 for a polar map.</summary>
    public int PixelsPerDegree => Parts[0].PixelsPerDegree;

    /// <summary>The body of all parts.</summary>
    public CelestialBody Body => Parts[0].Body;

    /// <summary>m: radius of the sphere over which heights are counted.</summary>
    public double ReferenceRadius => Parts[0].ReferenceRadius;

    /// <summary>Whether this is a synthetic product (docs/elevation-models.md).</summary>
    public bool IsSynthetic => Parts.Any(part => part.IsSynthetic);

    /// <summary>The label's path; of a split product the folder of the first label.</summary>
    public string Location => Parts.Count == 1 ? Parts[0].LabelPath : FolderOf(Parts[0]);

    /// <summary>Where the model is, and of how many files, for messages.</summary>
    public string Description => Parts.Count == 1 ? Location : $"{Location}, {Parts.Count} files";

    /// <summary>
    /// Index of the part that holds each square degree: [90 - northern latitude, western longitude], row by row; empty for a polar map.
    /// </summary>
    internal ushort[] PartOfDegree { get; }

    /// <summary>Takes the labels of one model.</summary>
    /// <param name="labels">At least one, in any order.</param>
    /// <param name="mayBePart">Whether the model may be one part of a split product, or end at two parallels instead of the poles.</param>
    /// <exception cref="BadInputException">
    /// They differ in what must be the same, overlap, or leave a part of the Moon uncovered; the message names the files.
    /// </exception>
    public static LdemSet Join(IReadOnlyList<LdemLabel> labels, bool mayBePart = false)
    {
        LdemLabel[] parts = [.. labels
            .OrderByDescending(label => label.NorthDegrees)
            .ThenBy(label => label.WestDegrees)
            .ThenBy(label => label.LabelPath, StringComparer.Ordinal)];
        LdemSetChecks.CheckAlike(parts);
        ushort[] partOfDegree = LdemSetChecks.Cover(parts, mayBePart);
        return new LdemSet(parts, parts.Length == 1 ? parts[0].ProductId : LdemPartName.Of(parts[0]).Model, partOfDegree);
    }

    /// <summary>Takes the label of a polar map.</summary>
    public static LdemSet OfMap(LdemLabel label) => new([label], label.ProductId, []);

    /// <summary>Path of a file beside the images that is derived from the model, e.g. "LDEM_64.pyramid".</summary>
    /// <param name="extension">With its dot.</param>
    public string FileBeside(string extension) => Parts.Count == 1
        ? Path.ChangeExtension(Parts[0].ImagePath, extension)
        : Path.Combine(FolderOf(Parts[0]), ProductId + extension);

    /// <summary>The places for such a file.</summary>
    /// <param name="extension">With its dot.</param>
    /// <param name="cacheFolder">The user's cache folder of this program, which need not exist; null if there is none.</param>
    internal SidecarPlaces PlacesOf(string extension, string? cacheFolder) =>
        SidecarPlaces.Of(FileBeside(extension), ProductId, extension, cacheFolder);

    private static string FolderOf(LdemLabel label) => FileNames.FolderOf(label.ImagePath);
}
