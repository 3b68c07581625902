using System.Net;
using System.Text;
using System.Text.Json;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Server.Tests;

/// <summary>POST /v1/render gives what msis writes, and says what is wrong in its words.</summary>
public sealed class RenderTests(RunningServer server) : IClassFixture<RunningServer>
{
    private const string Options = """
        "position": [3, 6, 120000], "time": 55289.25, "off-nadir": [10, 30], "width": 96, "height": 64, "fov": 30, "samples": 4,
        "reflectance": "hapke", "sun": "disc", "grid": 16, "surface": "terrain", "layers": ["depth", "normal", "mask"]
        """;

    private const string Detector = """
        "detector": {"f-number": 4, "exposure-time": 1e-5, "band": [500, 650], "quantum-efficiency": 0.45, "gain": 1, "adc-bits": 16,
        "fits": "no"}
        """;

    private const string FacetsOfRequest =
        """
        "position": [3, 6, 120000], "time": 55289.25, "off-nadir": [10, 30], "width": 24, "height": 16, "fov": 30, "samples": 1
        """;

    private static readonly string[] Facets =
    [
        "--position", "3,6,120000", "--time", "55289.25", "--off-nadir", "10,30", "--width", "24", "--height", "16", "--fov", "30",
        "--samples", "1", "--renderer", "native", "--batch",
    ];

    private static readonly string[] CommandLine =
    [
        "--position", "3,6,120000", "--time", "55289.25", "--off-nadir", "10,30", "--width", "96", "--height", "64", "--fov", "30",
        "--samples", "4", "--reflectance", "hapke", "--sun", "disc", "--grid", "16", "--surface", "terrain",
        "--layers", "depth,normal,mask", "--renderer", "native", "--batch",
    ];

    [RequiresTheory(Part.Ldem4)]
    [InlineData("image/png", "png")]
    [InlineData("application/xml", "xml")]
    public async Task Answer_HasTheBytesOf_Msis(string accept, string extension)
    {
        using TemporaryFolder folder = new();
        byte[] expected = FileOfMsis(folder, extension);

        Assert.Equal(expected, await server.RenderAsync(Options, accept));
    }

    /// <summary>The names of places in a request are those of the command line.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task NamedPlaces_HaveTheBytesOf_TheirNumbers()
    {
        const string size = "\"time\": 55289.25, \"width\": 48, \"height\": 32";

        Assert.Equal(
            await server.RenderAsync($"{size}, \"position\": [-43.2958, 348.785, 200000], \"look-at\": [-45.4458, 348.785]", "image/png"),
            await server.RenderAsync($"{size}, \"position\": \"Tycho,200000\", \"look-at\": \"-45.4458,348.785\"", "image/png"));
        Assert.Equal(
            await server.RenderAsync($"{size}, \"position\": [-45, 348, 200000], \"look-at\": [-43.2958, 348.785]", "image/png"),
            await server.RenderAsync($"{size}, \"position\": [-45, 348, 200000], \"look-at\": \"tycho\"", "image/png"));
    }

    /// <summary>A look is its options; those of the request stay.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task Look_HasTheBytesOf_ItsOptions()
    {
        const string frame = "\"position\": [3, 6, 60000], \"time\": 55289.25, \"width\": 48, \"height\": 32";

        const string options = "\"samples\": 4, \"shading\": \"smooth\", \"sun\": \"disc\", \"refine\": 1";

        Assert.Equal(
            await server.RenderAsync($"{frame}, {options}", "application/xml"),
            await server.RenderAsync($"{frame}, \"look\": \"photo\", \"samples\": 4", "application/xml"));
        Assert.Equal(
            await server.RenderAsync($"{frame}, \"surface\": \"terrain\"", "application/xml"),
            await server.RenderAsync($"{frame}, \"look\": \"truth\"", "application/xml"));
    }

    [RequiresFact(Part.Ldem4)]
    public async Task Multipart_HasTheBytesOf_AllFilesOfMsis()
    {
        using TemporaryFolder folder = new();
        byte[] png = FileOfMsis(folder, "png", "--layers-format", "npy");

        string answer = Encoding.Latin1.GetString(
            await server.RenderAsync($"{Options}, \"layers-format\": \"npy\"", "multipart/mixed"));

        Assert.Contains(Encoding.Latin1.GetString(png), answer, StringComparison.Ordinal);
        foreach (string name in new[] { "depth.npy", "normal.npy", "mask.npy", "layers.json", "xml" })
        {
            string file = Assert.Single(Directory.GetFiles(folder.Path, $"*.{name}"));
            string content = Encoding.Latin1.GetString(File.ReadAllBytes(file));
            Assert.Contains(
                $"filename=\"{name}\"\r\nContent-Length: {content.Length}\r\n\r\n{content}\r\n--", answer, StringComparison.Ordinal);
        }
    }

