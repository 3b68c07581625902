using System.ComponentModel;
using System.Diagnostics;
using System.Globalization;
using System.Text;
using Msisf.Adapters.IO;
using Msisf.Core.Camera;
using Msisf.Core.Errors;

namespace Msisf.Adapters.Render;

/// <summary>
/// Runs POV-Ray, the one place that starts it. Each run has a folder of its own with plain names inside, so that no path
/// of the user's (spaces, quotes, umlauts) ever passes through POV-Ray's option parser; nothing passes through a shell.
/// </summary>
public sealed class PovRayProcess
{
    /// <summary>
    /// Rows that POV-Ray 3.7 takes together: what its antialiasing does at a block's edge depends on where the blocks are, so a strip that begins at a
    /// multiple of this has the pixels of the whole image (measured; strips that do not differ in a few).
    /// </summary>
    public const int BlockRows = 32;

    private const string SceneName = "scene.pov";
    private const string ImageName = "image.png";
    private const string PatternLink = "patterns";
    private const string EmptySettings = "povray.ini";

    /// <summary>The last lines of a failed run that its error shows.</summary>
    private const int ReportedLines = 6;

    /// <summary>Quality and antialiasing as the 2012 program had them.</summary>
    private static readonly string[] DefaultOptions =
    [
        "Quality=11", "Antialias=On", "Antialias_Depth=3", "Antialias_Threshold=0.3", "Jitter=On", "Jitter_Amount=0.5",
    ];

    private readonly string _program;

    /// <summary>Takes the program to start.</summary>
    /// <param name="program">Full path (<see cref="PovRayProgram.Find"/>).</param>
    public PovRayProcess(string program) => _program = program;

    /// <summary>Renders one image.</summary>
    /// <param name="job">What and where.</param>
    /// <param name="cancellation">Kills POV-Ray with its children.</param>
    /// <exception cref="PovRayException">POV-Ray can't be started, fails, or exceeds the job's time limit.</exception>
    /// <exception cref="BadInputException">What POV-Ray left is no whole image.</exception>
    /// <exception cref="OperationCanceledException">Cancelled.</exception>
    public async Task<PovRayImage> RenderAsync(PovRayJob job, CancellationToken cancellation)
    {
        try
        {
            using WorkFolder work = WorkFolder.In(job.WorkFolder);
            string folder = work.Path;
            Directory.CreateSymbolicLink(Path.Combine(folder, PatternLink), Path.GetFullPath(job.PatternFolder));
            File.WriteAllText(Path.Combine(folder, EmptySettings), string.Empty);
            using (StreamWriter writer = new(Path.Combine(folder, SceneName), append: false, new UTF8Encoding(false)))
            {
                job.Scene(writer);
            }

            string output = await RunAsync(job, folder, cancellation).ConfigureAwait(false);
            using FileStream image = File.OpenRead(Path.Combine(folder, ImageName));
            return new PovRayImage(PngRaster.Read(image, "POV-Ray's image"), PovRayTimes.Read(output));
        }
        catch (Exception exception) when (exception is IOException or UnauthorizedAccessException)
        {
            throw new PovRayException($"{job.WorkFolder}: POV-Ray's files can't be kept there: {exception.Message}", exception);
        }
    }

    private static ProcessStartInfo StartInfo(string program, PovRayJob job, string folder)
    {
        ProcessStartInfo start = new(program)
        {
            WorkingDirectory = folder,
            RedirectStandardInput = true,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
            UseShellExecute = false,
        };

        // An empty settings file: a user's own povray.ini must not change images.
        start.Environment["POVINI"] = EmptySettings;
        string[] own =
        [
            $"+I{SceneName}", $"+O{ImageName}", $"+L{PatternLink}", "+FN8", "-D",
            string.Create(CultureInfo.InvariantCulture, $"+W{job.Width}"),
            string.Create(CultureInfo.InvariantCulture, $"+H{job.Height}"),
            string.Create(CultureInfo.InvariantCulture, $"+WT{job.Threads}"),
        ];
        string[] rows = job.Rows is PixelRows some
            ? [string.Create(CultureInfo.InvariantCulture, $"+SR{some.First + 1}"), string.Create(CultureInfo.InvariantCulture, $"+ER{some.End}")]
            : [];
        foreach (string argument in (string[])[.. own, .. rows, .. DefaultOptions, .. job.Options])
        {
            start.ArgumentList.Add(argument);
        }

        return start;
    }

    private async Task<string> RunAsync(PovRayJob job, string folder, CancellationToken cancellation)
    {
        using Process process = new() { StartInfo = StartInfo(_program, job, folder) };
        try
        {
            process.Start();
        }
        catch (Win32Exception exception)
        {
            throw new PovRayException($"{_program}: can't be started: {exception.Message}", exception);
        }

        process.StandardInput.Close();
        using CancellationTokenSource limit = CancellationTokenSource.CreateLinkedTokenSource(cancellation);
        if (job.Timeout is TimeSpan timeout)
        {
            limit.CancelAfter(timeout);
        }

        Task<string> standardOutput = process.StandardOutput.ReadToEndAsync(CancellationToken.None);
        Task<string> standardError = process.StandardError.ReadToEndAsync(CancellationToken.None);
        try
        {
            await process.WaitForExitAsync(limit.Token).ConfigureAwait(false);
        }
        catch (OperationCanceledException)
        {
            process.Kill(entireProcessTree: true);
            await process.WaitForExitAsync(CancellationToken.None).ConfigureAwait(false);
            cancellation.ThrowIfCancellationRequested();
            throw new PovRayException(string.Create(
                CultureInfo.InvariantCulture, $"{_program} was ended after {job.Timeout!.Value.TotalSeconds:R} s (--timeout)."));
        }

        string output = await standardOutput.ConfigureAwait(false) + await standardError.ConfigureAwait(false);
        if (process.ExitCode == 0 && File.Exists(Path.Combine(folder, ImageName)))
        {
            return output;
        }

        string command = $"{_program} {string.Join(' ', process.StartInfo.ArgumentList)}";
        string said = LastLines(output) is { Length: > 0 } lines ? lines : "it printed nothing";
        throw new PovRayException(process.ExitCode == 0
            ? $"{command}: ended without an image: {said}"
            : string.Create(CultureInfo.InvariantCulture, $"{command}: exit code {process.ExitCode}: {said}"));
    }

    private static string LastLines(string output) =>
        string.Join(" | ", output
            .Split(['\n', '\r'], StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries)
            .TakeLast(ReportedLines));
}
