using Msisf.App.Settings.Specs;

namespace Msisf.App.Settings;

/// <summary>All commands of the program with their options: the one place where they are declared.</summary>
internal static class CommandTable
{
    private static OptionGroup General => new("General", [RunOptions.Config, RunOptions.Help]);

    private static OptionGroup OnlyHelp => General with { Options = [RunOptions.Help] };

    private static OptionGroup Progress => General with { Options = [RunOptions.Batch, .. General.Options] };

    private static OptionGroup[] OfRender =>
    [
        CameraOptions.Group, ImageOptions.Group, LightOptions.Group, SurfaceOptions.Group, AlbedoOptions.Group, OutputOptions.Group,
        RendererOptions.Group, NativeOptions.Group, NavigationOptions.Group, SkyOptions.Group, PovOptions.Group, RunOptions.Group,
    ];

    public static IEnumerable<OptionSpec> OptionsOfRun => OfRender.SelectMany(group => group.Options);

    /// <summary>The options that a request to the server may have. It names no file, only the server's maps by their names.</summary>
    public static IEnumerable<OptionSpec> OptionsOfRequest => OptionsOfRun.Where(
        option => option.Role is DecidesBytes { IsOfRequests: true } && !option.IsOfOneCall
            && (option is not PathSpec || option == AlbedoOptions.Map || option == NativeOptions.HapkeMap
                || NavigationOptions.Lists.Contains(option)));

    public static CommandSpec Patterns { get; } = new("patterns", "Make surface patterns for POV-Ray ahead of a run.")
    {
        Details =
            "Makes all 2,592 patterns of an elevation model, or exactly those that the images of a run need. "
                + "Patterns that are there and complete are kept. The folder is printed.",
        Examples =
        [
            ("All patterns of the model with 4 pixels a degree:", "msis patterns --res 4"),
            ("What a batch file needs:", "msis patterns --for-batch approach.tab --res 64"),
        ],
        MakeGroups = () => [PatternsOptions.Model, PatternsOptions.WholeMoon, PatternsOptions.OfRun, Progress],
    };

    public static CommandSpec Status { get; } = new("status", "Say which images of a run are there, missing or damaged.")
    {
        Details =
            "Looks at the length of each file. A line for each image that is not complete (step, name, state, reason; "
                + "separated by tabs), then a summary; exit code 0 if all are well, otherwise 5.",
        MakeArgument = () => FolderOptions.Folder,
        MakeGroups = () => [General with { Options = [FolderOptions.PrintFrames, .. General.Options] }],
    };

    public static CommandSpec Verify { get; } = Status with
    {
        Name = "verify",
        Summary = "The same by reading every file.",
        Details = "As msis status, but checks every file: checksums, images whole, meta files valid.",
    };

    public static CommandSpec Merge { get; } = new("merge", "Order a run's manifest, join folders; make a contact sheet and a video.")
    {
        Details =
            "Puts the manifest into the order of the steps, whichever process made the images. With --to it first copies the images of "
                + "several folders into one, each of which was made by another machine. Exit code 5 if images are not complete.",
        MakeArgument = () => FolderOptions.Folders,
        Examples =
        [
            ("A video with 30 images a second:", "msis merge orbit --video 30"),
            ("The two halves of a run, from two machines:", "msis merge first second --to orbit"),
        ],
        MakeGroups = () =>
            [General with { Options = [FolderOptions.To, FolderOptions.ContactSheet, FolderOptions.Video, .. General.Options] }],
    };

    public static CommandSpec BatchConvert { get; } = new("batchconvert", "Turn a run into a script that makes it in pieces.")
    {
        Details = "Takes all options of a run. The pieces can be made one after another, side by side, or on many computers.",
        Examples =
        [
            ("Ten pieces for GNU parallel:", "msis batchconvert --format parallel --pieces 10 --batch-file approach.tab"),
        ],
        MakeGroups = () =>
        [
            new OptionGroup("Pieces", [ScriptOptions.Format, CutOptions.Pieces, CutOptions.FramesPerPiece, ScriptOptions.Script]),
            SlurmOptions.Group, .. OfRender, OnlyHelp
        ],
    };

    public static CommandSpec Submit { get; } = new("submit", "Give a run to Slurm in pieces, and make again what goes missing.")
    {
        Details = "Takes all options of a run. The script is that of msis batchconvert --format slurm, in the folder of the outputs.",
        Examples = [("Forty pieces, followed to their end:", "msis submit --pieces 40 --wait --batch-file approach.tab")],
        MakeGroups = () => [new OptionGroup(
            "Pieces", [CutOptions.Pieces, CutOptions.FramesPerPiece, ScriptOptions.Wait]), SlurmOptions.Group, .. OfRender, OnlyHelp],
    };