    [RequiresFact(Part.Ldem4)]
    public async Task CameraModels_HaveTheBytesOf_Msis()
    {
        using TemporaryFolder folder = new();
        CommandLineRun run = CommandLineRun.Of(
        [
            .. CommandLine, "--camera-model", "csm,colmap,isd", "--output-name", "frame", "--output-dir", folder.Path,
            "--ldem", TestParts.Ldem4Label!,
        ]);
        Assert.True(run.ExitCode == 0, run.Error);

        string answer = Encoding.Latin1.GetString(
            await server.RenderAsync($"{Options}, \"camera-model\": [\"csm\", \"colmap\", \"isd\"]", "multipart/mixed"));

        foreach (string name in new[] { "csm.json", "cameras.txt", "images.txt", "points3D.txt", "isd.json", "xml" })
        {
            string content = File.ReadAllText(folder[$"frame.{name}"], Encoding.Latin1);
            Assert.Contains($"filename=\"{name}\"\r\nContent-Length: {content.Length}\r\n\r\n{content}\r\n--", answer);
        }
    }

    /// <summary>Maps, derivatives, what an image tells of its pose, and bounds of its pixels.</summary>
    [RequiresTheory(Part.Ldem4, Part.Gdal)]
    [InlineData("map", "orthographic,3000", "map.tif", "depth.map.tif")]
    [InlineData("sensitivity", "position-x,sun-north", "sensitivity.d-position-x.npy", "sensitivity.d-sun-north.npy")]
    [InlineData("certify", "height=1,turn=0.001", "certain.certain-low.npy", "certain.certain-state.npy")]
    public async Task OtherProducts_HaveTheBytesOf_Msis(string option, string value, params string[] names)
    {
        using TemporaryFolder folder = new();
        CommandLineRun run = CommandLineRun.Of(
        [
            .. Facets, "--layers", "depth", "--layers-format", "npy", $"--{option}", value, "--output-name", "frame", "--output-dir",
            folder.Path, "--ldem", TestParts.Ldem4Label!,
        ]);
        Assert.True(run.ExitCode == 0, run.Error);

        string answer = Encoding.Latin1.GetString(await server.RenderAsync(
            $"{FacetsOfRequest}, \"layers\": \"depth\", \"layers-format\": \"npy\", \"{option}\": \"{value}\"", "multipart/mixed"));

        foreach (string name in names)
        {
            string content = File.ReadAllText(folder[$"frame.{name}"], Encoding.Latin1);
            Assert.Contains($"filename=\"{name}\"\r\nContent-Length: {content.Length}\r\n\r\n{content}\r\n--", answer);
        }
    }

    /// <summary>A rolling shutter of so wide a view is off as a line-scan, which the server says as msis does.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task CameraModelOfAScan_HasTheBytesOf_MsisAndItsWarning()
    {
        using TemporaryFolder folder = new();
        string camera = folder.Write(
            "camera.yaml", "width: 32\nheight: 24\nfield-of-view: 30\nscan: {kind: rolling-shutter, period: 0.01}\n");
        CommandLineRun run = CommandLineRun.Of(
        [
            "--fixed-state", "{55289,1.9e6,0,0,0,0,0,1}", "--motion", "{0,0,1600,0,0,0}", "--camera", camera, "--renderer", "native",
            "--camera-model", "csm", "--output-name", "frame", "--output-dir", folder.Path, "--ldem", TestParts.Ldem4Label!, "--batch",
        ]);
        Assert.True(run.ExitCode == 0, run.Error);

        using HttpResponseMessage answer = await server.PostAsync(
            "/v1/render",
            """
            {"fixed-state": [55289, 1.9e6, 0, 0, 0, 0, 0, 1], "motion": [0, 0, 1600, 0, 0, 0], "camera-model": "csm", "camera":
            {"width": 32, "height": 24, "field-of-view": 30, "scan": {"kind": "rolling-shutter", "period": 0.01}}}
            """,
            "multipart/mixed");

        string warning = answer.Headers.GetValues("X-Msisf-Warning").Single();
        Assert.Contains("a rolling shutter is off by up to ", warning);
        Assert.Contains(warning, run.Error);
        Assert.Contains($"\r\n\r\n{File.ReadAllText(folder["frame.csm.json"])}\r\n--", await answer.Content.ReadAsStringAsync());
    }

