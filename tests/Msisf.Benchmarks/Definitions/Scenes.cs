using Msisf.Core.Terrain;

namespace Msisf.Benchmarks.Definitions;

/// <summary>The measured scenes.</summary>
internal static class Scenes
{
    /// <summary>The name of the sequence, which is chosen like a scene.</summary>
    public const string Sequence = "sequence";

    /// <summary>The descent through nested models.</summary>
    public const string Descent = "descent";

    /// <summary>The name of the first image from nothing but the model's file.</summary>
    public const string FromNothing = "from-nothing";

    /// <summary>The name of <see cref="Msisf.Benchmarks.Measures.DetectorResult"/>.</summary>
    public const string Detector = "detector";

    private const string Quick = "quick";
    private const string QuickFrom = "far-4";
    private const int QuickSide = 256; // px
    private const double Megabyte = 1e6;

    /// <summary>Tiles of the thesis's way, where all would take too long: one takes half a second of parsing at 16 px/deg.</summary>
    private const int CoarseTiles = 16;

    /// <summary>
    /// The same at 64 px/deg, where one takes 6 s. At 128 px/deg one takes minutes, because POV-Ray's parser slows down with the size of a
    /// <c>mesh</c>: the thesis's way is not measured there.
    /// </summary>
    private const int FineTiles = 2;

    /// <summary>What a quick run measures.</summary>
    public static IReadOnlyList<string> QuickNames { get; } = [Quick, Sequence, Detector];

    /// <summary>All, with the targets of the project's plan for the native renderer's times.</summary>
    public static IReadOnlyList<Scene> All { get; } =
    [
        new()
        {
            Name = "far-4", About = "far, LDEM_4", Model = 4, State = Places.Far, Settings = Settings.All,
            Targets = new SceneTargets(0.15, 0.012, 90 * Megabyte, TimesFasterThanPovRay: 200.0, Sampled: new SampledTarget(0.4, 0.050)),
        },
        new() { Name = "far-16", About = "far, LDEM_16", Model = 16, State = Places.Far, Settings = Settings.Few },
        new()
        {
            Name = "far-64", About = "far, LDEM_64", Model = 64, State = Places.Far, IsExact = true,
            Settings = Settings.Antialiased, MaxThesisTiles = 4,
            Targets = new SceneTargets(0.28, 0.042, 230 * Megabyte, Sampled: new SampledTarget(1.1, 0.480)),
        },
        new()
        {
            Name = "far-512", About = "far, LDEM_512", Model = 512, State = Places.Far, HasTruth = false,
            Settings = [Settings.PovRayDefault, Settings.NativeDefault],
            Targets = new SceneTargets(0.6, 0.040, 700 * Megabyte),
        },
        new()
        {
            Name = "disc-16", About = "whole disc, LDEM_16", Model = 16, State = Places.Disc,
            Settings = Settings.Few, MaxThesisTiles = CoarseTiles,
        },
        new()
        {
            Name = "nadir-64", About = "100 km, nadir, LDEM_64", Model = 64, State = Places.LowNadir, Settings = Settings.All,
            Targets = new SceneTargets(0.18, 0.013, 110 * Megabyte, Sampled: new SampledTarget(0.4, 0.075)),
        },
        new()
        {
            Name = "nadir-128", About = "100 km, nadir, LDEM_128", Model = 128, State = Places.LowNadir,
            Settings = Settings.Own,
        },
        new()
        {
            Name = "oblique-64", About = "20 km, oblique, LDEM_64", Model = 64, State = Places.Oblique,
            Settings = Settings.Default, MaxThesisTiles = FineTiles,
            Targets = new SceneTargets(0.18, 0.015, 110 * Megabyte, Sampled: new SampledTarget(0.4, 0.075)),
        },
        new()
        {
            Name = "oblique-512", About = "20 km, oblique, LDEM_512", Model = 512, State = Places.Oblique,
            Targets = new SceneTargets(0.5, 0.045, 700 * Megabyte),
        },
        new()
        {
            Name = "pole-64", About = "100 km over the north pole, LDEM_64", Model = 64, State = Places.NorthPole,
            Targets = new SceneTargets(0.35, 0.065, 200 * Megabyte),
        },
        new()
        {
            Name = "polar-20m", About = "100 km over the south pole, LDEM_80S_20M", Model = PolarMap, State = Places.SouthPole,
            Targets = new SceneTargets(1.0, 0.060, 600 * Megabyte),
        },
        new()
        {
            Name = "polar-20m-low", About = "5 km over the south pole, oblique, LDEM_80S_20M", Model = PolarMap,
            State = Places.LowOverSouthPole, Targets = new SceneTargets(1.0, 0.060, 600 * Megabyte),
        },
        new()
        {
            Name = "north-16", About = "100 km over the north pole, LDEM_16", Model = 16, State = Places.NorthPole,
            Settings = Settings.Few, MaxThesisTiles = CoarseTiles,
        },
        new()
        {
            Name = "south-16", About = "100 km over the south pole, LDEM_16", Model = 16, State = Places.SouthPole,
            Settings = Settings.Few, MaxThesisTiles = CoarseTiles,
        },
        new()
        {
            Name = "prime-64", About = "100 km over the prime meridian, LDEM_64", Model = 64, State = Places.PrimeMeridian,
            Settings = Settings.Few, MaxThesisTiles = FineTiles,
        },
        Landing("landing-100km", "100 km", 100e3, Settings.Few),
        Landing("landing-5km", "5 km", 5e3, Settings.Few),
        Landing("landing-500m", "500 m", 500.0, Settings.Few),
    ];

    /// <summary>The map of the south pole to 80 degrees of latitude that benchmark.sh makes, 30,400 x 30,400 pixels.</summary>
    private static GridResolution PolarMap => GridResolution.FromMetresPerPixel(20.0);

    /// <summary>A scene by its name.</summary>
    /// <exception cref="BenchmarkException">There is none; the message has the names.</exception>
    public static Scene Named(string name) => name == Quick
        ? Named(QuickFrom) with { Name = Quick, Side = QuickSide, Settings = Settings.Few }
        : All.FirstOrDefault(scene => scene.Name == name)
            ?? throw new BenchmarkException(
                $"there is no scene {name}; there are {string.Join(", ", All.Select(scene => scene.Name))}, {FromNothing}, {Sequence}, "
                    + $"{Descent} and {Detector}.");

    private static Scene Landing(string name, string height, double altitude, IReadOnlyList<Setting> settings) => new()
    {
        Name = name,
        About = $"landing, {height}, LDEM_64",
        Model = 64,
        State = Places.Landing(altitude),
        Settings = settings,
        MaxThesisTiles = FineTiles,
    };
}
