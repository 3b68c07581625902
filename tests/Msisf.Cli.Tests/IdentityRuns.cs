using System.Buffers.Binary;
using System.Security.Cryptography;
using System.Text.Json;
using Msisf.TestSupport;

namespace Msisf.Cli.Tests;

/// <summary>The outputs of a run of one frame.</summary>
/// <param name="Identity">Its key in the manifest.</param>
/// <param name="Arguments">The canonical arguments in its meta file.</param>
/// <param name="Files">Checksums of its files.</param>
/// <param name="FilesWithoutArguments">The same, the canonical arguments taken out of the meta file.</param>
internal sealed record DrawnFrame(
    string Identity, string Arguments, IReadOnlyList<string> Files, IReadOnlyList<string> FilesWithoutArguments);

/// <summary>Draws small frames in this process, each call once, and has the files that their options name.</summary>
public sealed class IdentityRuns : IDisposable
{
    private const string FilePrefix = "FILE:";

    private const string Common = "--fixed-state {55289,1.9E6,0,0,0,0,0,1} --renderer native --width 32 --height 32 --fov 30 --grid 8 "
        + "--reflectance lambert --albedo-map none --ephemeris builtin --output-name a";

    private const string Detector = "width: 32\nheight: 32\nfocal-length: 0.4\npixel-pitch: 0.008\ndetector:\n"
        + "  f-number: 40\n  exposure-time: 0.4\n  band: [500, 600]\n  quantum-efficiency: 0.5\n"
        + "  gain: 200\n  adc-bits: 12\n  fits: no\n";

    /// <summary>The ways to say where the camera is: another one takes the place of the common one.</summary>
    private static readonly string[] Ways =
        ["--batch-file", "--kepler-set", "--state-vectors", "--position", "--oem", "--spacecraft", "--trajectory"];

    /// <summary>Of the common options, what a camera file says itself.</summary>
    private static readonly string[] OfCamera = ["--width", "--height", "--fov"];

    private readonly TemporaryFolder _folder = new();
    private readonly Dictionary<string, DrawnFrame> _known = [];
    private readonly string _checksumOfMap;