    [RequiresTheory(Part.Ldem4)]
    [InlineData("map", "orthographic,3000", "'map' is for answers of several parts, and image/png is one. Accept multipart/mixed.")]
    [InlineData("sensitivity", "sun-north", "'sensitivity' or 'information' is for answers of several parts")]
    [InlineData("certify", "height=1", "'certify' is for answers of several parts")]
    public async Task ProductInAnAnswerOfOnePart_IsRefused(string option, string value, string problem)
    {
        using HttpResponseMessage answer = await server.PostAsync(
            "/v1/render", $"{{{RunningServer.SmallFrame}, \"{option}\": \"{value}\"}}", "image/png");

        Assert.Equal(HttpStatusCode.NotAcceptable, answer.StatusCode);
        JsonElement answered = JsonDocument.Parse(await answer.Content.ReadAsByteArrayAsync()).RootElement;
        Assert.Contains(problem, answered.GetProperty("detail").GetString());
    }

    [RequiresTheory(Part.Ldem4)]
    [InlineData("csm", "image/png", HttpStatusCode.NotAcceptable, "'camera-model' is for answers of several parts")]
    [InlineData("tsa", "multipart/mixed", HttpStatusCode.BadRequest, "'tsa' is not a format of camera models")]
    public async Task CameraModelsThatCannotBeSent_AreRefused(string formats, string accept, HttpStatusCode status, string problem)
    {
        using HttpResponseMessage answer = await server.PostAsync(
            "/v1/render", $"{{{RunningServer.SmallFrame}, \"camera-model\": \"{formats}\"}}", accept);

        Assert.Equal(status, answer.StatusCode);
        Assert.Contains(problem, JsonDocument.Parse(await answer.Content.ReadAsByteArrayAsync()).RootElement.ToString());
    }

    [RequiresFact(Part.Ldem4, Part.CFitsio)]
    public async Task Fits_HasTheBytesOf_Msis()
    {
        using TemporaryFolder folder = new();
        byte[] expected = FileOfMsis(folder, "fits");

        Assert.Equal(expected, await server.RenderAsync(Options, "application/fits"));
    }

    /// <summary>The same levels as in the PNG, which is read back here.</summary>
    [RequiresTheory(Part.Ldem4)]
    [InlineData(8, "u8")]
    [InlineData(16, "u16")]
    public async Task Raw_HasTheLevelsOf_ThePng(int bits, string type)
    {
        string options = $"{RunningServer.SmallFrame}, \"bit-depth\": {bits}";
        using HttpResponseMessage answer = await server.PostAsync("/v1/render", $"{{{options}}}", "application/octet-stream");
        byte[] raw = await answer.Content.ReadAsByteArrayAsync();

        Assert.Equal(type, answer.Headers.GetValues("X-Msisf-Type").Single());
        Assert.Equal("64", answer.Headers.GetValues("X-Msisf-Width").Single());
        Assert.Equal($"{bits}", answer.Headers.GetValues("X-Msisf-Bits").Single());
        Assert.Equal("srgb", answer.Headers.GetValues("X-Msisf-Transfer").Single());
        Assert.Equal(64 * 48 * bits / 8, raw.Length);
        byte[] npy = await server.RenderAsync(options, "application/x-npy");
        Assert.Equal(raw, npy[^raw.Length..]);
        Assert.Contains(bits == 8 ? "'|u1'" : "'<u2'", Encoding.ASCII.GetString(npy, 0, 80), StringComparison.Ordinal);
        using MemoryStream png = new(await server.RenderAsync(options));
        PngPixels pixels = PngPixels.Read(png);
        Assert.Equal(
            Enumerable.Range(0, 64 * 48).Select(i => pixels[i % 64, i / 64, 0]),
            Enumerable.Range(0, 64 * 48).Select(i => bits == 8 ? raw[i] : raw[2 * i] + (256 * raw[(2 * i) + 1])));
        Assert.True(raw.Distinct().Count() > 10, "the image shows nothing");
    }

    [RequiresFact(Part.Ldem4)]
    public async Task Json_HasTheNumbersOf_TheMetaFile()
    {
        JsonElement meta = JsonDocument.Parse(await server.RenderAsync(Options, "application/json")).RootElement;

        JsonElement general = meta.GetProperty("GeneralInformation");
        Assert.Equal(
            (1737400.0 + 120000.0) * Math.Sin(double.DegreesToRadians(3.0)),
            general.GetProperty("CameraPosition").GetProperty("Vector3D").GetProperty("z").GetDouble(),
            1e-6);
        Assert.Equal(9, general.GetProperty("Camera").GetProperty("K").GetProperty("value").GetArrayLength());
        Assert.Equal(
            96 / 16 * (64 / 16), meta.GetProperty("PixelInformation").GetProperty("Pixel").GetArrayLength());
    }

