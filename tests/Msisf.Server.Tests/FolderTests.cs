using System.Net;
using System.Text.Json;
using Msisf.App.Settings;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Server.Tests;

/// <summary>/v1/folders and /v1/catalogues: what the viewer puts on its time line and its picture.</summary>
public class FolderTests
{
    [RequiresFact(Part.Ldem4)]
    public async Task FinishedFolder_Frames_HaveTheStatesAndOptionsOfTheRun()
    {
        using TemporaryFolder folder = new();
        CommandLineRun run = CommandLineRun.Of(
        [
            "--renderer", "native", "--position", "10,20.5,300000", "--times", "{55289,55290.125}", "--width", "16", "--height", "8",
            "--reflectance", "lambert", "--batch", "--output-dir", folder["run"],
        ]);
        Assert.True(run.ExitCode == 0, run.Error);
        using RunningServer server = await RunningServer.StartAsync((ViewOptions.Folders, $"flight={folder["run"]}"));

        JsonElement frames = await JsonAsync(server, "/v1/folders/flight");
        JsonElement second = frames.GetProperty("frames")[1];
        byte[] image = await server.Client.GetByteArrayAsync(second.GetProperty("image").GetString());

        Assert.Equal(2, frames.GetProperty("frames").GetArrayLength());
        Assert.Equal(2, second.GetProperty("number").GetInt32());
        Assert.Equal("2010-04-04T03:00:00Z", second.GetProperty("utc").GetString());
        Assert.Equal(2_037_400.0, Length(second.GetProperty("state")), 1e-6); // m: the length of a place in text
        Assert.Equal("lambert", second.GetProperty("options").GetProperty("reflectance").GetString());
        Assert.Equal(16, second.GetProperty("options").GetProperty("width").GetInt32());
        Assert.Equal(JsonValueKind.Null, second.GetProperty("annotated").ValueKind);
        Assert.Equal(await File.ReadAllBytesAsync(Path.Combine(folder["run"], "MoonSurfIllumSim_step_00002.png")), image);
        Assert.Equal(image, await server.RenderAsync(BodyOf(second)));
        await server.DisposeAsync();
    }

    /// <summary>A frame names its camera file with a checksum; another file of that name is not taken for it.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task FolderOfACameraFile_Frames_AreDrawnAnewWithThatFileOnly()
    {
        using TemporaryFolder folder = new();
        string camera = folder.Write("own.yaml", "width: 24\nheight: 16\nfield-of-view: 20\n");
        CommandLineRun run = CommandLineRun.Of(
        [
            "--renderer", "native", "--position", "10,20.5,300000", "--time", "55289", "--camera", camera, "--reflectance", "lambert",
            "--ignore-sun", "--refine", "7", "--batch", "--output-dir", folder["run"],
        ]);
        Assert.True(run.ExitCode == 0, run.Error);
        using RunningServer server = await RunningServer.StartAsync((ViewOptions.Folders, folder["run"]));

        JsonElement frame = (await JsonAsync(server, "/v1/folders/run")).GetProperty("frames")[0];
        byte[] drawn = await server.RenderAsync(BodyOf(frame));
        folder.Write("own.yaml", "width: 24\nheight: 16\nfield-of-view: 21\n");
        using RunningServer later = await RunningServer.StartAsync((ViewOptions.Folders, folder["run"]));
        JsonElement other = (await JsonAsync(later, "/v1/folders/run")).GetProperty("frames")[0];
        using HttpResponseMessage refused = await later.PostAsync("/v1/render", $"{{{BodyOf(other)}}}");

        Assert.Equal(24, frame.GetProperty("camera").GetProperty("width").GetInt32());
        Assert.Equal(20.0, frame.GetProperty("camera").GetProperty("field_of_view").GetDouble());
        Assert.Equal(await server.Client.GetByteArrayAsync(frame.GetProperty("image").GetString()), drawn);
        Assert.Equal(JsonValueKind.Null, other.GetProperty("camera").ValueKind);
        Assert.Equal(HttpStatusCode.BadRequest, refused.StatusCode);
        await server.DisposeAsync();
        await later.DisposeAsync();
    }

