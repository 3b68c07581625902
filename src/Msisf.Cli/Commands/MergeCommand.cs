using System.CommandLine;
using Msisf.Adapters.IO;
using Msisf.Adapters.Manifest;
using Msisf.Adapters.Metadata;
using Msisf.Adapters.Render;
using Msisf.App.Host;
using Msisf.App.Series;
using Msisf.Cli.Options;
using Msisf.Core.Errors;

namespace Msisf.Cli.Commands;

/// <summary><c>msis merge</c>: what is done once when all pieces of a run are done.</summary>
internal static class MergeCommand
{
    private const string SheetName = "contact-sheet.png";
    private const string VideoName = "video.mp4";

    /// <summary>More than any display shows.</summary>
    private const double MaxFrameRate = 1000.0;

    /// <summary>Declares the command and its options.</summary>
    public static Command Create(ProgramHost host)
    {
        Argument<string> folder = CheckCommand.FolderArgument();
        Option<bool> sheet = OptionFactory.Flag(
            "--contact-sheet", [], $"Make {SheetName}: small images of up to {ContactSheet.MaxImages} frames of the last run");
        Option<string?> video = OptionFactory.Value(
            "--video", [], "FPS", $"Make {VideoName} of the last run with so many frames a second, if ffmpeg is there");
        Command command = new(
            "merge", "Puts the manifest into the order that it has whoever made the frames; on request makes a contact sheet and a video.")
        {
            folder, sheet, video,
        };
        command.SetAction(async (line, cancellation) =>
        {
            StrayOptions.Refuse(line);
            double? rate = line.GetValue(video) is string text ? FrameRate(video, text) : null;
            string path = line.GetRequiredValue(folder);
            try
            {
                return await Task.Run(
                    () => MergeAsync(path, line.GetValue(sheet), rate, host, cancellation), cancellation).ConfigureAwait(false);
            }
            catch (Exception exception) when (exception.IsFileError())
            {
                throw new ExternalPartException($"{path}: can't be written: {exception.Message}", exception);
            }
        });
        return command;
    }

    private static async Task<int> MergeAsync(
        string folder, bool wantsSheet, double? frameRate, ProgramHost host, CancellationToken cancellation)
    {
        FrameSet.Content(folder, host.Log); // no folder of a run: nothing is made in it
        ManifestFile manifest = new(folder);
        WorkFolder.RemoveStale(folder);
        using WorkFolder work = WorkFolder.In(folder);
        ManifestContent content = manifest.Locked(() =>
        {
            ManifestContent all = FrameSet.Content(folder, host.Log);
            manifest.Replace(all.InOrder(), work.Path);
            return all;
        });
        host.Results.WriteLine(manifest.FilePath);
        FrameSet frames = FrameSet.Read(folder, CheckDepth.Lengths, structure: null, host.Log, cancellation);
        (int Step, string Path)[] images = [.. frames.RightSteps(content.LastRun)
            .Select(frame => (frame.Step, Path.GetFullPath(Path.Combine(folder, content.Frames[frame.Name].Files[0].Name))))];
        if (images.Length > 0 && (wantsSheet || frameRate is not null))
        {
            if (wantsSheet)
            {
                string path = Path.Combine(folder, SheetName);
                using AtomicFileSet files = new(work.Path);
                files.Write(path, stream => ContactSheet.Write(stream, images, cancellation));
                files.Commit();
                host.Results.WriteLine(path);
            }

            if (frameRate is double rate)
            {
                await MakeVideoAsync(
                    folder, [.. images.Select(image => image.Path)], rate, work.Path, host, cancellation).ConfigureAwait(false);
            }
        }

        int wrong = frames.Count - frames.CountOf(FrameState.Complete);
        if (wrong > 0)
        {
            host.Log.Warning($"{wrong} of {frames.Count} frames are not right; msis status {folder} names them.");
        }

        return wrong == 0 ? 0 : CheckCommand.ExitNotComplete;
    }

    private static async Task MakeVideoAsync(
        string folder, IReadOnlyList<string> images, double rate, string work, ProgramHost host, CancellationToken cancellation)
    {
        if (VideoEncoder.Find(host.Environment("PATH") ?? string.Empty) is not string program)
        {
            host.Log.Warning(
                "no ffmpeg on the PATH: no video is made. Install it (Debian, Ubuntu: apt-get install ffmpeg) and run msis merge again.");
            return;
        }

        string made = Path.Combine(work, VideoName);
        string path = Path.Combine(folder, VideoName);
        await VideoEncoder.EncodeAsync(program, images, rate, work, made, cancellation).ConfigureAwait(false);
        File.Move(made, path, overwrite: true);
        host.Results.WriteLine(path);
    }

    private static double FrameRate(Option option, string text) =>
        OptionText.Number(option, text) is > 0.0 and <= MaxFrameRate and double rate
            ? rate
            : throw new BadInputException($"{option.Name} is {text}; frames a second above 0 and up to {MaxFrameRate} are needed.");
}
