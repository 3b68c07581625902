using System.Text.Json;
using Msisf.App.Settings;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Server.Tests;

/// <summary>
/// An image of a site as its albedo, in a map of the whole Moon: requests, and frames of served folders. While its maps lie where the
/// program looks for maps, no other test may run.
/// </summary>
[Collection(nameof(MapsOfTheProgram))]
public sealed class AlbedoSiteTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();
    private readonly string _unique = Guid.NewGuid().ToString("N")[..8].ToUpperInvariant();
    private readonly string[] _maps;

    public AlbedoSiteTests()
    {
        // The server knows the maps in input/albedo of the folder in which it runs.
        string moon = PdsMap.Write(_folder, $"WAC_EMP_643NM_{_unique}", "PC_REAL", 32, 1, (_, _) => 0.1);
        string site = PdsMap.Write(
            _folder, $"SITE_{_unique}", "PC_REAL", 32, 20, (x, y) => 50.0 + (((x / 20) + (y / 20)) % 2 * 40.0), west: 356.0, north: 4.0,
            degrees: (8, 8));
        Directory.CreateDirectory(Path.Combine("input", "albedo"));
        _maps = [.. new[] { moon, site }.Select(path => Path.Combine("input", "albedo", Path.GetFileName(path)))];
        File.Copy(moon, _maps[0]);
        File.Copy(site, _maps[1]);
    }

    public void Dispose()
    {
        Array.ForEach(_maps, File.Delete);
        _folder.Dispose();
    }

    [RequiresFact(Part.Ldem4)]
    public async Task RequestsAndFoldersWithASite_HaveTheBytesOfMsis()
    {
        (string moon, string site) = (Path.GetFileName(_maps[0]), $"{Path.GetFileName(_maps[1])},factor=auto");
        byte[] expected = Draw("site", "--albedo-map", _maps[0], "--albedo-map", $"{_maps[1]},factor=auto");
        byte[] without = Draw("moon", "--albedo-map", _maps[0]);
        using RunningServer server = await RunningServer.StartAsync((ViewOptions.Folders, _folder["site"]));

        string models = await server.Client.GetStringAsync("/v1/models");
        byte[] drawn = await server.RenderAsync($"{Frame}, \"albedo-map\": [\"{moon}\", \"{site}\"]");
        byte[] plain = await server.RenderAsync($"{Frame}, \"albedo-map\": \"{moon}\"");
        using JsonDocument folder = JsonDocument.Parse(await server.Client.GetStringAsync("/v1/folders/site"));
        JsonElement frame = folder.RootElement.GetProperty("frames")[0];
        string options = frame.GetProperty("options").GetRawText()[1..^1];
        byte[] again = await server.RenderAsync($"\"fixed-state\": {frame.GetProperty("state").GetRawText()}, {options}");

        Assert.Contains($"\"{Path.GetFileName(_maps[1])}\"", models, StringComparison.Ordinal);
        Assert.NotEqual(without, expected);
        Assert.Equal(without, plain);
        Assert.Equal(expected, drawn);
        Assert.Equal(expected, again);
        await server.DisposeAsync();
    }

    private const string Frame = """
        "fixed-state": [55289, 2.2e6, 0, 0, 0, 0, 0, 1], "width": 48, "height": 48, "fov": 20
        """;

    private byte[] Draw(string name, params string[] maps)
    {
        CommandLineRun run = CommandLineRun.Of(
        [
            "--renderer", "native", "--ldem", TestParts.Ldem4Label!, "--fixed-state", "{55289,2.2e6,0,0,0,0,0,1}", "--width", "48",
            "--height", "48", "--fov", "20", "--batch", .. maps, "--output-dir", _folder[name],
        ]);
        Assert.True(run.ExitCode == 0, run.Error);
        return File.ReadAllBytes(Path.Combine(_folder[name], "MoonSurfIllumSim_step_00001.png"));
    }
}

/// <summary>Tests that write where the program looks for maps.</summary>
[CollectionDefinition(nameof(MapsOfTheProgram), DisableParallelization = true)]
public sealed class MapsOfTheProgram
{
}
