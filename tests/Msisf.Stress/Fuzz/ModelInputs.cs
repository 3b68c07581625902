using System.Text;
using Msisf.Adapters.Raster.Heights;

namespace Msisf.Stress.Fuzz;

/// <summary>Elevation models: labels, images, and the files that the program keeps beside them.</summary>
/// <param name="world">The right ones.</param>
internal sealed class ModelInputs(FuzzWorld world)
{
    public IFuzzTarget Labels => new FileTarget(
        "labels",
        [
            FuzzInput.Among(world.Model, path => Calls(path, 1)),
            FuzzInput.Among(world.SplitModel, path => Calls(path, 1)),
            FuzzInput.Among(world.PolarMap, CallsOfMap),
            new FuzzInput("ATTACHED.IMG", _ => Attached(), path => Calls(path, 1)),
        ]);

    public IFuzzTarget Images => new FileTarget(
        "images",
        [
            FuzzInput.Among(Path.ChangeExtension(world.Model, ".IMG"), path => Calls(path, 1)),
            FuzzInput.Among(Path.ChangeExtension(world.SplitModel, ".IMG"), path => Calls(path, 1)),
            FuzzInput.Among(Path.ChangeExtension(world.PolarMap, ".IMG"), CallsOfMap),
        ]);

    public static IFuzzTarget GeoTiffs => new FileTarget(
        "GeoTIFFs", [new FuzzInput("map.tif", _ => TinyGeoTiff.Bytes(), CallsOfMap)]);

    public IFuzzTarget Pyramids => new FileTarget(
        "pyramids",
        [
            FuzzInput.Among(
                Path.ChangeExtension(world.FineModel, ".pyramid"),
                path => [.. Calls(LabelBeside(path), 4), ["ldem", "pyramid", "--verify", LabelBeside(path)]]),
        ]);

    private static IEnumerable<IReadOnlyList<string>> Calls(string model, int resolution)
    {
        string[] source = ["--ldem", model, "--res", resolution.ToString(
            System.Globalization.CultureInfo.InvariantCulture), "--ignore-sun", "--fixed-state", FuzzWorld.State];
        yield return [.. FuzzWorld.TinyImage, "--renderer", "native", "--reflectance", "lambert", .. source, "--output-dir", Path.Combine(
            Path.GetDirectoryName(model)!, "out")];
        yield return ListPatterns(model, resolution);
    }

    private static IEnumerable<IReadOnlyList<string>> CallsOfMap(string map)
    {
        yield return [.. FuzzWorld.TinyImage, "--renderer", "native", "--reflectance", "lambert", "--ldem", map, "--ignore-sun",
            "--fixed-state", "{51544.5,0,0,-1.9E6,0,0.7071067811865476,0,0.7071067811865476}", "--output-dir",
            Path.Combine(Path.GetDirectoryName(map)!, "out")];
    }

    private static string[] ListPatterns(string model, int resolution) =>
    [
        .. FuzzWorld.TinyImage, "--list-patterns", "--ignore-sun", "--fixed-state", FuzzWorld.State, "--ldem", model,
        "--res", resolution.ToString(System.Globalization.CultureInfo.InvariantCulture),
    ];

    private static string LabelBeside(string path) => Path.ChangeExtension(path, ".LBL");

    /// <summary>The label before the samples, in one file.</summary>
    private byte[] Attached()
    {
        const int Records = 12;
        byte[] image = File.ReadAllBytes(Path.ChangeExtension(world.Model, ".IMG"));
        string label = File.ReadAllText(world.Model);
        int pointer = label.IndexOf("^IMAGE ", StringComparison.Ordinal);
        int pointerEnd = label.IndexOf('\n', pointer);
        label = label[..pointer] + FormattableString.Invariant($"^IMAGE = {Records + 1}") + label[pointerEnd..];
        label = label.Replace(
            "FILE_RECORDS              = 180", FormattableString.Invariant($"FILE_RECORDS = {180 + Records}"), StringComparison.Ordinal);
        return [.. Encoding.ASCII.GetBytes(label.PadRight(Records * 720)), .. image];
    }
}