    [RequiresTheory(Part.Ldem4)]
    [InlineData("""{"fixed-state": [55289, 1.9e6, 0, 0, 0, 0, 0]}""", "--fixed-state: 7 numbers, 8 expected")]
    [InlineData("""{"fixed-state": [55289, 1.9e6, 0, 0, 0, 0, 0, 1], "widht": 5}""", "'widht' is not an option: did you mean width?")]
    [InlineData("""{"fixed-state": [55289, 1.9e6, 0, 0, 0, 0, 0, 1], "fov": 500}""", "--fov is 500; its range is above 0, below 180")]
    [InlineData("""{"fixed-state": [55289, 1, 0, 0, 0, 0, 0, 1]}""", "the camera is inside the Moon")]
    [InlineData("""{"fixed-state": [55289, 1.9e6, 0, 0, 0, 0, 0, 1], "ldem": "/etc/passwd"}""", "'ldem' can't be in a request")]
    [InlineData("""{"batch-file": "/etc/passwd"}""", "'batch-file' can't be in a request")]
    [InlineData("""{"fixed-state": [55289, 1.9e6, 0, 0, 0, 0, 0, 1], "albedo-map": "/etc/passwd"}""", "which the server does not have")]
    [InlineData("""{"fixed-state": [55289, 1.9e6, 0, 0, 0, 0, 0, 1], "camera": "../../etc/passwd"}""", "which the server does not have")]
    [InlineData("""{"fixed-state": [55289, 1.9e6, 0, 0, 0, 0, 0, 1], "model": "LDEM_5"}""", "did you mean LDEM_4?")]
    [InlineData("""{"fixed-state": [55289, 1.9e6, 0, 0, 0, 0, 0, 1], "res": 5}""", "--res is 5; the server has 4")]
    [InlineData("""{"fixed-state": [55289, 1.9e6, 0, 0, 0, 0, 0, 1], "renderer": "povray"}""", "native renderer only")]
    [InlineData("""{"fov": 40}""", "nothing says where the camera is")]
    [InlineData("""[1, 2]""", "JSON object")]
    [InlineData("""{"fixed-state": [""", "the request is not JSON")]
    public async Task WrongRequest_IsRefused_InTheWordsOfTheCommandLine(string json, string words)
    {
        using HttpResponseMessage answer = await server.PostAsync("/v1/render", json);

        JsonElement problem = await RunningServer.JsonOf(answer);
        Assert.Equal(HttpStatusCode.BadRequest, answer.StatusCode);
        Assert.Equal("application/problem+json", answer.Content.Headers.ContentType!.MediaType);
        Assert.Contains(words, problem.GetProperty("detail").GetString(), StringComparison.Ordinal);
        Assert.Equal(400, problem.GetProperty("status").GetInt32());
    }

    [RequiresFact(Part.Ldem4)]
    public async Task InlineCamera_IsTheSame_AsItsFile()
    {
        using TemporaryFolder folder = new();
        string camera = Path.Combine(folder.Path, "own.yaml");
        File.WriteAllText(camera, "width: 80\nheight: 60\nfocal-length-px: [90, 91]\nprincipal-point: [39, 31]\n");
        byte[] expected = FileOfRun(
            folder, "png", ["--fixed-state", "{55289,1.9e6,0,0,0,0,0,1}", "--renderer", "native", "--batch", "--camera", camera]);

        Assert.Equal(expected, await server.RenderAsync("""
            "fixed-state": [55289, 1.9e6, 0, 0, 0, 0, 0, 1],
            "camera": {"width": 80, "height": 60, "focal-length-px": [90, 91], "principal-point": [39, 31]}
            """));
    }