    public static CommandSpec States { get; } = new("states", "Write the states of a run for other programs, without drawing.")
    {
        Details =
            "Takes all options of a run. A table goes to a file or is printed; formats of several files go into a folder, whose files are "
                + "printed. Each file names its frame, its units and the order of its quaternion. docs/missions.md says what each holds.",
        Examples =
        [
            ("A trajectory as SPICE kernels:", "msis states --format spice --to kernels --batch-file approach.tab"),
            ("Ground truth for odometry:", "msis states --format tum --to truth.txt --oem orbit.oem --every 10"),
        ],
        MakeGroups = () => [new OptionGroup("States", [StatesOptions.Format, StatesOptions.To]), .. OfRender, OnlyHelp],
    };

    public static CommandSpec Synthesize { get; } = new(
        "synthesize", "Write a synthetic elevation model, with craters and roughness like the Moon's.")
    {
        Examples = [(
            "A model with 64 pixels a degree that continues one with 4:",
            "msis ldem synthesize --res 64 --base input/ldem/LDEM_4.LBL --seed 1"),
            (
            "A map of the south pole, 80 m a pixel, to 80 degrees of latitude:",
            "msis ldem synthesize --projection polar-south --map-scale 80 --base input/ldem/LDEM_4.LBL --seed 1")],
        MakeGroups = () => [new OptionGroup(
            "The new model",
            [
                ModelOptions.NewResolution, ModelOptions.Seed, ModelOptions.NewBody, ModelOptions.Base, ModelOptions.Region,
                ModelOptions.Rest, ModelOptions.Projection, ModelOptions.MapScale, ModelOptions.Latitude, ModelOptions.SampleType,
                ModelOptions.NewFolder,
            ]), Progress],
    };

    public static CommandSpec Pyramid { get; } = new("pyramid", "Write a model's coarser levels into a file beside it.")
    {
        Details = "Far views of fine models then need not read the whole model. For a large map that GDAL reads, bounds and "
            + "one coarser level are kept, which otherwise the first run with it finds.",
        MakeArgument = () => ModelOptions.Model,
        Examples =
        [
            ("The levels of one model:", "msis ldem pyramid input/ldem/LDEM_64.LBL"),
            ("What the first run with a large map would look for:", "msis ldem pyramid site.tif"),
        ],
        MakeGroups = () => [new OptionGroup("The model", [ModelOptions.ModelResolution, ModelOptions.Verify]), Progress],
    };

    public static CommandSpec Ldem { get; } = new("ldem", "Make elevation models and their levels of detail.")
    {
        MakeGroups = () => [OnlyHelp],
        Commands = [Synthesize, Pyramid],
    };

    public static CommandSpec ConfigShow { get; } = new(
        "show", "Print each key of configuration files, its value and where that comes from.")
    {
        Details = "A line for each key (key, value, file and line or 'default'; separated by tabs).",
        MakeGroups = () => [General],
    };

    public static CommandSpec Config { get; } = new("config", "Show the settings of configuration files.")
    {
        MakeGroups = () => [OnlyHelp],
        Commands = [ConfigShow],
    };

    public static CommandSpec Cameras { get; } = new("cameras", "List the presets of --camera.")
    {
        Details =
            "A line for each preset (name, width and height in px, horizontal field of view in degrees, what it is; separated by tabs). "
                + "Their files are in the folder cameras; docs/cameras.md says what a camera file holds.",
        MakeGroups = () => [OnlyHelp],
    };

    public static CommandSpec Kernels { get; } = new("kernels", "List what SPICE kernels hold: objects, times, types, frames, byte order.")
    {
        Details =
            "A line for each segment of SPK, CK and binary PCK, and for each text kernel. Times are UTC, by the installed leap seconds. "
                + "Those of a CK need the spacecraft's clock (SCLK) among the kernels; frames are named where a frame kernel is.",
        MakeArgument = () => new ArgumentSpec("FILE", "Kernels and meta-kernels")
        {
            TakesSeveralWords = true,
        },
        Examples = [("When LRO's attitude is known:", "msis kernels moc42r_2009181_2009213_v14.bc lro_clkcor_2019239_v00.tsc")],
        MakeGroups = () => [new OptionGroup("Output", [TableOptions.Format]), OnlyHelp],
    };

    public static CommandSpec Places { get; } = new("places", "List the Moon's named places: features of the IAU's list and landing sites.")
    {
        Details =
            "A line for each place: name, kind, latitude, longitude (degrees, east), diameter. NAME leaves those whose names hold it; "
                + "case, accents and punctuation do not matter. --look-at, --position, --center and batch files take these names.",
        MakeArgument = () => new ArgumentSpec("NAME", "A name, or a part of one")
        {
            IsOptional = true,
            TakesSeveralWords = true,
        },
        Examples =
        [
            ("Where Tycho is, and its lettered craters:", "msis places tycho"),
            ("What lies around a place:", "msis places --near=-43.3,348.8"),
        ],
        MakeGroups = () => [new OptionGroup("Output", [PlacesOptions.Near, TableOptions.Format]), OnlyHelp],
    };

