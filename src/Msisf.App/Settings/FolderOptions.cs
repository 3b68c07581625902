using Msisf.App.Settings.Specs;

namespace Msisf.App.Settings;

/// <summary>The options of the commands that check a folder of outputs.</summary>
internal static class FolderOptions
{
    /// <summary>Maximum frame rate of a video, frames per second: faster than any display.</summary>
    private const double MaxFrameRate = 1000.0;

    public static ArgumentSpec Folder { get; } = new("DIR", "The --output-dir of the runs");

    public static ArgumentSpec Folders { get; } = Folder with
    {
        Help = "The --output-dir of the runs; with --to several",
        TakesSeveralWords = true,
    };

    public static PathSpec To { get; } = new(
        "--to", DecidesBytes.OfNoFrame, PathKind.Folder,
        "Copy the frames of all folders into this one, with their records: results of several machines");

    public static FlagSpec PrintFrames { get; } = new(
        "--print-frames", OptionRole.WhatIsPrinted,
        "Print only the steps that have to be made again, as --frames takes them; an empty line if none")
    {
        IsOfOneCall = true,
    };

    public static FlagSpec ContactSheet { get; } = new(
        "--contact-sheet", DecidesBytes.OfNoFrame,
        Invariant(
            $"When all images are there, make contact-sheet.png: small images of up to {Adapters.Metadata.ContactSheet.MaxImages} frames "
                + $"of the last run"));

    public static NumberSpec Video { get; } = new(
        "--video", DecidesBytes.OfNoFrame,
        "FPS", "When all images are there, make video.mp4 of the last run with so many frames a second, by ffmpeg")
    {
        Limits = new NumberRange(0.0, MaxFrameRate) { ExcludesMin = true },
    };

    /// <summary>Reads the folders whose frames are copied into one, and that one; of a single folder itself.</summary>
    /// <exception cref="UsageException">There is no folder, or there are several and none to copy to.</exception>
    public static (IReadOnlyList<string> Sources, string Target) ReadFolders(OptionValues values)
    {
        string? to = To.ReadIfGiven(values);
        return (values.Arguments, to) switch
        {
            ([], _) => throw new UsageException("msis merge needs the --output-dir of a run: msis merge DIR."),
            ([string only], null) => ([], only),
            (_, null) => throw new UsageException(
                $"several folders are joined in another one. Give that by {To.Name} DIR.").About(To),
            (_, { } target) => (values.Arguments, target),
        };
    }

    /// <summary>Reads the files that msis merge should make.</summary>
    public static MergeSettings ReadMerge(OptionValues values) => new(ContactSheet.Read(values), Video.ReadIfGiven(values));
}

/// <summary>The files to make when all images of a run are complete.</summary>
/// <param name="ContactSheet">Whether to make one image of many small images.</param>
/// <param name="FrameRate">Frame rate of a video, frames per second; null for no video.</param>
internal sealed record MergeSettings(bool ContactSheet, double? FrameRate);