    /// <summary>Frames of one session, told apart by their noise alone, and of another exposure time.</summary>
    [RequiresTheory(Part.Ldem4)]
    [InlineData("\"noise-seed\": 18446744073709551615", "--noise-seed 18446744073709551615")]
    [InlineData("\"noise-seed\": \"7:3\"", "--noise-seed 7:3")]
    [InlineData("\"exposure-time\": 2.5e-5, \"noise-seed\": 7", "--exposure-time 2.5e-5 --noise-seed 7")]
    public async Task ExposureTimeAndNoise_AreThoseOf_Msis(string options, string words)
    {
        using TemporaryFolder folder = new();
        string camera = Path.Combine(folder.Path, "own.yaml");
        File.WriteAllText(camera, $$"""{"width": 40, "height": 30, "focal-length": 5, "pixel-pitch": 0.1, {{Detector}} }""");
        byte[] expected = FileOfRun(
            folder, "png",
            ["--fixed-state", "{55289,1.9e6,0,0,0,0,0,1}", "--renderer", "native", "--batch", "--camera", camera, .. words.Split(' ')]);

        Assert.Equal(expected, await server.RenderAsync($$"""
            "fixed-state": [55289, 1.9e6, 0, 0, 0, 0, 0, 1], {{options}},
            "camera": {"width": 40, "height": 30, "focal-length": 5, "pixel-pitch": 0.1, {{Detector}} }
            """));
    }

    [RequiresTheory(Part.Ldem4)]
    [InlineData("\"exposure-time\": \"auto\"", "auto is found from the images of a whole run, and a request is one image. Give seconds.")]
    [InlineData("\"exposure-time\": 0", "--exposure-time is '0'; seconds above 0")]
    [InlineData("\"noise-seed\": 1.5", "--noise-seed: '1.5' is not a noise seed")]
    public async Task ExposureTimeOrNoise_ThatCantBe_IsRefused(string option, string words)
    {
        using HttpResponseMessage answer = await server.PostAsync("/v1/render", $$"""
            {"fixed-state": [55289, 1.9e6, 0, 0, 0, 0, 0, 1], {{option}},
             "camera": {"width": 40, "height": 30, "focal-length": 5, "pixel-pitch": 0.1, {{Detector}} } }
            """);

        Assert.Equal(HttpStatusCode.BadRequest, answer.StatusCode);
        Assert.Contains(words, (await RunningServer.JsonOf(answer)).GetProperty("detail").GetString(), StringComparison.Ordinal);
    }

    /// <summary>The path is not even looked at: no such file would be another message.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task InlineCamera_ThatNamesAFile_IsRefused()
    {
        using HttpResponseMessage answer = await server.PostAsync("/v1/render", """
            {"fixed-state": [55289, 1.9e6, 0, 0, 0, 0, 0, 1], "camera": {"width": 80, "height": 60, "field-of-view": 40,
             "detector": {"exposure-time": 0.01, "full-well": 50000, "gain": 10, "bits": 12, "f-number": 4, "psf": "kernel",
             "psf-kernel": "/etc/passwd", "quantum-efficiency": 0.5, "pixel-pitch": 0.01}}}
            """);

        Assert.Equal(HttpStatusCode.BadRequest, answer.StatusCode);
        Assert.DoesNotContain("can't be read", await answer.Content.ReadAsStringAsync(), StringComparison.Ordinal);
    }

    [RequiresFact(Part.Ldem4)]
    public async Task TimeOutsideTheKernels_IsUnprocessable()
    {
        using HttpResponseMessage answer = await server.PostAsync(
            "/v1/render", """{"fixed-state": [200000, 1.9e6, 0, 0, 0, 0, 0, 1], "width": 8, "height": 8}""");

        Assert.Equal(HttpStatusCode.UnprocessableEntity, answer.StatusCode);
        Assert.Contains("outside the kernels' cover", await answer.Content.ReadAsStringAsync(), StringComparison.Ordinal);
    }

    [RequiresFact(Part.Ldem4)]
    public async Task PlausibleMistake_IsAWarning()
    {
        using HttpResponseMessage answer = await server.PostAsync(
            "/v1/render", """{"position": "0,0,1800000", "time": "2010-04-03T00:00:00Z", "width": 8, "height": 8}""");

        Assert.Contains("heights are over the surface", answer.Headers.GetValues("X-Msisf-Warning").Single(), StringComparison.Ordinal);
    }

    private static byte[] FileOfMsis(TemporaryFolder folder, string extension, params string[] more) =>
        FileOfRun(folder, extension, [.. CommandLine, .. more]);

    private static byte[] FileOfRun(TemporaryFolder folder, string extension, string[] arguments)
    {
        CommandLineRun run = CommandLineRun.Of([.. arguments, "--output-dir", folder.Path, "--ldem", TestParts.Ldem4Label!]);
        Assert.True(run.ExitCode == 0, run.Error);
        return File.ReadAllBytes(Assert.Single(Directory.GetFiles(folder.Path, $"*_00001.{extension}")));
    }
}
