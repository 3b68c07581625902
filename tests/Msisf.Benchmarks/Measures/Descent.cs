using System.Globalization;
using Msisf.Benchmarks.Definitions;
using Msisf.Benchmarks.Programs;

namespace Msisf.Benchmarks.Measures;

/// <summary>A descent in one process: from 100 km to 50 m over the south pole, through five maps one in another in LDEM_4.</summary>
/// <param name="bench">Has the model of the whole Moon; the maps are made in its folder.</param>
internal sealed class Descent(Workbench bench)
{
    private const double Highest = 100e3; // m
    private const double Lowest = 50.0;

    /// <summary>When the Sun stands 1.5 degrees high at the pole.</summary>
    private const string Time = "2026-01-10T00:00:00Z";

    /// <summary>The maps: metres a pixel, and the latitude that they reach to. The last one is 1.2 km wide.</summary>
    private static readonly (string Scale, string Latitude)[] Maps =
        [("500", "80"), ("100", "87.5"), ("20", "89.5"), ("5", "89.9"), ("1", "89.98")];

    /// <summary>Images and meta files.</summary>
    /// <param name="frames">Number of frames; heights fall by the same factor from one to the next.</param>
    public SequenceResult Run(int frames)
    {
        string folder = Path.Combine(bench.Folder, "descent");
        Workbench.Delete(folder);
        string[] models = [bench.LabelOf(4), .. Maps.Select(map => Synthesized(folder, map.Scale, map.Latitude))];
        string batch = Path.Combine(folder, "descent.csv");
        File.WriteAllLines(batch, ["time,lat,lon,height,off_nadir", .. Enumerable.Range(0, frames).Select(frame => string.Create(
            CultureInfo.InvariantCulture,
            $"{Time},-89.998,26,terrain+{Highest * Math.Pow(Lowest / Highest, frame / (frames - 1.0)):F3},0"))]);
        string output = bench.NewOutputFolder();
        string side = Scene.DefaultSide.ToString(CultureInfo.InvariantCulture);
        ProgramRun run = bench.Msis.Run(
            [
                "--renderer", "native", "--reflectance", "lambert", "--batch-file", batch, "--width", side, "--height", side,
                "--fov", Scene.FieldOfViewDegrees.ToString("R", CultureInfo.InvariantCulture),
                .. models.SelectMany(model => (string[])["--ldem", model]),
                "--output-dir", output, "--batch", "--timing", "--overwrite",
            ],
            watch: MemoryWatch.Own);
        long bytes = new DirectoryInfo(output).EnumerateFiles().Sum(file => file.Length);
        Workbench.Delete(output); // gigabytes
        return new SequenceResult(frames, run, bytes);
    }

    private string Synthesized(string folder, string scale, string latitude) => bench.Msis.Run(
        [
            "ldem", "synthesize", "--projection", "polar-south", "--map-scale", scale, "--latitude", latitude, "--seed", "1",
            "--output-dir", Directory.CreateDirectory(folder).FullName, "--batch",
        ]).Output[^1].Line;
}
