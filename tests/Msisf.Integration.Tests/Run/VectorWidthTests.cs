using System.Collections.Concurrent;
using System.Globalization;
using Msisf.Core.Attitude;
using Msisf.Core.Numerics;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Run;

/// <summary>
/// The program in processes of its own, with the vectors that the machine has and with narrower ones: the files are the same to the byte.
/// </summary>
public sealed class VectorWidthTests : IDisposable
{
    /// <summary>m: over the north pole, with day, night and long shadows in the image.</summary>
    private static readonly Vector3D Position = new(1e5, 2e5, 1.9e6);

    /// <summary>The files of the vectors that the machine has, drawn once for all that is compared with them.</summary>
    private static readonly ConcurrentDictionary<bool, Lazy<byte[][]>> AsTheMachineHas = new();

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [RequiresTheory(Part.Ldem4, Part.CFitsio)]
    [InlineData("DOTNET_EnableAVX512", false)]
    [InlineData("DOTNET_EnableAVX2", false)]
    [InlineData("DOTNET_EnableAVX512", true)]
    public void Run_NarrowerVectors_WritesTheSameBytes(string switchOfTheRuntime, bool isShadedEarly)
    {
        string[] shading = isShadedEarly
            ? ["--shading", "facet", "--reflectance", "moon", "--albedo-map", Map()]
            : ["--shading", "smooth", "--reflectance", "hapke"];
        byte[][] asTheMachineHas = AsTheMachineHas.GetOrAdd(isShadedEarly, _ => new(() => Render("wide", shading, []))).Value;
        byte[][] narrower = Render("narrow", shading, new() { [switchOfTheRuntime] = "0" });

        Assert.Equal(["view.fits", "view.png", "view.xml"], Files("narrow").Select(Path.GetFileName));
        Assert.Equal(asTheMachineHas, narrower);
        Assert.Contains(PngPixels.Read(_folder["narrow/view.png"]).ChannelParts(0).Cast<double>(), grey => grey > 0.1);
    }

    private IEnumerable<string> Files(string folder) => Directory.EnumerateFiles(_folder[folder], "view.*").Order(StringComparer.Ordinal);

    /// <summary>A map whose values change from pixel to pixel.</summary>
    private string Map() => PdsMap.Write(
        _folder, "WAC_HAPKE_643NM", "PC_REAL", 32, 2, (column, row) => 0.02 + (0.0001 * (((37 * column) + (91 * row)) % 400)));

    private byte[][] Render(string folder, string[] shading, Dictionary<string, string> environment)
    {
        UnitQuaternion attitude = NadirPointing.MoonFromCamera(Position);
        string state = string.Create(
            CultureInfo.InvariantCulture,
            $"{{55289,{Position.X:R},{Position.Y:R},{Position.Z:R},{attitude.X:R},{attitude.Y:R},{attitude.Z:R},{attitude.W:R}}}");
        string[] arguments =
        [
            "--renderer", "native", "--fixed-state", state, "--width", "150", "--height", "120", "--samples", "4",
            .. shading, "--layers", "all", "--surface", "terrain", "--bit-depth", "16",
            "--ldem", TestParts.Ldem4Label!, "--ephemeris", "builtin", "--output-dir", _folder[folder], "--output-name", "view", "--batch",
        ];
        ChildRun.Of(TestedProgram.File, TestedProgram.Words(arguments), _folder.Path, environment: environment).Succeeded();
        return [.. Files(folder).Select(File.ReadAllBytes)];
    }
}