    public static CommandSpec Serve { get; } = new("serve", "Draw images on request over HTTP and WebSocket, for closed loops.")
    {
        Details =
            "Prints the address on which it listens, and runs until it gets a signal. Images are drawn as by msis --renderer native with "
                + "the same options. docs/server.md says what a request holds.",
        Examples =
        [
            ("On this computer, at any free port:", "msis serve --listen 127.0.0.1:0"),
            ("For other computers:", "msis serve --listen 0.0.0.0:8810 --token-file token --tls-certificate cert.pem --tls-key key.pem"),
        ],
        MakeGroups = () =>
            [
                ServeOptions.Group, new OptionGroup("Files", [SurfaceOptions.Ldem, LightOptions.Kernels]), ViewOptions.OfServe,
                ServeOptions.OfBasilisk, ServeOptions.OfClients, General,
            ],
    };

    public static CommandSpec View { get; } = new("view", "Look at the Moon in the browser: fly, move the Sun, read what each pixel shows.")
    {
        Details =
            "Starts msis serve at a free port of this computer and opens its page; prints the address. Runs until it gets a signal. "
                + "docs/viewer.md shows the page.",
        MakeArgument = () => ViewOptions.Opened,
        Examples =
        [
            ("Look around:", "msis view"),
            ("The frames of a finished run, with the names of craters:", "msis view output --catalogues craters.csv"),
        ],
        MakeGroups = () =>
            [ViewOptions.OfView, ServeOptions.Group, new OptionGroup("Files", [SurfaceOptions.Ldem, LightOptions.Kernels]), General],
    };

    public static CommandSpec Completion { get; } = new("completion", "Print a script that completes commands, options and values.")
    {
        MakeArgument = () => new ArgumentSpec("SHELL", "The shell: bash, zsh or fish") { Words = ["bash", "zsh", "fish"] },
        Examples =
        [
            ("For this bash, or in ~/.bashrc:", "source <(msis completion bash)"),
            ("For zsh, in ~/.zshrc after compinit:", "source <(msis completion zsh)"),
            ("For fish:", "msis completion fish > ~/.config/fish/completions/msis.fish"),
        ],
        MakeGroups = () => [General],
    };

    public static CommandSpec Man { get; } = new("man", "Print the manual page.")
    {
        Examples = [("Read it:", "msis man | man -l -")],
        MakeGroups = () => [General],
    };

    public static CommandSpec Help { get; } = new("help", "Show the help of msis, of a command or of a topic.")
    {
        Details = "The same as --help behind the command. Topics are camera, light, elevation, renderer, outputs, missions and series; all "
            + "stands for all options.",
        MakeArgument = () => CommandWords,
        Examples = [("What msis patterns takes:", "msis help patterns")],
        MakeGroups = () => [OnlyHelp],
    };

    /// <summary>msis itself, which renders; the root of all commands.</summary>
    public static CommandSpec Render { get; } = new("msis", "Draws exact synthetic images of the Moon from LOLA elevation data.")
    {
        Details =
            "Beside each image a meta file says for a grid of pixels which point of the surface it shows and from where the light comes. "
                + "The paths of the files are printed.",
        Examples =
        [
            ("Tycho, as a camera over it would take it:", "msis --look photo --position=Tycho,200000 --time 2010-04-24T00:00:00Z"),
            ("From 90 km, with the truth of each pixel:", "msis --look truth --position=Tycho,90000 --time 55310 --layers all"),
            ("Five images along an orbit:", "msis --look photo --kepler-set '{1.9E6,0.05,0.7,1.1,0.9,2.0}' --epoch 55289 "
                + "--time-interval '[55289:0.01:55289.04]'"),
            ("What the images of a batch file would show, without drawing:", "msis --batch-file approach.tab --dry-run"),
            ("The same images in two pieces, by a script:", "msis batchconvert --format sh --pieces 2 --batch-file approach.tab"),
            ("Where places are:", "msis places tycho"),
        ],
        MakeGroups = () =>
        [
            .. OfRender[..^1],
            RunOptions.Group with
            {
                Options = [.. RunOptions.Group.Options, DryRunOptions.DryRun, DryRunOptions.Format, RunOptions.Help, RunOptions.Version],
            }
        ],
        Commands =
        [
            Patterns, BatchConvert, Submit, States, CameraModelOptions.Command, TwinOptions.Command, DataSetOptions.Command,
            IlluminationOptions.Command, Status, Verify, Merge, FetchOptions.Command, Ldem, Serve, View, Cameras, Kernels, Places, Config,
            Completion, Man, Help,
        ],
    };

    /// <summary>All commands, each with the words by which it is called, e.g. "ldem pyramid"; none for the render command.</summary>
    public static IEnumerable<(string Path, CommandSpec Command)> All => Below(string.Empty, Render);

    private static ArgumentSpec CommandWords => new("COMMAND", "The command, e.g. ldem pyramid, or the topic")
    {
        IsOptional = true,
        TakesSeveralWords = true,
        Words = [.. Render.Commands.Select(command => command.Name)],
    };

    private static IEnumerable<(string Path, CommandSpec Command)> Below(string path, CommandSpec command) =>
        command.Commands.SelectMany(inner => Below($"{path} {inner.Name}".TrimStart(), inner)).Prepend((path, command));
}
