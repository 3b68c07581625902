using System.Text;
using Msisf.Adapters.Ephemeris;
using Msisf.Adapters.IO;
using Msisf.Adapters.Input;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Products;
using Msisf.App.Rendering;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Camera;
using Msisf.Core.Render;
using Msisf.Core.Scene;

namespace Msisf.App.Cluster;

/// <summary>Converts a run to a script that makes it in pieces.</summary>
internal sealed class RunConversion(ProgramHost host)
{
    /// <summary>Maximum number of characters of the call in a script's head; only a call with a long list of times is longer.</summary>
    private const int LongestCall = 2000;

    /// <summary>Checks the run, cuts it into pieces, and writes the script and the files that it needs.</summary>
    /// <param name="call">The words of the call, for the head of the script.</param>
    /// <param name="scriptPath">Path of the script, relative to the folder of the outputs; missing folders are created.</param>
    /// <param name="cancellation">Cancels the work; no file is left.</param>
    /// <exception cref="MsisfException">The run itself would fail; nothing has been written.</exception>
    public ConvertedRun Convert(
        OptionValues values, IReadOnlyList<string> call, ScriptFormat format, Func<RenderSettings, string> scriptPath,
        CancellationToken cancellation)
    {
        CutSettings cut = CutOptions.Read(values);
        SlurmSettings? slurm = format == ScriptFormat.Slurm ? SlurmOptions.Read(values) : null;
        PieceArguments arguments = new(values, endsWithCheck: format is ScriptFormat.Parallel or ScriptFormat.Slurm);
        TrajectorySettings trajectory = TrajectorySettingsReader.Read(values);
        IReadOnlyList<RenderSettings> cameras = RigOptions.Read(values);
        RenderSettings settings = cameras[0];
        ProductTable.RefuseInStrips(settings);
        if (trajectory is BatchFileSettings { IsStandardInput: true })
        {
            throw new UsageException("--batch-file -: standard input can't be read again by each piece. Save it to a file, and give that.");
        }

        if (settings is { Camera: not null, Rig: null } && ImageOptions.Camera.ReadIfGiven(values) is null)
        {
            throw MissionOptions.Instrument.Wrong(
                "gives the camera of its instrument kernel, which the pieces of a run do not read. Give the camera with "
                    + $"{ImageOptions.Camera.Name}.", ImageOptions.Camera);
        }

        if (cameras.Any(camera => camera.Scan is not null || camera.Jitter is not null) && trajectory is not BatchFileSettings)
        {
            throw new UsageException(
                "the pieces of a run read single states, and a camera that scans or has jitter needs all of its motion. Make the run "
                    + $"without pieces, or give {CameraOptions.BatchFile.Name} with {string.Join(", ", CameraMotion.NumberNames)} in each "
                    + "line.");
        }

        if (settings is { Rig: not null, Native.FindsExposureTime: true })
        {
            throw NativeOptions.ExposureTime.Wrong(
                $"{NativeOptions.Automatic} finds a time for each camera of a rig, and pieces take one. Give seconds, or "
                    + "'exposure-time' in the camera files.", RigOptions.Rig);
        }

        using EphemerisSource ephemeris = new(settings, host);
        using PreparedRun run = PreparedRun.Of(trajectory, cameras, ephemeris, host, cancellation);
        bool findsExposure = settings is { Rig: null, Native.FindsExposure: true }; // the cameras of a rig find their own in each piece
        using (SurfaceInputs maps = SurfaceInputs.Open(settings, host))
        {
            settings = ExposureSearch.Resolve(
                settings, run.Cameras[0].States, run.Cameras[0].Frames, run.Model, maps, ephemeris.Engine, host, cancellation);
        }

        EphemerisChoice? engine = ephemeris.Opened?.Choice;
        CheckResources([.. run.Cameras.Select(camera => (camera.Settings, camera.Frames.Count))], slurm);
        string path = Path.GetFullPath(scriptPath(settings));
        bool isReadAsItIs = trajectory is BatchFileSettings { Motion: null } file && file.Conventions == new BatchConventions();
        string? statesFile = isReadAsItIs ? null : $"{path}.states.tab";
        string batchFile = statesFile ?? ((BatchFileSettings)trajectory).Path;
        PieceScript script = new()
        {
            Path = path,
            Call = CallOf(call),
            Version = host.Version,
            Launcher = host.Installation.Launcher,
            WorkingFolder = Directory.GetCurrentDirectory(),
            Arguments = arguments.OfPiece(
                batchFile, engine, settings.Native.ExposureTime, findsExposure ? settings.Native.Grey.Exposure : null),
            HasJobs = settings.Jobs is not null,
            NeedsPatterns = settings.Renderer == RendererKind.PovRay,
            PatternArguments = arguments.OfPatterns(batchFile, engine),
            OutputFolder = settings.OutputFolder,
            Pieces = Cut(run, cut),
        };
        string text = slurm is null ? ScriptText.Of(format, script) : ScriptText.Slurm(script, slurm);

        // What an option sets for all pieces can't be in the file too.
        SpacecraftState[] states = [.. run.Cameras[0].BodyStates.Select(state => state with
        {
            Noise = trajectory.Noise is null ? state.Noise : null,
            ExposureFactor = trajectory.ExposureFactor is null ? state.ExposureFactor : null,
        })];
        Write(script, text, statesFile, states, hasLogs: slurm is not null);
        return new ConvertedRun(path, statesFile, settings.OutputFolder, run.Frames.Count, script.Pieces.Count);
    }

