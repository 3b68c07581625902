using System.Text;
using Msisf.Adapters.Programs;

namespace Msisf.Adapters.Render;

/// <summary>Makes a video of a series of images, by ffmpeg.</summary>
public static class VideoEncoder
{
    /// <summary>Where ffmpeg is.</summary>
    /// <param name="searchPath">Folders in the form of the PATH variable.</param>
    /// <returns>Null if it is not there.</returns>
    public static string? Find(string searchPath) => SearchPath.Find(searchPath, OperatingSystem.IsWindows() ? "ffmpeg.exe" : "ffmpeg");

    /// <summary>Encodes the images as H.264 in 4:2:0, which every player shows. An odd last row or column is doubled.</summary>
    /// <param name="images">Absolute paths, in their order; at least one.</param>
    /// <param name="workFolder">Existing folder for what is made on the way.</param>
    /// <param name="destination">The video's file, in an existing folder; ends in .mp4.</param>
    /// <param name="cancellation">Ends ffmpeg.</param>
    /// <exception cref="ExternalPartException">ffmpeg can't be started or fails.</exception>
    public static async Task EncodeAsync(
        string program, IReadOnlyList<string> images, double framesPerSecond, string workFolder, string destination,
        CancellationToken cancellation)
    {
        string list = Path.Combine(workFolder, "images.txt");
        string rate = framesPerSecond.ToString("R", CultureInfo.InvariantCulture);
        string seconds = (1.0 / framesPerSecond).ToString("R", CultureInfo.InvariantCulture);
        IEnumerable<string> lines = images.SelectMany(
            image => (string[])[$"file '{image.Replace("'", "'\\''", StringComparison.Ordinal)}'", $"duration {seconds}"]);
        await File.WriteAllLinesAsync(
            list, lines, new UTF8Encoding(encoderShouldEmitUTF8Identifier: false), cancellation).ConfigureAwait(false);
        string[] arguments =
        [
            "-nostdin", "-loglevel", "error", "-y", "-f", "concat", "-safe", "0", "-i", list, "-r", rate,
            "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2,format=yuv420p", "-c:v", "libx264", "-fflags", "+bitexact", "-flags:v", "+bitexact",
            destination,
        ];
        ProcessResult result = await new ChildProgram(program, arguments).RunAsync(cancellation).ConfigureAwait(false);
        if (result.ExitCode != 0)
        {
            throw new ExternalPartException(Invariant(
                $"{program} failed with exit code {result.ExitCode}: {result.Error.Trim().ReplaceLineEndings(" ")}"));
        }
    }
}
