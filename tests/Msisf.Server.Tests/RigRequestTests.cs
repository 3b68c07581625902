using System.Net;
using System.Text;
using System.Text.Json;
using System.Xml.Linq;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Server.Tests;

/// <summary>A rig as one request gives what msis --rig writes.</summary>
public sealed class RigRequestTests(RunningServer server) : IClassFixture<RunningServer>
{
    private const string Body = """
        "fixed-state": [55289.25, 1.9e6, 1e5, 0, 0, 0.28, 0, 0.96], "motion": [10, 1600, -30, 0.001, 0.02, -0.003], "grid": 8,
        "layers": ["depth", "normal"]
        """;

    private const string Cameras = """
        [{"name": "left", "fov": 40, "width": 64, "height": 48, "quaternion": [0.02, -0.3, 0.1, 0.9484724561103501],
          "offset": [3, -250, 40]},
         {"name": "line", "lines": 12, "camera": {"width": 40, "height": 1, "focal-length-px": 90,
          "scan": {"kind": "line-scan", "period": 0.6}}}]
        """;

    [RequiresFact(Part.Ldem4)]
    public async Task Rig_HasTheBytesOf_Msis()
    {
        using TemporaryFolder folder = new();
        folder.Write(
            "line.yaml", "width: 40\nheight: 1\nfocal-length-px: 90\nscan:\n  kind: line-scan\n  period: 0.6\n");
        string rig = folder.Write(
            "rig.yaml",
            "cameras:\n  left:\n    fov: 40\n    width: 64\n    height: 48\n    quaternion: [0.02, -0.3, 0.1, 0.9484724561103501]\n"
                + "    offset: [3, -250, 40]\n  line:\n    camera: line.yaml\n    lines: 12\n    quaternion: [0, 0, 0, 1]\n");
        CommandLineRun run = CommandLineRun.Of(
        [
            "--fixed-state", "{55289.25,1.9e6,1e5,0,0,0.28,0,0.96}", "--motion", "{10,1600,-30,0.001,0.02,-0.003}", "--grid", "8",
            "--layers", "depth,normal", "--layers-format", "npy", "--samples", "4", "--renderer", "native", "--rig", rig, "--batch",
            "--output-name", "{camera}", "--output-dir", folder["of msis"], "--ldem", TestParts.Ldem4Label!,
        ]);
        Assert.True(run.ExitCode == 0, run.Error);

        string answer = Encoding.Latin1.GetString(await server.RenderAsync(
            $$""" "frame": { {{Body}}, "layers-format": "npy", "samples": 4 }, "cameras": {{Cameras}} """, "multipart/mixed"));

        foreach (string name in new[] { "left", "line" })
        {
            foreach (string ending in new[] { "png", "depth.npy", "normal.npy" })
            {
                string content = Encoding.Latin1.GetString(File.ReadAllBytes(folder[$"of msis/{name}.{ending}"]));
                string file = ending == "png" ? "image.png" : ending;
                Assert.Contains(
                    $"filename=\"{name}.{file}\"\r\nContent-Length: {content.Length}\r\n\r\n{content}\r\n--", answer,
                    StringComparison.Ordinal);
            }

            XElement meta = MetaFileXml.Parse(File.ReadAllText(folder[$"of msis/{name}.xml"])).Descendants("Rig").Single();
            int part = answer.IndexOf($"filename=\"{name}.xml\"", StringComparison.Ordinal);
            int start = answer.IndexOf("<?xml", part, StringComparison.Ordinal);
            string xml = answer[start..(answer.IndexOf("</MSISRendering>", start, StringComparison.Ordinal) + 16)];
            Assert.Equal(meta.ToString(), MetaFileXml.Parse(xml).Descendants("Rig").Single().ToString());
        }
    }