    private static IReadOnlyList<StepRanges> Cut(PreparedRun run, CutSettings cut)
    {
        int[] steps = [.. run.Cameras[0].Frames.Select(frame => frame.Step)];
        return cut.FramesPerPiece is int size ? RunCutter.BySize(steps, size) : RunCutter.ByCount(steps, cut.Pieces!.Value);
    }

    private static string CallOf(IReadOnlyList<string> call)
    {
        string words = string.Join(' ', call.Select(PosixWord.Of));
        string shown = string.Concat(words.Select(character => char.IsControl(character) ? '?' : character));
        return shown.Length <= LongestCall ? shown : $"{shown[..LongestCall]}...";
    }

    /// <summary>Refuses a run whose pieces would lack memory or whose outputs would not fit on the disk.</summary>
    private static void CheckResources(IReadOnlyList<(RenderSettings Settings, int Frames)> cameras, SlurmSettings? slurm)
    {
        RenderSettings settings = cameras[0].Settings;
        int atOnce = settings.Jobs ?? slurm?.CpusPerTask ?? 1;
        ResourceCheck.Check(cameras, atOnce, slurm?.MemoryBytes ?? long.MaxValue, DiskRoom.Of(settings.OutputFolder));
    }

    private static void Write(PieceScript script, string text, string? statesFile, IReadOnlyList<SpacecraftState> states, bool hasLogs)
    {
        FileErrors.ToExternalPart($"{script.Path}: the script can't be written there", () =>
        {
            Directory.CreateDirectory(Path.GetDirectoryName(script.Path)!);
            if (hasLogs)
            {
                Directory.CreateDirectory($"{script.Path}.logs");
            }

            // An old job log lists pieces of the previous script, and GNU parallel would skip the new pieces with the same numbers.
            File.Delete($"{script.Path}.joblog");
        });

        if (statesFile is not null)
        {
            AtomicFile.WriteText(
                statesFile, writer => BatchFileWriter.Write(writer, $"Made by msis {script.Version}: msis {script.Call}", states));
        }

        AtomicFile.Write(script.Path, stream => stream.Write(Encoding.UTF8.GetBytes(text)));
    }
}

/// <summary>A run that was converted to a script.</summary>
/// <param name="StatesFile">
/// Full path of the states file that was written beside the script; null if the run has a batch file of its own.
/// </param>
/// <param name="OutputFolder">Folder of the frames.</param>
/// <param name="FrameCount">Number of frames in all pieces.</param>
internal sealed record ConvertedRun(string Script, string? StatesFile, string OutputFolder, int FrameCount, int PieceCount);

/// <summary>Cuts the steps of a run into contiguous pieces.</summary>
internal static class RunCutter
{
    /// <summary>Cuts the steps into a given number of pieces of nearly equal size.</summary>
    /// <param name="steps">The steps, ascending.</param>
    /// <param name="pieces">Number of pieces; with fewer steps than this, one piece per step is made.</param>
    /// <returns>The pieces; none is empty, and their sizes differ by 1 at most.</returns>
    public static IReadOnlyList<StepRanges> ByCount(IReadOnlyList<int> steps, int pieces)
    {
        int count = Math.Min(pieces, steps.Count);
        return [.. Enumerable.Range(0, count).Select(piece => Of(steps, StartOf(piece), StartOf(piece + 1)))];

        int StartOf(int piece) => (int)((long)steps.Count * piece / count);
    }

    /// <summary>Cuts the steps into pieces of a given size; the last one may be smaller.</summary>
    public static IReadOnlyList<StepRanges> BySize(IReadOnlyList<int> steps, int size) =>
        [.. steps.Chunk(size).Select(StepRanges.Of)];

    private static StepRanges Of(IReadOnlyList<int> steps, int start, int end) =>
        StepRanges.Of(Enumerable.Range(start, end - start).Select(index => steps[index]));
}
