using Msisf.Adapters.Raster.Heights;
using Msisf.Adapters.Synthesis;
using Msisf.Adapters.Tests.Ephemeris;
using Msisf.Core.Terrain;
using Msisf.Core.Tiles;
using Msisf.TestSupport;

namespace Msisf.Stress.Fuzz;

/// <summary>Right and tiny inputs that the cases share or damage copies of. Immutable once made.</summary>
internal sealed class FuzzWorld : IDisposable
{
    /// <summary>One pixel, so that a case is all reading and checking.</summary>
    public static readonly string[] TinyImage = ["--width", "1", "--height", "1", "--fov", "20", "--batch"];

    /// <summary>A state above the ground, looking down; the kernels cover it.</summary>
    public const string State = "{51544.5,1.9E6,0,0,0,0,0,1}";

    private const double Day = 86400.0;

    private readonly DirectoryInfo _folder;

    /// <summary>Makes all of it.</summary>
    /// <param name="parent">Existing folder.</param>
    public FuzzWorld(string parent)
    {
        _folder = Directory.CreateDirectory(Path.Combine(parent, "world"));
        Model = Synthesize(1, "whole", MoonRegion.WholeMoon);
        FineModel = Synthesize(4, "fine", MoonRegion.WholeMoon);
        Synthesize(1, "split", new MoonRegion(-90, 0, 0, 360));
        SplitModel = Synthesize(1, "split", new MoonRegion(0, 90, 0, 360));
        PolarMap = SyntheticMapWriter.Write(
            new SyntheticMapOptions(true, 10_000.0, 80.0, 1, Path.Combine(_folder.FullName, "polar")),
            progress: null,
            CancellationToken.None);
        Kernels = WriteKernels();
        Succeed("ldem", "pyramid", FineModel);
        OutputFolder = Path.Combine(_folder.FullName, "output");
        Succeed([.. Render, "--times", "{51544.5,51544.51,51544.52}", "--output-dir", OutputFolder]);
    }

    /// <summary>Label of a model at 1 px/deg.</summary>
    public string Model { get; }

    /// <summary>Label of a model at 4 px/deg, with a pyramid beside it.</summary>
    public string FineModel { get; }

    /// <summary>Label of the northern half of a model at 1 px/deg, the southern beside it.</summary>
    public string SplitModel { get; }

    /// <summary>Label of a polar map of 10 km a pixel.</summary>
    public string PolarMap { get; }

    /// <summary>Meta-kernel; beside it the small kernels that it names.</summary>
    public string Kernels { get; }

    /// <summary>A run of three frames, complete.</summary>
    public string OutputFolder { get; }

    /// <summary>The options of every image, but for where the camera is and where it goes.</summary>
    public string[] Sources =>
        [.. TinyImage, "--renderer", "native", "--reflectance", "lambert", "--res", "1", "--ldem", Model, "--kernels", Kernels,
            "--ephemeris", "builtin"];

    /// <summary>The run of <see cref="OutputFolder"/>, but for its times and folder.</summary>
    public string[] Render => [.. Sources, "--kepler-set", "{1.9E6,0,0,0,1,0}", "--epoch", "51544.5"];

    public void Dispose() => _folder.Delete(recursive: true);

    private string Synthesize(int pixelsPerDegree, string name, MoonRegion region) =>
        SyntheticLdemWriter.Write(
            new SyntheticLdemOptions(pixelsPerDegree, 1, Path.Combine(_folder.FullName, name))
            {
                Region = region,
                Rest = SyntheticRest.None,
            },
            progress: null,
            CancellationToken.None);

    private string WriteKernels()
    {
        string folder = Directory.CreateDirectory(Path.Combine(_folder.FullName, "kernels")).FullName;
        foreach (string name in (string[])["naif0012.tls", "moon_080317.tf", "moon_assoc_me.tf"])
        {
            File.Copy(Path.Combine(TestParts.Kernels, name), Path.Combine(folder, name));
        }

        DafBuilder positions = new("DAF/SPK");
        positions.AddSpk(
            10, 0, -30_000 * Day, 60_000 * Day, 2, [1.5e8, 1e6, 1e6]).AddSpk(301, 0, -30_000 * Day, 60_000 * Day, 2, [0.0, 0.0, 0.0]);
        File.WriteAllBytes(Path.Combine(folder, "tiny.bsp"), positions.ToArray());
        File.WriteAllBytes(
            Path.Combine(folder, "tiny.bpc"),
            new DafBuilder("DAF/PCK").AddPck(31006, -30_000 * Day, 60_000 * Day, [0.1, 0.2, 0.3]).ToArray());
        string metaKernel = Path.Combine(folder, "tiny.tm");
        File.WriteAllText(
            metaKernel,
            "KPL/MK\n\\begindata\nKERNELS_TO_LOAD = ( 'naif0012.tls'\n 'moon_080317.tf' 'moon_assoc_me.tf'\n 'tiny.bpc' 'tiny.bsp' "
                + ")\n\\begintext\n");
        return metaKernel;
    }

    private static void Succeed(params string[] arguments)
    {
        CommandLineRun run = CommandLineRun.Of(arguments);
        if (run.ExitCode != 0)
        {
            throw new InvalidOperationException($"msis {string.Join(' ', arguments)}: {run.Error}");
        }
    }
}
