namespace Msisf.Benchmarks.Thesis;

/// <summary>An image that a child process is to make in the thesis's own way.</summary>
/// <param name="Scene">Name of the scene.</param>
/// <param name="Label">Label of the elevation model.</param>
/// <param name="Patterns">Folder of the thesis's patterns.</param>
/// <param name="Output">Existing, empty folder for POV-Ray's scene and image.</param>
/// <param name="MaxTiles">Take no more tiles than these, for an image that would take minutes; its time is scaled.</param>
internal sealed record ThesisFrameJob(string Scene, string Label, string Patterns, string Output, int MaxTiles)
{
    /// <summary>The command word for which this program does such a job.</summary>
    public const string Command = "thesis-frame";

    /// <summary>Name of the count of all tiles of the image, beside that of the measured ones.</summary>
    public const string SelectedTiles = "tiles_selected";

    /// <summary>The image's file in the output folder.</summary>
    public const string ImageName = "image.png";
}
