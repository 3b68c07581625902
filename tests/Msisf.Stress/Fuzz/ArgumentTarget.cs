using System.Globalization;

namespace Msisf.Stress.Fuzz;

/// <summary>Command lines of all commands, with arguments damaged, lost, doubled, moved and thrown in.</summary>
/// <param name="world">Right inputs, which they name.</param>
internal sealed class ArgumentTarget(FuzzWorld world) : IFuzzTarget
{
    private const int MaxDamages = 3;

    /// <summary>px: a greater image is only slower.</summary>
    private const int LargestSide = 32;

    private static readonly string[] SizeOptions = ["--width", "-w", "--height", "-h"];

    /// <summary>Thrown in anywhere. Options that name a file to be written are not among them: it could be anyone's.</summary>
    private static readonly string[] Words =
    [
        "--kepler-set", "-k", "--state-vectors", "-s", "--fixed-state", "--batch-file", "--epoch", "-e", "--time", "-t", "--times", "-tt",
        "--time-interval", "--attitude", "-a",
        "--attitude-transition", "-at", "--orbit-frame", "j2000", "--fov", "-f", "--width", "-w", "--height", "-h", "--grid", "-gH",
        "--gridV", "--surface", "terrain", "--lod", "off",
        "--lod-error", "--ignore-sun", "--rendering-annotation", "--output-name", "{step}", "{mjd:0.0}", "--res", "-r", "--ldem",
        "--renderer", "native", "povray", "--reflectance",
        "hapke:w=0.3", "lunar-lambert:l=2", "moon", "nac", "--albedo-map", "none", "--albedo-map-properties", "scale=1,west=0",
        "--albedo-map-checksum", "--band", "415", "--hapke-map", "--albedo", "--sun", "disc", "--samples", "auto:0.5",
        "--shading", "smooth",
        "--exposure", "--transfer",
        "linear", "--bit-depth", "16", "--layers", "all",
        "--layers-format", "npy", "--layers-precision", "single", "--layers-compression", "gzip",
        "--batch", "-b", "--ephemeris", "--aberration", "lt+s", "--kernels", "--pov-path", "--pov-options",
        "--timeout", "--jobs", "-j", "--frames", "1:2,7",
        "--overwrite", "--fail-fast", "--list-patterns", "--timing", "--config", "--help", "-?", "--version", "--margin", "--format",
        "--dry-run", "json", "--source", "mysql", "--defaults-file", "--base",
        "--region", "--seed", "--verify", "--print-frames", "patterns", "ldem", "synthesize", "pyramid", "status", "verify", "config",
        "show", "--", "-", "@a.rsp", "[suggest]", "[diagram]", "",
    ];

    public string Name => "command lines";

    public FuzzCase Make(string folder, CaseRandom random, bool isDamaged)
    {
        IReadOnlyList<string>[] calls = [.. Calls()];
        List<string> arguments = [.. calls[random.Below(calls.Length)]];
        HashSet<string> right = [.. arguments];
        for (int left = isDamaged ? 1 + random.Below(MaxDamages) : 0; left > 0; left--)
        {
            Damage(arguments, random);
        }

        IEnumerable<string> harmless = arguments.Select(argument => right.Contains(argument) ? argument : argument.Replace('/', '_'));
        return new FuzzCase(
            folder,
            [.. Small([.. harmless]), .. Places(arguments, folder)],
            arguments.Contains("-") ? "51544.5 1.9E6 0 0 0 0 0 1\n" : string.Empty);
    }

