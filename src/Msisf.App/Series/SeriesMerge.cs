using Msisf.Adapters.IO;
using Msisf.Adapters.Manifest;
using Msisf.Adapters.Metadata;
using Msisf.Adapters.Render;
using Msisf.App.Host;
using Msisf.App.Settings;

namespace Msisf.App.Series;

/// <summary>The final work when all pieces of a run are done.</summary>
internal static class SeriesMerge
{
    public const string SheetName = "contact-sheet.png";

    public const string VideoName = "video.mp4";

    /// <summary>
    /// Sorts the manifest and, if requested, makes a contact sheet and a video of the last run; their paths are written to the host's
    /// results.
    /// </summary>
    /// <param name="folder">Folder of the outputs.</param>
    /// <param name="cancellation">Cancels the work; no incomplete file is left.</param>
    /// <returns>The state of the frames.</returns>
    /// <exception cref="MsisfException">
    /// The folder contains no run, or can't be written; an image is damaged, or there is no ffmpeg for the video.
    /// </exception>
    public static async Task<SeriesStatus> RunAsync(string folder, MergeSettings settings, ProgramHost host, CancellationToken cancellation)
    {
        ManifestFile manifest = SeriesManifest.Find(folder);
        try
        {
            WorkFolder.RemoveStale(folder);
            using WorkFolder work = WorkFolder.In(folder);
            ManifestContent content = manifest.Locked(() =>
            {
                ManifestContent all = SeriesManifest.Read(manifest, host.Log);
                manifest.Replace(all.InOrder(), work.Path);
                return all;
            });
            host.Results.WriteLine(manifest.FilePath);
            SeriesStatus status = SeriesStatus.Of(folder, content, new FrameChecker(folder, CheckDepth.Lengths), cancellation);
            (int Step, string Path)[] images = [.. status.Frames
                .Where(frame => frame.State == FrameState.Complete && frame.Expected.Run == content.LastRun)
                .Select(
                    frame =>
                        (frame.Expected.Step, Path.GetFullPath(Path.Combine(folder, content.Frames[frame.Expected.Name].Files[0].Name))))];
            if (settings.ContactSheet && images.Length > 0)
            {
                MakeSheet(folder, images, work.Path, host, cancellation);
            }

            if (settings.FrameRate is { } rate && images.Length > 0)
            {
                string program = VideoEncoder.Find(host.Environment("PATH") ?? string.Empty) ?? throw new ExternalPartException(
                    "no ffmpeg on the PATH: no video is made. Install it (Debian, Ubuntu: apt-get install ffmpeg) and run msis merge "
                        + "again.");
                await MakeVideoAsync(
                    program, folder, [.. images.Select(image => image.Path)], rate, work.Path, host, cancellation).ConfigureAwait(false);
            }

            return status;
        }
        catch (Exception exception) when (exception.IsFileError())
        {
            throw new ExternalPartException($"{folder}: can't be written: {exception.Message}", exception);
        }
    }

    private static void MakeSheet(
        string folder, (int Step, string Path)[] images, string work, ProgramHost host, CancellationToken cancellation)
    {
        string path = Path.Combine(folder, SheetName);
        using AtomicFileSet files = new(work);
        files.Write(path, stream => ContactSheet.Write(stream, images, cancellation));
        files.Commit();
        host.Results.WriteLine(path);
    }

    private static async Task MakeVideoAsync(
        string program, string folder, IReadOnlyList<string> images, double rate, string work, ProgramHost host,
        CancellationToken cancellation)
    {
        foreach (string image in images)
        {
            cancellation.ThrowIfCancellationRequested();
            PngFile.CheckFile(image); // ffmpeg would leave it out, or show a part of it
        }

        string made = Path.Combine(work, VideoName);
        string path = Path.Combine(folder, VideoName);
        await VideoEncoder.EncodeAsync(program, images, rate, work, made, cancellation).ConfigureAwait(false);
        File.Move(made, path, overwrite: true);
        host.Results.WriteLine(path);
    }
}