    /// <summary>Elements of which there may be several are lists, and the times say whose they are.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task Meta_HasListsOfRowsAndCameras()
    {
        string body = Body.Replace("\"grid\": 8", "\"grid\": 4", StringComparison.Ordinal);
        using HttpResponseMessage answer = await server.PostAsync(
            "/v1/render", $$"""{"frame": { {{body}} }, "cameras": {{Cameras}} }""", "multipart/mixed, application/json");
        string text = await answer.Content.ReadAsStringAsync();
        Assert.True(answer.IsSuccessStatusCode, text);
        int start = text.IndexOf('{', text.IndexOf("filename=\"line.json\"", StringComparison.Ordinal));
        using JsonDocument meta = JsonDocument.Parse(text[start..text.IndexOf("\r\n--", start, StringComparison.Ordinal)]);
        JsonElement general = meta.RootElement.GetProperty("GeneralInformation");

        Assert.Equal(
            [4, 8, 12], general.GetProperty("Scan").GetProperty("Row").EnumerateArray().Select(row => row.GetProperty("v").GetInt32()));
        Assert.Equal(
            ["left"], general.GetProperty("Rig").GetProperty("OtherCamera").EnumerateArray().Select(
                other => other.GetProperty("name").GetString()));
        Assert.Equal(
            ["left.wait", "left.draw", "left.write", "line.wait", "line.draw", "line.write"],
            answer.Headers.GetValues("Server-Timing").Single().Split(", ").Select(time => time.Split(';')[0]));
    }

    /// <summary>What the reading of a state says is said once, not for each camera.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task StateOfAllCameras_IsReadOnce()
    {
        using HttpResponseMessage answer = await server.PostAsync(
            "/v1/render",
            """
            {"frame": {"position": [0, 30, 1800000], "look-at": "nadir", "time": 55289.25, "width": 8, "height": 8},
             "cameras": [{}, {"fov": 5}, {"width": 9}]}
            """,
            "multipart/mixed");

        string said = answer.Headers.GetValues("X-Msisf-Warning").Single();
        Assert.Equal(2, said.Split("heights are over the surface").Length);
    }

    [RequiresFact(Part.Ldem4)]
    public async Task MountingOfFewDecimals_IsTakenWithNormalize()
    {
        using HttpResponseMessage answer = await server.PostAsync(
            "/v1/render",
            $$"""{"frame": { {{RunningServer.SmallFrame}}, "normalize": true }, "cameras": [{"quaternion": [0, 0, 0.3827, 0.9239]}] }""",
            "multipart/mixed");

        Assert.True(answer.StatusCode == HttpStatusCode.OK, await answer.Content.ReadAsStringAsync());
    }

    [RequiresTheory(Part.Ldem4)]
    [InlineData("[]", "multipart/mixed", 400, "a list of 1 to 16 objects")]
    [InlineData("[{\"name\": \"a\"}, {\"name\": \"a\"}]", "multipart/mixed", 400, "have one name")]
    [InlineData("[{\"name\": \"a b\"}]", "multipart/mixed", 400, "is not a name of a camera")]
    [InlineData("[{\"quaternion\": [0, 0, 0, 2]}]", "multipart/mixed", 400, "has length 2, and a rotation")]
    [InlineData("[{\"quaternion\": [0, 0, 0.3827, 0.9239]}]", "multipart/mixed", 400, "Add decimals, or give --normalize.")]
    [InlineData("[{\"fov\": 4}, {\"fov\": 400}]", "multipart/mixed", 400, "--fov")]
    [InlineData("[{\"fov\": 4}]", "image/png", 406, "several cameras are answered in several parts")]
    [InlineData("[{\"fov\": 4}], \"width\": 3", "multipart/mixed", 400, "and nothing else")]
    public async Task WrongCameras_AreRefused(string cameras, string accept, int status, string said)
    {
        using HttpResponseMessage answer = await server.PostAsync(
            "/v1/render", $$"""{"frame": { {{RunningServer.SmallFrame}} }, "cameras": {{cameras}} }""", accept);

        string text = await answer.Content.ReadAsStringAsync();
        Assert.True((HttpStatusCode)status == answer.StatusCode, text);
        Assert.Contains(said, text, StringComparison.Ordinal);
    }
}