    private IEnumerable<IReadOnlyList<string>> Calls()
    {
        yield return [.. world.Sources, "--fixed-state", FuzzWorld.State];
        yield return
        [
            .. world.Sources, "--fixed-state", "51544.5", "1.9E6", "0", "0", "0", "0", "0", "1", "--surface", "terrain", "--grid", "1"
        ];
        yield return
        [
            .. world.Sources, "-k", "{1.9E6,0.05,0.7,1.1,0.9,2.0}", "-e", "51544.5", "-tt", "{51544.5,51544.6}", "-a", "{0,0,0,1}", "-at",
            "{0,0,1E-3}"
        ];
        yield return
        [
            .. world.Sources, "-s", "{1.9E6,0,0,0,1600,0}", "--epoch", "51544.5", "--time-interval", "[51544.5:0.01:51544.52]",
            "--orbit-frame", "moon-me-epoch"
        ];
        yield return [.. world.Sources, "--batch-file", "-", "--output-name", "f_{step:000}_{mjd:0.00}", "--frames", "1"];
        yield return
        [
            .. world.Sources.Where(word => word is not ("--reflectance" or "lambert")), "--fixed-state", FuzzWorld.State, "--layers",
            "depth,normal,cell", "--layers-format", "npy", "--reflectance", "hapke:b=0.2,c=0.1", "--albedo", "0.3",
            "--sun", "disc", "--samples", "4", "--shading", "smooth", "--exposure", "2", "--transfer", "linear", "--bit-depth", "16",
            "--aberration", "lt", "--lod-error", "1",
        ];
        yield return
        [
            .. FuzzWorld.TinyImage, "--list-patterns", "--ignore-sun", "--fixed-state", FuzzWorld.State, "--ldem", world.Model, "--res",
            "1", "--lod", "off"
        ];
        yield return
        [
            .. FuzzWorld.TinyImage, "--fixed-state", FuzzWorld.State, "--ldem", world.Model, "--res", "1", "--timeout", "5",
            "--pov-options", "-A +Q9", "--jobs", "2", "--timing"
        ];
        yield return ["patterns", "--ldem", world.Model, "--res", "1", "--margin", "0.5", "--format", "mesh", "--batch"];
        yield return ["ldem", "synthesize", "--res", "1", "--seed", "1", "--region", "0:1:0:2", "--batch"];
        yield return ["ldem", "pyramid", world.FineModel];
        yield return ["status", world.OutputFolder, "--print-frames"];
        yield return ["verify", world.OutputFolder];
        yield return ["config", "show"];
    }

    private static void Damage(List<string> arguments, CaseRandom random)
    {
        int place = random.Below(arguments.Count);
        switch (random.Below(9))
        {
            case 0 or 1:
                // no system passes NUL
                arguments[place] = ByteMutator.Mutate(arguments[place], random).Replace("\0", "", StringComparison.Ordinal);
                break;
            case 2:
                arguments[place] = FuzzWords.Numbers[random.Below(FuzzWords.Numbers.Count)];
                break;
            case 3 when arguments.Count > 1:
                arguments.RemoveAt(place);
                break;
            case 4:
                arguments.Insert(place, arguments[random.Below(arguments.Count)]);
                break;
            case 5:
                int other = random.Below(arguments.Count);
                (arguments[place], arguments[other]) = (arguments[other], arguments[place]);
                break;
            case 6:
                arguments.Insert(place, FuzzWords.Signs[random.Below(FuzzWords.Signs.Count)].Replace("\0", "", StringComparison.Ordinal));
                break;
            case 7 when place + 1 < arguments.Count:
                arguments[place] = $"{arguments[place]}={arguments[place + 1]}";
                arguments.RemoveAt(place + 1);
                break;
            default:
                arguments.Insert(place, Words[random.Below(Words.Length)]);
                break;
        }
    }

    private static IEnumerable<string> Small(IReadOnlyList<string> arguments) => arguments.Select((argument, index) =>
        index > 0 && SizeOptions.Contains(arguments[index - 1])
            && int.TryParse(argument, NumberStyles.Integer, CultureInfo.InvariantCulture, out int side)
            && side is > LargestSide and <= 16384
            ? LargestSide.ToString(CultureInfo.InvariantCulture)
            : argument);

    /// <summary>Where the command writes to, undamaged and last: nothing is written outside the case's folder.</summary>
    private static string[] Places(List<string> arguments, string folder) => arguments[0] switch
    {
        "patterns" => ["--pattern-repos", Path.Combine(folder, "patterns")],
        "ldem" when arguments.Contains("pyramid") => ["--verify"], // without it the shared model's own pyramid is written
        "status" or "verify" or "config" => [],
        _ => ["--output-dir", Path.Combine(folder, "out")],
    };
}
