using Msisf.App.Settings.Specs;

namespace Msisf.App.Settings;

/// <summary>The options of the commands that check a folder of outputs.</summary>
internal static class FolderOptions
{
    /// <summary>Maximum frame rate of a video, frames per second: faster than any display.</summary>
    private const double MaxFrameRate = 1000.0;

    public static ArgumentSpec Folder { get; } = new("DIR", "The --output-dir of the runs");

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

    /// <summary>Reads the files that msis merge should make.</summary>
    public static MergeSettings ReadMerge(OptionValues values) => new(ContactSheet.Read(values), Video.ReadIfGiven(values));
}

/// <summary>The files to make when all images of a run are complete.</summary>
/// <param name="ContactSheet">Whether to make one image of many small images.</param>
/// <param name="FrameRate">Frame rate of a video, frames per second; null for no video.</param>
internal sealed record MergeSettings(bool ContactSheet, double? FrameRate);
