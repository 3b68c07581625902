using System.Globalization;
using Msisf.App.Settings.Specs;
using Msisf.Core.Errors;

namespace Msisf.App.Settings;

/// <summary>The options of the commands that look at a folder of outputs.</summary>
internal static class FolderOptions
{
    /// <summary>Frames a second: more than any display shows.</summary>
    private const double MaxFrameRate = 1000.0;

    /// <summary>The folder.</summary>
    public static ArgumentSpec Folder { get; } = new("DIR", "The --output-dir of the runs");

    /// <summary>Steps instead of lines.</summary>
    public static FlagSpec PrintFrames { get; } = new(
        "--print-frames", "Print only the steps that have to be made again, as --frames takes them; an empty line if none")
    {
        IsOfOneCall = true,
    };

    /// <summary>One image of many small ones.</summary>
    public static FlagSpec ContactSheet { get; } = new(
        "--contact-sheet",
        string.Create(
            CultureInfo.InvariantCulture,
            $"When all images are there, make contact-sheet.png: small images of up to {Adapters.Metadata.ContactSheet.MaxImages} frames "
                + $"of the last run"));

    /// <summary>Frames a second of a video.</summary>
    public static NumberSpec Video { get; } = new(
        "--video", "FPS", "When all images are there, make video.mp4 of the last run with so many frames a second, by ffmpeg")
    {
        Limits = new NumberRange(0.0, MaxFrameRate) { ExcludesMin = true },
    };

    /// <summary>Reads what msis merge makes.</summary>
    /// <exception cref="BadInputException">A value is wrong.</exception>
    public static MergeSettings ReadMerge(OptionValues values) => new(ContactSheet.Read(values), Video.ReadIfGiven(values));
}
