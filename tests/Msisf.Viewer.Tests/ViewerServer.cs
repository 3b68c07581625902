using System.Text;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Viewer.Tests;

/// <summary>
/// <c>msis view --no-browser</c> as a user starts it, in a process of its own, with a finished folder of two frames, a batch file, a
/// trajectory and a catalogue of craters. Started when the first test asks for its address.
/// </summary>
public sealed class ViewerServer : IDisposable
{
    /// <summary>Where the camera of the folder's first frame is; over latitude 0, longitude 0.</summary>
    public const string FirstState = "55289 2000000 0 0 0 0 0 1";

    private const double StartSeconds = 120.0;

    private readonly TemporaryFolder _folder = new();
    private readonly Lazy<(RunningProgram Program, string Address)> _running;

    public ViewerServer() => _running = new Lazy<(RunningProgram, string)>(Start);

    /// <summary>The address of the page.</summary>
    public string Address => _running.Value.Address;

    /// <summary>A folder for the files of tests.</summary>
    public string Folder => _folder.Path;

    /// <summary>The finished folder.</summary>
    public string Run => Path.Combine(Folder, "run");

    /// <summary>The options of the folder's frames, some other than the page's own.</summary>
    public static IReadOnlyList<string> OptionsOfRun { get; } =
    [
        "--renderer", "native", "--width", "96", "--height", "64", "--fov", "30", "--rendering-annotation", "--albedo-map", "none",
        "--shading", "smooth", "--transfer", "linear",
    ];

    public void Dispose()
    {
        if (_running.IsValueCreated)
        {
            _running.Value.Program.Dispose();
        }

        _folder.Dispose();
    }

    private (RunningProgram Program, string Address) Start()
    {
        string batch = Path.Combine(Folder, "approach.tab");
        File.WriteAllText(batch, $"{FirstState}\n55289.25 2000000 0 0 0 0 0 1\n");
        string oem = Path.Combine(Folder, "orbit.oem");
        File.WriteAllText(
            oem,
            "CCSDS_OEM_VERS = 2.0\nMETA_START\nOBJECT_NAME = A\nOBJECT_ID = A\nCENTER_NAME = MOON\nREF_FRAME = ICRF\nTIME_SYSTEM = UTC\n"
                + "META_STOP\n2024-01-19T12:00:00 2000 0 0 1 0 0\n2024-01-19T12:01:40 2100 0 0 1 0 0\n");
        string craters = Path.Combine(Folder, "craters.csv");
        File.WriteAllText(craters, "Feature Name,Diameter,Center Latitude,Center Longitude\nPtolemaeus,153.67,-9.16,358.16\n");
        string landmarks = Path.Combine(Folder, "landmarks.csv");
        File.WriteAllText(landmarks, "id,name,lat,lon,height\np,Peak,-9.5,358.5,3000\n");
        CommandLineRun run = CommandLineRun.Of([.. OptionsOfRun, "--batch-file", batch, "--output-dir", Run, "--batch"]);
        Assert.True(run.ExitCode == 0, run.Error);

        return StartProgram(["view", "--no-browser", Run, "--folders", $"{batch},{oem}", "--catalogues", $"{craters},{landmarks}"], Folder);
    }

    /// <summary>Starts a server in a process of its own, and waits for its address.</summary>
    /// <param name="arguments">Of msis.</param>
    /// <param name="folder">Its working directory.</param>
    internal static (RunningProgram Program, string Address) StartProgram(IReadOnlyList<string> arguments, string folder)
    {
        StringBuilder output = new();
        RunningProgram program = RunningProgram.Start(
            TestedProgram.File, TestedProgram.Words(arguments), folder,
            onOutput: text =>
            {
                lock (output)
                {
                    output.Append(text);
                }
            });
        Within.Seconds(StartSeconds, "the address of the server", () => Text().Contains('\n', StringComparison.Ordinal))
            .GetAwaiter().GetResult();
        return (program, Text().Split('\n')[0].Trim());

        string Text()
        {
            lock (output)
            {
                return output.ToString();
            }
        }
    }
}
