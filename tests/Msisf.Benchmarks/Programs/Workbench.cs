using System.Globalization;
using Msisf.Adapters.Raster.Heights;
using Msisf.Benchmarks.Definitions;
using Msisf.Core.Terrain;

namespace Msisf.Benchmarks.Programs;

/// <summary>Where the benchmark finds what it needs and leaves what it makes.</summary>
internal sealed class Workbench
{
    private readonly Dictionary<GridResolution, LdemSet> _models;

    /// <summary>Reads the labels of the models.</summary>
    /// <param name="root">The repository's folder.</param>
    /// <param name="folder">The folder of the benchmark's own files.</param>
    /// <param name="labels">Labels of the elevation models, one for each resolution.</param>
    public Workbench(string root, string folder, IEnumerable<string> labels)
    {
        Root = Path.GetFullPath(root);
        Folder = Path.GetFullPath(folder);
        _models = labels.Select(Path.GetFullPath).Select(label => LdemCatalog.TryReadMap(label) is { Polar: { } polar } map
            ? (polar.Resolution, Set: LdemSet.OfMap(map))
            : ((GridResolution)LdemCatalog.Read(label).PixelsPerDegree, Set: LdemCatalog.Read(label))).ToDictionary(
                model => model.Item1, model => model.Set);
        Msis = new ChildProgram(Path.Combine(Root, "msis"), Root);
    }

    /// <summary>The repository's folder.</summary>
    public string Root { get; }

    /// <summary>Models, patterns and tables.</summary>
    public string Folder { get; }

    /// <summary>The program as users start it.</summary>
    public ChildProgram Msis { get; }

    /// <summary>Patterns of one way to make one image, so that what they amount to can be counted.</summary>
    public string PatternsOf(Scene scene, Setting setting) => Path.Combine(Folder, "patterns", scene.Name, setting.FolderName);

    /// <summary>The images; an empty folder for each measurement.</summary>
    public string NewOutputFolder()
    {
        string folder = Path.Combine(Folder, "output");
        Delete(folder);
        Directory.CreateDirectory(folder);
        return folder;
    }

    /// <summary>Removes a folder, if it is there.</summary>
    public static void Delete(string folder)
    {
        if (Directory.Exists(folder))
        {
            Directory.Delete(folder, recursive: true);
        }
    }

    public LdemSet Model(GridResolution resolution) => _models.TryGetValue(resolution, out LdemSet? model)
        ? model
        : throw new BenchmarkException($"no --model with {resolution} is given.");

    /// <summary>The label of a model, for <c>--ldem</c>; of a split one any part's.</summary>
    public string LabelOf(GridResolution resolution) => Model(resolution).Parts[0].LabelPath;

    /// <summary>The options of msis that all runs share.</summary>
    public IReadOnlyList<string> ImageOptions(GridResolution resolution, string outputFolder, int side = Scene.DefaultSide) =>
        ImageOptions(resolution, LabelOf(resolution), outputFolder, side);

    /// <summary>The same with another label of the model.</summary>
    public static IReadOnlyList<string> ImageOptions(
        GridResolution resolution, string label, string outputFolder, int side = Scene.DefaultSide)
    {
        string pixels = side.ToString(CultureInfo.InvariantCulture);
        return
        [
            "--width", pixels, "--height", pixels,
            "--fov", Scene.FieldOfViewDegrees.ToString("R", CultureInfo.InvariantCulture),
            .. resolution.PixelsPerDegree is null ? (string[])[] : ["--res", resolution.NumberText],
            "--ldem", label,
            "--output-dir", outputFolder,
            "--batch", "--timing", "--overwrite",
        ];
    }
}