    /// <summary>A trajectory is looked at in even steps: three minutes, a frame a second, with the camera at the nadir.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task Oem_Frames_AreEvenlyOverItsCover()
    {
        using TemporaryFolder folder = new();
        string lines = string.Concat(Enumerable.Range(0, 4).Select(i => $"2024-01-19T12:0{i}:00 {2000 + (60 * i)} 0 0 1 0 0\n"));
        string oem = folder.Write(
            "orbit.oem",
            "CCSDS_OEM_VERS = 2.0\nMETA_START\nOBJECT_NAME = A\nOBJECT_ID = A\nCENTER_NAME = MOON\nREF_FRAME = ICRF\nTIME_SYSTEM = UTC\n"
                + $"META_STOP\n{lines}");
        using RunningServer server = await RunningServer.StartAsync((ViewOptions.Folders, oem));

        JsonElement frames = (await JsonAsync(server, "/v1/folders/orbit.oem")).GetProperty("frames");
        double[] last = [.. frames[180].GetProperty("state").EnumerateArray().Select(number => number.GetDouble())];

        Assert.Equal(181, frames.GetArrayLength());
        Assert.Equal(60328.5 + (180.0 / 86400.0), last[0], Rounding.OfPlaces);
        // m: interpolated between km of few digits
        Assert.Equal(2_180_000.0, Math.Sqrt((last[1] * last[1]) + (last[2] * last[2]) + (last[3] * last[3])), 1e-2);
        await server.DisposeAsync();
    }

    [RequiresFact(Part.Ldem4)]
    public async Task BatchFileWithColumns_Frames_ArePlacedOverTheTerrain()
    {
        using TemporaryFolder folder = new();
        string batch = folder.Write("a.csv", "time,lat,lon,height\n55289,0,0,terrain+1000\n");
        using RunningServer server = await RunningServer.StartAsync((ViewOptions.Folders, batch));

        JsonElement state = (await JsonAsync(server, "/v1/folders/a.csv")).GetProperty("frames")[0].GetProperty("state");

        using HttpResponseMessage answer = await server.PostAsync(
            "/v1/pixels", $"{{\"frame\": {{\"fixed-state\": {state.GetRawText()}, \"width\": 1, \"height\": 1}}, \"pixels\": [[1, 1]]}}");
        Assert.Equal(
            1000.0, (await RunningServer.JsonOf(answer)).GetProperty("points")[0].GetProperty("distance").GetDouble(), 1e-3);
        await server.DisposeAsync();
    }

    [RequiresFact(Part.Ldem4)]
    public async Task UnknownNamesNumbersAndPaths_AreNotFound()
    {
        using TemporaryFolder folder = new();
        string batch = folder.Write("a.tab", "55289 2e6 0 0 0 0 0 1\n");
        string craters = folder.Write("c.csv", "lat,lon,diam_km\n1,2,3\n");
        using RunningServer server = await RunningServer.StartAsync((ViewOptions.Folders, batch), (ViewOptions.Catalogues, craters));

        foreach (string path in new[]
        {
            "/v1/folders/b.tab", "/v1/folders/..%2Fa.tab", "/v1/folders/a.tab/frames/1/image", "/v1/folders/a.tab/frames/x/meta",
            "/v1/catalogues/d.csv", "/v1/catalogues/%2Fetc%2Fpasswd",
        })
        {
            using HttpResponseMessage answer = await server.Client.GetAsync(path);
            Assert.Equal(HttpStatusCode.NotFound, answer.StatusCode);
        }

        JsonElement crater = (await JsonAsync(server, "/v1/catalogues/c.csv")).GetProperty("craters")[0];
        Assert.Equal(3000.0, crater.GetProperty("diameter").GetDouble(), Rounding.OfPlaces);
        await server.DisposeAsync();
    }

    private static async Task<JsonElement> JsonAsync(RunningServer server, string path)
    {
        using HttpResponseMessage answer = await server.Client.GetAsync(path);
        Assert.Equal(HttpStatusCode.OK, answer.StatusCode);
        return await RunningServer.JsonOf(answer);
    }

    /// <summary>A request for a frame of a folder, without its braces.</summary>
    private static string BodyOf(JsonElement frame) =>
        $"\"fixed-state\": {frame.GetProperty("state").GetRawText()}, {JsonSerializer.Serialize(frame.GetProperty("options"))[1..^1]}";

    private static double Length(JsonElement state)
    {
        double[] numbers = [.. state.EnumerateArray().Select(number => number.GetDouble())];
        return double.Hypot(double.Hypot(numbers[1], numbers[2]), numbers[3]);
    }
}
