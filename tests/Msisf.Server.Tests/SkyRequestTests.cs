using System.Net;
using System.Text;
using System.Text.Json;
using Msisf.App.Settings;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Server.Tests;

/// <summary>Requests with the sky have the answers that msis writes.</summary>
public sealed class SkyRequestTests(RunningServer server) : IClassFixture<RunningServer>
{
    private const string State = "\"position\": [5, 125, 400000], \"look-at\": \"horizon:274\", \"time\": 55292.85";

    private const string Frame = $"{State}, \"width\": 120, \"height\": 90";

    private const string Detector = """
        "camera": {"width": 120, "height": 90, "focal-length": 16, "pixel-pitch": 0.036, "detector": {"f-number": 1.4, "band": [420, 700],
        "transmission": 0.8, "quantum-efficiency": 0.5, "exposure-time": 0.4, "psf": "gaussian", "psf-sigma": 0.7, "gain": 4,
        "adc-bits": 12, "fits": "no"}}
        """;

    private static readonly string[] CommandLine =
    [
        "--position", "5,125,400000", "--look-at", "horizon:274", "--time", "55292.85", "--width", "120", "--height", "90", "--renderer",
        "native", "--batch",
    ];

    [RequiresTheory(Part.Ldem4)]
    [InlineData("\"stars\": true, \"star-limit\": 5, \"earth\": true", "--stars", "--star-limit", "5", "--earth")]
    [InlineData("\"sky\": true, \"earthshine\": true", "--sky", "--earthshine")]
    [InlineData("\"stars\": \"bright\", \"planets\": false", "--stars", "bright")]
    public async Task Answer_HasTheBytesOf_Msis(string options, params string[] words)
    {
        using TemporaryFolder folder = new();
        CommandLineRun run = CommandLineRun.Of(
            [.. CommandLine, .. words, "--fov", "60", "--output-dir", folder.Path, "--ldem", TestParts.Ldem4Label!]);
        Assert.True(run.ExitCode == 0, run.Error);
        string[] png = Directory.GetFiles(folder.Path, "*_00001.png");

        Assert.Equal(
            File.ReadAllText(Path.ChangeExtension(png[0], "xml")),
            Encoding.UTF8.GetString(await server.RenderAsync($"{Frame}, \"fov\": 60, {options}", "application/xml")));
        Assert.Equal(
            File.ReadAllBytes(Assert.Single(png)), await server.RenderAsync($"{Frame}, \"fov\": 60, {options}", "image/png"));
    }

    /// <summary>Stars and bodies are lists in JSON, with numbers as numbers; names stay texts.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task Json_ListsStarsAndBodies()
    {
        const string frame = $"{State}, {Detector}, \"sky\": true";

        using JsonDocument json = JsonDocument.Parse(await server.RenderAsync(frame, "application/json"));

        JsonElement[] stars = [.. json.RootElement.GetProperty("StarInformation").GetProperty("Star").EnumerateArray()];
        JsonElement earth = json.RootElement.GetProperty("SkyBodyInformation").GetProperty("SkyBody").EnumerateArray()
            .Single(body => body.GetProperty("name").GetString() == "Earth");
        Assert.True(stars.Length > 20, $"{stars.Length}");
        Assert.All(stars, star => Assert.StartsWith("HIP", star.GetProperty("id").GetString(), StringComparison.Ordinal));
        Assert.All(stars, star => Assert.Equal(3, star.GetProperty("hByTurn").GetArrayLength()));
        Assert.Contains(stars, star => star.GetProperty("visible").GetString() == "yes" && star.GetProperty("electrons").GetDouble() > 1e3);
        Assert.True(earth.GetProperty("electrons").GetDouble() > 1e8);
        byte[] with = await server.RenderAsync(frame, "application/octet-stream");
        byte[] without = await server.RenderAsync(
            frame.Replace("\"sky\": true", "\"sky\": false", StringComparison.Ordinal), "application/octet-stream");
        Assert.NotEqual(without, with);
    }

    /// <summary>A catalogue is named as the server's others are.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task Catalogue_IsOneOfTheServers()
    {
        using TemporaryFolder folder = new();
        string list = folder.Write("near.csv", "id,ra_deg,dec_deg,v_mag\nanywhere,12.5,3.25,2.0\n");
        using RunningServer own = await RunningServer.StartAsync((ViewOptions.Catalogues, $"near={list}"));
        const string Behind = $"{State}, \"width\": 20, \"height\": 20";

        string known = Encoding.UTF8.GetString(await own.RenderAsync($"{Behind}, \"fov\": 170, \"stars\": \"near\"", "application/xml"));
        using HttpResponseMessage unknown = await own.PostAsync("/v1/render", $"{{{Behind}, \"stars\": \"far\"}}");

        Assert.Contains("near.csv", known, StringComparison.Ordinal);
        Assert.Equal(HttpStatusCode.BadRequest, unknown.StatusCode);
        Assert.Contains(
            "'stars' is 'far', which the server does not have", await unknown.Content.ReadAsStringAsync(), StringComparison.Ordinal);
    }
}