    public IdentityRuns()
    {
        _folder.Write("a.tab", "55289 1.9E6 0 0 0 0 0.28 0.96\n");
        _folder.Write("b.tab", "55289 1.91E6 0 0 0 0 0.28 0.96\n");
        _folder.Write("euler.csv", "time,x,y,z,euler1,euler2,euler3\n55289,1.9E6,0,0,10,5,3\n");
        _folder.Write("a.yaml", "focal-length-px: 60\nwidth: 32\nheight: 32\n");
        _folder.Write("b.yaml", "focal-length-px: 61\nwidth: 32\nheight: 32\n");
        _folder.Write("detector.yaml", Detector);
        _folder.Write("shutter.yaml", $"{Detector}  shutter: global\n");
        _folder.Write("line.yaml", "focal-length-px: 60\nwidth: 32\nheight: 1\nscan:\n  kind: line-scan\n  period: 0.1\n");
        _folder.Write("strip.yaml", "focal-length-px: 60\nwidth: 32\nheight: 8\nscan:\n  kind: push-frame\n  period: 0.1\n");
        _folder.Write("a.rig", "cameras:\n  a:\n    fov: 30\n    width: 32\n    height: 32\n    quaternion: [0, 0, 0, 1]\n");
        _folder.Write("b.rig", "cameras:\n  a:\n    fov: 30\n    width: 32\n    height: 32\n    quaternion: [0, 0, 0.28, 0.96]\n");
        _folder.Write("a.jitter", "pitch 3 9000 1\n");
        _folder.Write("b.jitter", "pitch 3 9001 1\n");
        _folder.Write("a.path", "55289 1.9E6 0 0 0 0 0 1\n55289.0001 1.9E6 9E3 0 0 0 0.28 0.96\n55289.0003 1.9E6 3E4 0 0 0 0 1\n");
        _folder.Write("b.path", "55289 1.9E6 0 0 0 0 0 1\n55289.0001 1.9E6 9E3 1E3 0 0 0.28 0.96\n55289.0003 1.9E6 3E4 0 0 0 0 1\n");
        _folder.Write("config.yaml", "exposure: 2\n");
        string[] kernels = ["de421.bsp", "moon_pa_de421_1900-2050.bpc", "moon_assoc_me.tf", "moon_080317.tf", "naif0012.tls"];
        _folder.Write("other.tm", string.Concat(
            "KPL/MK\n\\begindata\nKERNELS_TO_LOAD = (\n",
            string.Concat(kernels.Select(kernel => $"'{Path.Combine(TestParts.Kernels, kernel)}'\n")), ")\n"));
        string map = PdsMap.Write(_folder, "WAC_A", "PC_REAL", 32, 1, (column, line) => 50 + ((column + line) % 50));
        PdsMap.Write(
            _folder, "WAC_B", "PC_REAL", 32, 2, (column, _) => 0.04 + (0.001 * column), west: 350.0, north: 10.0, degrees: (20, 20));
        _checksumOfMap = Convert.ToHexStringLower(SHA256.HashData(File.ReadAllBytes(map)));
        _folder.Write("hapke.img", HapkeMap());
        _folder.Write("landmarks.csv", "lat,lon\n0,0\n");
        _folder.Write("craters.csv", "lat,lon,diam_km\n0,0,60\n1,1,40\n");
        _folder.Write("more.csv", "lat,lon,diam_km\n0,0,60\n1,1,41\n");
        _folder.Write("other.tf", """
            KPL/FK
            \begindata
            FRAME_MSISF_OTHER = -999002
            FRAME_-999002_NAME = 'MSISF_OTHER'
            FRAME_-999002_CLASS = 4
            FRAME_-999002_CLASS_ID = -999002
            FRAME_-999002_CENTER = -999
            TKFRAME_-999002_SPEC = 'ANGLES'
            TKFRAME_-999002_RELATIVE = 'MSISF_CAMERA'
            TKFRAME_-999002_ANGLES = ( 0, 0, 30 )
            TKFRAME_-999002_AXES = ( 1, 2, 3 )
            TKFRAME_-999002_UNITS = 'DEGREES'

            """);
        Fly("near", "{1.9E6,0.01,0,0,1,0}", "{0,0,0,1}");
        Fly("far", "{1.91E6,0.01,0,0,1,0}", "{0,0,0.28,0.96}");
        Synthesize("models", "--res", "1", "--seed", "1");
        Synthesize("models", "--res", "2", "--seed", "1");
        Synthesize("models", "--projection", "polar-south", "--map-scale", "10000", "--seed", "1");
        Synthesize("others", "--res", "2", "--seed", "2");
        Synthesize("mercury", "--res", "1", "--seed", "1", "--body", "mercury");
    }

    public void Dispose() => _folder.Dispose();

    /// <summary>Draws the frame of the common options, of which these take the place.</summary>
    /// <param name="words">The options.</param>
    /// <param name="changed">Options that take the place of those.</param>
    internal DrawnFrame Of(string words, string changed = "")
    {
        string call = $"{words}|{changed}";
        if (!_known.TryGetValue(call, out DrawnFrame? frame))
        {
            _known.Add(call, frame = Draw(words, changed));
        }

        return frame;
    }

    private DrawnFrame Draw(string words, string changed)
    {
        ILookup<string, string[]> common = Options($"{Common} --output-dir FILE:out{_known.Count}");
        ILookup<string, string[]> given = Options(words);
        ILookup<string, string[]> change = Options(changed);
        string[] replaced =
        [
            .. given.Concat(change).Select(option => option.Key),
            .. Ways.Any(given.Contains) ? ["--fixed-state"] : (string[])[],
            .. given.Contains("--camera") || given.Contains("--rig") ? OfCamera : [],
        ];
        string[] arguments =
        [
            .. common.Where(option => !replaced.Contains(option.Key)).Concat(given.Where(option => !change.Contains(option.Key)))
                .Concat(change).SelectMany(option => option.SelectMany(value => value.Prepend(option.Key))),
        ];
        CommandLineRun run = CommandLineRun.Of(arguments);
        return run.ExitCode == 0
            ? Read(arguments[Array.IndexOf(arguments, "--output-dir") + 1])
            : throw new InvalidOperationException($"{words} {changed}: {run.Error}");
    }

