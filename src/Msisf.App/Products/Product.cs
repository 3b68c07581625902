using Msisf.Adapters.IO;
using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;

namespace Msisf.App.Products;

/// <summary>Something that can be written of an image: a row of <see cref="ProductTable"/>.</summary>
/// <param name="Name">Its name, one word.</param>
/// <param name="Files">The files that it may have.</param>
/// <param name="IsWanted">Whether settings ask for it.</param>
/// <param name="Write">Writes the files of a frame; none where the frame has nothing for them.</param>
internal sealed record Product(
    string Name, IReadOnlyList<ProductFile> Files, Func<RenderSettings, bool> IsWanted, Action<ProductFrame, PutFile> Write)
{
    /// <summary>The part of a run in which its time counts.</summary>
    public Phase Phase { get; init; } = Phase.Output;

    /// <summary>Bytes of a frame's files.</summary>
    public Func<RenderSettings, double> DiskBytes { get; init; } = _ => 0.0;

    /// <summary>Bytes for each pixel in memory while it is written.</summary>
    public long MemoryBytesPerPixel { get; init; }

    /// <summary>
    /// What asks for it, in words, if that needs the whole image at once, so that an image which is drawn in strips can't have it; null if
    /// it does not.
    /// </summary>
    public Func<RenderSettings, string?> NeedsWhole { get; init; } = _ => null;

    /// <summary>Checks for the library that it needs (GDAL may be that of a path), before any work is done.</summary>
    public Action<RenderSettings, string?> Require { get; init; } = (_, _) => { };

    /// <summary>Its place among the parts of a server's answer; null where the server does not answer it.</summary>
    public int? PlaceInAnswer { get; init; }

    /// <summary>Whether an answer can be this product alone.</summary>
    public bool CanBeAnswer { get; init; }

    /// <summary>Content type of its files in answers; null where their names tell it.</summary>
    public string? ContentType { get; init; }

    /// <summary>Whether its files may be made later of a frame that is there, so that no record names them.</summary>
    public bool IsMadeLater { get; init; }
}

/// <summary>Files of a product.</summary>
/// <param name="Endings">All that follow the frame's name.</param>
/// <param name="Options">The options that ask for them; empty for files of each frame.</param>
/// <param name="Content">What they hold, for the table in docs/formats.md.</param>
internal sealed record ProductFile(IReadOnlyList<string> Endings, IReadOnlyList<OptionSpec> Options, string Content)
{
    /// <summary>The endings as the documentation shows them; null for all of them.</summary>
    public string? Shown { get; init; }
}
