using Msisf.Adapters.Manifest;

namespace Msisf.App.DataSets;

/// <summary>An image of a data set that is there.</summary>
/// <param name="Number">From 1.</param>
/// <param name="Files">Its files, the image first.</param>
internal sealed record DataSetImage(int Number, DrawnState Drawn, IReadOnlyList<OutputFile> Files)
{
    public string FileName => Files[0].Name;

    /// <summary>The path of one of its files by its ending; null if there is none.</summary>
    /// <param name="ending">E.g. ".craters.csv".</param>
    public string? PathOf(string folder, string ending) =>
        Files.FirstOrDefault(file => file.Name == Path.GetFileNameWithoutExtension(FileName) + ending) is { } found
            ? Path.Combine(folder, found.Name)
            : null;
}