    /// <summary>The values of each option; none of a flag.</summary>
    private ILookup<string, string[]> Options(string words) => words.Split("--", StringSplitOptions.RemoveEmptyEntries)
        .Select(option => option.Split(' ', StringSplitOptions.RemoveEmptyEntries))
        .ToLookup(option => $"--{option[0]}", option => (string[])[.. option[1..].Select(Value)]);

    private string Value(string text) => text == "SHA" ? _checksumOfMap
        : text.StartsWith(FilePrefix, StringComparison.Ordinal) ? _folder[text[FilePrefix.Length..]]
        : text;

    private static DrawnFrame Read(string folder)
    {
        string manifest = File.ReadLines(Path.Combine(folder, "msisf-manifest.jsonl"))
            .Last(line => line.Contains("\"record\":\"expected\"", StringComparison.Ordinal));
        using JsonDocument expected = JsonDocument.Parse(manifest);
        string[] paths = [.. Directory.EnumerateFiles(folder)
            .Where(path => !Path.GetFileName(path).Contains("msisf", StringComparison.Ordinal))
            .OrderBy(path => Path.GetFileName(path).Split('.', 2)[1], StringComparer.Ordinal)];
        string meta = File.ReadAllText(paths.Single(path => Path.GetExtension(path) == ".xml"));
        string arguments = meta.Split("<CommandLine>")[1].Split("</CommandLine>")[0];
        string[] others = [.. paths.Where(path => Path.GetExtension(path) != ".xml")];
        return new DrawnFrame(
            expected.RootElement.GetProperty("frame").GetString()!,
            arguments,
            [.. paths.Select(ChecksumOf)],
            [.. others.Select(ChecksumOf), meta.Replace(arguments, string.Empty, StringComparison.Ordinal)]);
    }

    private static string ChecksumOf(string path) => Convert.ToHexStringLower(SHA256.HashData(File.ReadAllBytes(path)));

    /// <summary>Writes a day's states on an orbit as CCSDS files and as kernels.</summary>
    private void Fly(string folder, string orbit, string attitude)
    {
        foreach (string format in (string[])["oem", "spice"])
        {
            CommandLineRun made = CommandLineRun.Of([
                "states", "--kepler-set", orbit, "--epoch", "55289", "--time-interval", "[55289:0.001:55289.02]", "--attitude", attitude,
                "--format", format, "--to", _folder[folder]]);
            if (made.ExitCode != 0)
            {
                throw new InvalidOperationException(made.Error);
            }
        }
    }

    private void Synthesize(string folder, params string[] options)
    {
        CommandLineRun made = CommandLineRun.Of(["ldem", "synthesize", .. options, "--output-dir", _folder[folder]]);
        if (made.ExitCode != 0)
        {
            throw new InvalidOperationException(made.Error);
        }
    }

    /// <summary>A file of the layout of LROC's map of Hapke's parameters: nine maps of one degree from 70 N to 70 S.</summary>
    private static byte[] HapkeMap()
    {
        float[] values = [0.3854f, 0.2375f, 0.3253f, 0f, 1f, 1.686f, 0.0672f, 23.6566f, 0f];
        const int offset = 5760;
        const int samples = 360 * 140;
        byte[] bytes = new byte[offset + (values.Length * samples * sizeof(float))];
        for (int index = 0; index < values.Length * samples; index++)
        {
            BinaryPrimitives.WriteSingleLittleEndian(bytes.AsSpan(offset + (index * sizeof(float))), values[index / samples]);
        }

        return bytes;
    }
}
