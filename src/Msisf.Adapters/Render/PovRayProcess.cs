using System.Text;
using Msisf.Adapters.IO;
using Msisf.Adapters.Programs;
using Msisf.Core.Camera;

namespace Msisf.Adapters.Render;

/// <summary>
/// Runs POV-Ray. Each run has a folder of its own with plain names inside, so that no path of the user's (spaces, quotes,
/// umlauts) ever passes through POV-Ray's option parser.
/// </summary>
public sealed class PovRayProcess
{
    /// <summary>
    /// Rows of one of POV-Ray 3.7's blocks. Antialiasing at a block's edge depends on where the blocks are, so a strip of an image has the
    /// pixels of the whole image only if it begins at a multiple of this (measured; other strips differ in a few pixels).
    /// </summary>
    public const int BlockRows = 32;

    private const string SceneName = "scene.pov";
    private const string ImageName = "image.png";
    private const string PatternLink = "patterns";
    private const string EmptySettings = "povray.ini";

    /// <summary>How many of the last lines of a failed run its error shows.</summary>
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
    /// <exception cref="ExternalPartException">POV-Ray can't be started.</exception>
    /// <exception cref="PovRayException">It fails or exceeds the job's time limit.</exception>
    /// <exception cref="BadInputException">What POV-Ray left is not a whole image.</exception>
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
        catch (Exception exception) when (exception.IsFileError())
        {
            throw new PovRayException($"{job.WorkFolder}: POV-Ray's files can't be kept there: {exception.Message}", exception);
        }
    }

    private static IReadOnlyList<string> ArgumentsOf(PovRayJob job)
    {
        string[] own =
        [
            $"+I{SceneName}", $"+O{ImageName}", $"+L{PatternLink}", "+FN8", "-D",
            Invariant($"+W{job.Width}"),
            Invariant($"+H{job.Height}"),
            Invariant($"+WT{job.Threads}"),
        ];
        string[] rows = job.Rows is PixelRows some
            ? [Invariant($"+SR{some.First + 1}"), Invariant($"+ER{some.End}")]
            : [];
        return [.. own, .. rows, .. DefaultOptions, .. job.Options];
    }

    private async Task<string> RunAsync(PovRayJob job, string folder, CancellationToken cancellation)
    {
        ChildProgram povRay = new(_program, ArgumentsOf(job))
        {
            WorkingFolder = folder,
            Environment = new Dictionary<string, string> { ["POVINI"] = EmptySettings }, // a user's own povray.ini must not change images
            TimeLimit = job.Timeout,
        };
        ProcessResult result;
        try
        {
            result = await povRay.RunAsync(cancellation).ConfigureAwait(false);
        }
        catch (TimeoutException exception)
        {
            throw new PovRayException($"{exception.Message} (--timeout).", exception);
        }

        string output = result.Output + result.Error;
        if (result.ExitCode == 0 && File.Exists(Path.Combine(folder, ImageName)))
        {
            return output;
        }

        string command = $"{_program} {string.Join(' ', povRay.Arguments)}";
        string said = LastLines(output) is { Length: > 0 } lines ? lines : "it printed nothing";
        throw new PovRayException(result.ExitCode == 0
            ? $"{command}: ended without an image: {said}"
            : Invariant($"{command}: exit code {result.ExitCode}: {said}"));
    }

    private static string LastLines(string output) =>
        string.Join(" | ", output
            .Split(['\n', '\r'], StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries)
            .TakeLast(ReportedLines));
}
