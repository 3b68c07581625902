namespace Msisf.Stress.Fuzz;

/// <summary>Files that people write or that a run writes: batch files, response files, settings, kernels, manifests.</summary>
/// <param name="world">The right ones.</param>
internal sealed class TextInputs(FuzzWorld world)
{
    private const string BatchFile =
        "# MJD rx ry rz qx qy qz q0\n51544.5 1.9E6 0 0 0 0 0 1\n51544.6\t+2.0E+006 -1.5 .5 0 0 0 1 # far\n\n51544.7 2E6 2E6 0 0 0 "
            + "3.826834323650898E-1 9.238795325112867E-1\n";

    private const string Settings = """
        # what every call needs
        fov: 20
        width: 1
        height: 1
        batch: true
        res: 1
        renderer: native
        ephemeris: builtin
        layers: [depth, mask]
        layers-format: npy
        reflectance: "hapke:w=0.3,b0=1.2"
        timeout: 5
        pov-options:
          - -A
          - +Q9
        output-name: 'frame_{step:000}'
        """;

    public IFuzzTarget BatchFiles => new FileTarget(
        "batch files", [FuzzInput.Text("a.tab", BatchFile, path => [[.. world.Sources, "--batch-file", path, .. Output(path)]])]);

    public IFuzzTarget ResponseFiles => new FileTarget(
        "response files",
        [
            FuzzInput.Text(
                "a.rsp",
                $"# a call\n{string.Join('\n', world.Sources.Select(word => $"\"{word}\""))}\n--fixed-state "
                    + $"\"{FuzzWorld.State}\"\n--layers depth --layers-format npy\n", path => [["@" + path, .. Output(path)]]),
        ]);

    public IFuzzTarget ConfigFiles => new FileTarget(
        "config files",
        [
            FuzzInput.Text(
                "a.yaml", $"{Settings}\nldem: {world.Model}\nkernels: {world.Kernels}\n", path => ConfigCalls(path, ["--config", path])),
            new FuzzInput(
                "settings/msisf/config.yaml",
                folder =>
                {
                    Directory.CreateDirectory(Path.Combine(folder, "settings", "msisf"));
                    return System.Text.Encoding.UTF8.GetBytes($"{Settings}\nldem: {world.Model}\nkernels: {world.Kernels}\n");
                },
                path => ConfigCalls(path, [])),
        ]);

    public IFuzzTarget Kernels => new FileTarget(
        "kernels",
        [.. Directory.EnumerateFiles(Path.GetDirectoryName(world.Kernels)!).Order(StringComparer.Ordinal).Select(
            kernel => FuzzInput.Among(kernel, KernelCalls))]);

    public IFuzzTarget Manifests => new FileTarget(
        "manifests",
        [
            FuzzInput.Among(
                Path.Combine(world.OutputFolder, "msisf-manifest.jsonl"),
                path =>
                [
                    ["status", FolderOf(path)],
                    ["status", FolderOf(path), "--print-frames"],
                    ["verify", FolderOf(path)],
                    ["verify", "--print-frames", FolderOf(path)],
                    [.. world.Render, "--times", "{51544.5,51544.51,51544.52}", "--output-dir", FolderOf(path)],
                ],
                place: File.Copy), // a link is no output
        ]);

    private IEnumerable<IReadOnlyList<string>> ConfigCalls(string path, string[] config)
    {
        yield return ["config", "show", .. config];
        yield return ["--fixed-state", FuzzWorld.State, .. config, .. Output(path)];
        yield return [.. world.Sources, "--fixed-state", FuzzWorld.State, .. config, .. Output(path)];
        yield return [.. world.Sources, "--fixed-state", FuzzWorld.State, "--renderer", "povray", .. config, .. Output(path)];
    }

    private IEnumerable<IReadOnlyList<string>> KernelCalls(string path)
    {
        string metaKernel = Path.Combine(FolderOf(path), Path.GetFileName(world.Kernels));
        string[] call =
        [
            .. FuzzWorld.TinyImage, "--renderer", "native", "--reflectance", "lambert", "--res", "1", "--ldem", world.Model,
            "--ephemeris", "builtin", "--kernels", metaKernel, .. Output(path)
        ];
        yield return [.. call, "--fixed-state", FuzzWorld.State];
        yield return [.. call, "--fixed-state", FuzzWorld.State, "--aberration", "lt+s"];
        yield return [.. call, "--kepler-set", "{1.9E6,0,0,0,1,0}", "--epoch", "51544.5", "--time", "51545", "--orbit-frame", "j2000"];
    }

    /// <summary>A folder of the case's own, so that whatever is damaged, nothing is written elsewhere.</summary>
    private static string[] Output(string path) => ["--output-dir", Path.Combine(FolderOf(path), "out")];

    private static string FolderOf(string path) => Path.GetDirectoryName(path)!;
}
