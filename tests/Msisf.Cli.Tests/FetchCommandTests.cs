using System.Net;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests;

public sealed class FetchCommandTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    private string Own => Path.Combine(_folder.Path, "own");

    public void Dispose() => _folder.Dispose();

    [RequiresFact(Part.Ldem4)]
    public void Fetch_Folder_HasTheModelOnceAndTheProgramReadsIt()
    {
        string site = Site("site", "LDEM_4.LBL", "LDEM_4.IMG");

        CommandLineRun first = Fetch("ldem", site);
        DateTime written = File.GetLastWriteTimeUtc(Path.Combine(Own, "LDEM_4.IMG"));
        CommandLineRun second = Fetch("ldem", site);

        Assert.Equal((0, 0), (first.ExitCode, second.ExitCode));
        Assert.Equal(Path.Combine(Own, "LDEM_4.LBL"), first.Output.Trim());
        Assert.Contains("comes from", first.Error, StringComparison.Ordinal);
        Assert.Contains("LDEM_4 is in place.", second.Error, StringComparison.Ordinal);
        Assert.Equal(written, File.GetLastWriteTimeUtc(Path.Combine(Own, "LDEM_4.IMG")));
        Assert.Equal(["LDEM_4.IMG", "LDEM_4.LBL"], Files());
        Assert.Equal(0, CommandLineRun.Of(["--ldem", Own, "--position", "0,0,1e5", "--time", "55289", "--dry-run"]).ExitCode);
    }

    [RequiresFact(Part.Ldem4)]
    public void Fetch_NamesInSmallLetters_BecomeCapitals()
    {
        string site = Site("site", "ldem_4.lbl", "ldem_4.img");

        Assert.Equal(0, Fetch("ldem", site).ExitCode);
        Assert.Equal(["LDEM_4.IMG", "LDEM_4.LBL"], Files());
    }

    [RequiresFact(Part.Ldem4)]
    public void Fetch_HalfAnImage_IsNotTakenAndNothingIsLeft()
    {
        string site = Site("site", "LDEM_4.LBL", "LDEM_4.IMG");
        File.WriteAllText(Path.Combine(site, "LDEM_4.IMG"), "half");

        CommandLineRun run = Fetch("ldem", site);

        Assert.Equal(3, run.ExitCode);
        Assert.Contains("LDEM_4.IMG has 4 bytes, not 2073600.", run.Error, StringComparison.Ordinal);
        Assert.Contains("No place has the elevation model LDEM_4. Put LDEM_4.LBL and LDEM_4.IMG of", run.Error, StringComparison.Ordinal);
        Assert.Empty(Files());
    }

    [RequiresFact(Part.Ldem4)]
    public void Fetch_DamagedModelInPlace_IsReplaced()
    {
        string site = Site("site", "LDEM_4.LBL", "LDEM_4.IMG");
        Assert.Equal(0, Fetch("ldem", site).ExitCode);
        File.WriteAllText(Path.Combine(Own, "LDEM_4.IMG"), "half");

        CommandLineRun run = Fetch("ldem", site);

        Assert.Equal(0, run.ExitCode);
        Assert.Contains("it has 4 bytes, but its label says 2073600. It is replaced.", run.Error, StringComparison.Ordinal);
        Assert.Equal(2_073_600, new FileInfo(Path.Combine(Own, "LDEM_4.IMG")).Length);
    }

    /// <summary>The server ends the connection within the image; the next run asks for the rest alone.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task Fetch_DownloadThatWasCutOff_GoesOn()
    {
        string site = Site("site", "LDEM_4.LBL", "LDEM_4.IMG");
        byte[] image = File.ReadAllBytes(Path.Combine(site, "LDEM_4.IMG"));
        List<string?> ranges = [];
        using HttpListener server = new();
        string address = Listen(server);
        Task serving = ServeAsync(server, site, "LDEM_4.IMG", image.Length / 2, ranges);

        CommandLineRun first = Fetch("ldem", address);
        CommandLineRun second = Fetch("ldem", address);
        server.Stop();
        await serving;

        Assert.Equal((3, 0), (first.ExitCode, second.ExitCode));
        Assert.Contains($"bytes={image.Length / 2}-", ranges);
        Assert.Equal(image, File.ReadAllBytes(Path.Combine(Own, "LDEM_4.IMG")));
        Assert.Equal(["LDEM_4.IMG", "LDEM_4.LBL"], Files());
    }

    /// <summary>The program's kernels, of which one is cut off and one damaged later. NAIF may be out of reach for the sixth.</summary>
    [Fact]
    public async Task Fetch_KernelsCutOffAndDamaged_AreMadeWhole()
    {
        const string Cut = "moon_pa_de421_1900-2050.bpc";
        string site = Path.Combine(TestParts.RepositoryRoot, "kernels");
        string[] names = ["naif0012.tls", "moon_080317.tf", "moon_assoc_me.tf", Cut, "de421.bsp"];
        List<string?> ranges = [];
        using HttpListener server = new();
        string address = Listen(server);
        Task serving = ServeAsync(server, site, Cut, firstBytes: 1_000_000, ranges);

        CommandLineRun first = Fetch("kernels", address);
        string[] afterTheCut = Files();
        CommandLineRun second = Fetch("kernels", address);
        File.WriteAllBytes(Path.Combine(Own, "naif0012.tls"), new byte[5_257]);
        CommandLineRun third = Fetch("kernels", address);
        server.Stop();
        await serving;

        Assert.Contains("bytes=1000000-", ranges);
        Assert.DoesNotContain("de421.bsp", afterTheCut);
        Assert.Contains("moon_assoc_me.tf is in place.", second.Error, StringComparison.Ordinal);
        Assert.Contains($"{Cut} comes from {address}.", second.Error, StringComparison.Ordinal);
        Assert.Contains(
            "naif0012.tls: its SHA-256 is not that of the published file. It is replaced.", third.Error, StringComparison.Ordinal);
        Assert.Equal(names.Select(name => Path.Combine(Own, name)), third.Output.Split('\n').Take(names.Length));
        Assert.All(names, name => Assert.Equal(
            File.ReadAllBytes(Path.Combine(site, name)), File.ReadAllBytes(Path.Combine(Own, name))));
        Assert.Equal(File.Exists(Path.Combine(Own, "pck00011.tpc")) ? 0 : 3, third.ExitCode);
        Assert.Equal(3, first.ExitCode);
    }

    [Fact]
    public void Fetch_FileThatIsNotTheCatalogue_IsNotTaken()
    {
        string site = Path.Combine(_folder.Path, "site");
        Directory.CreateDirectory(site);
        File.WriteAllText(Path.Combine(site, "hip_main.dat"), "half");

        CommandLineRun run = CommandLineRun.Of(["fetch", "stars", "--from", site, "--to", Own]);

        Assert.Contains("hip_main.dat has 4 bytes, not 53316318.", run.Error, StringComparison.Ordinal);
        Assert.DoesNotContain(Files(), name => name == "hip_main.dat" && new FileInfo(Path.Combine(Own, name)).Length == 4);
    }

    [Fact]
    public void Fetch_PageInPlaceOfALabel_IsNotTaken()
    {
        string site = Path.Combine(_folder.Path, "site");
        Directory.CreateDirectory(site);
        File.WriteAllText(Path.Combine(site, "LDEM_4.LBL"), "<html>log in first</html>");
        File.WriteAllText(Path.Combine(site, "lroc_color_poles_4k.tif"), "<html>log in first</html>");

        CommandLineRun model = Fetch("ldem", new Uri(site).AbsoluteUri);
        CommandLineRun map = Fetch("albedo", new Uri(site).AbsoluteUri, "--map-size", "4k");

        Assert.Equal((3, 3), (model.ExitCode, map.ExitCode));
        Assert.Contains("lroc_color_poles_4k.tif: what was sent is not an image.", map.Error, StringComparison.Ordinal);
        Assert.Empty(Files());
    }

    [Fact]
    public void Fetch_Map_IsFoundInAFolderByItsName()
    {
        string site = Path.Combine(_folder.Path, "site");
        Directory.CreateDirectory(site);
        File.WriteAllBytes(Path.Combine(site, "moon_nasa_svs4720_11469x5734.jpg"), [0xff, 0xd8, 0xff, 0xe0, 1, 2]);

        Assert.Equal(0, Fetch("albedo", site).ExitCode);
        Assert.Contains("is in place", Fetch("albedo", site).Error, StringComparison.Ordinal);
        Assert.Equal(["moon_nasa_svs4720_11469x5734.jpg"], Files());
    }

    /// <summary>A wrong word fails before any place is asked.</summary>
    [Theory]
    [InlineData(
        "ldem --from /nowhere", 1, "--from /nowhere: there is no such folder. Name one, or the address of one, or leave the option out.")]
    [InlineData("ldem --res 5", 1, "--res is '5'; NASA has models of 4, 16, 64, 128, 256, 512, 1024 px/deg.")]
    [InlineData("albedo --map-size 3k", 1, "--map-size is '3k'; one of 2k, 4k, 8k, 16k is needed: did you mean 2k?")]
    public void Fetch_WrongOption_SaysWhatIsRight(string words, int exitCode, string expected)
    {
        CommandLineRun run = CommandLineRun.Of(["fetch", .. words.Split(' ')]);

        Assert.Equal(exitCode, run.ExitCode);
        Assert.Contains(expected, run.Error, StringComparison.Ordinal);
    }

    private CommandLineRun Fetch(string kind, string from, params string[] more) =>
        CommandLineRun.Of(["fetch", kind, "--from", from, "--to", Own, .. more]);

    private string[] Files() => Directory.Exists(Own)
        ? [.. Directory.EnumerateFileSystemEntries(Own).Select(path => Path.GetFileName(path)!).Order(StringComparer.Ordinal)]
        : [];

    /// <summary>A folder with LDEM_4 under other names.</summary>
    private string Site(string name, string label, string image)
    {
        string site = Path.Combine(_folder.Path, name);
        Directory.CreateDirectory(site);
        File.Copy(TestParts.Ldem4Label!, Path.Combine(site, label));
        File.Copy(Path.ChangeExtension(TestParts.Ldem4Label!, ".IMG"), Path.Combine(site, image));
        return site;
    }

    private static string Listen(HttpListener server)
    {
        for (int port = 20_000 + (Environment.ProcessId % 20_000); ; port++)
        {
            try
            {
                server.Prefixes.Clear();
                server.Prefixes.Add($"http://127.0.0.1:{port}/");
                server.Start();
                return $"http://127.0.0.1:{port}";
            }
            catch (HttpListenerException) when (port < 60_000)
            {
                // another program has it
            }
        }
    }

    /// <summary>Answers until it is stopped; the first time that a file is asked for with its first bytes only.</summary>
    private static async Task ServeAsync(HttpListener server, string folder, string cutFile, int firstBytes, List<string?> ranges)
    {
        bool isCut = false;
        while (server.IsListening)
        {
            HttpListenerContext context;
            try
            {
                context = await server.GetContextAsync();
            }
            catch (Exception exception) when (exception is HttpListenerException or ObjectDisposedException)
            {
                return;
            }

            string path = Path.Combine(folder, context.Request.Url!.Segments[^1]);
            if (!File.Exists(path))
            {
                context.Response.StatusCode = 404;
                context.Response.Close();
                continue;
            }

            byte[] bytes = await File.ReadAllBytesAsync(path);
            string? range = context.Request.Headers["Range"];
            ranges.Add(range);
            int start = range is null ? 0 : int.Parse(range["bytes=".Length..^1], System.Globalization.CultureInfo.InvariantCulture);
            context.Response.StatusCode = range is null ? 200 : 206;
            context.Response.ContentLength64 = bytes.Length - start;
            if (range is not null)
            {
                context.Response.Headers["Content-Range"] = $"bytes {start}-{bytes.Length - 1}/{bytes.Length}";
            }

            bool cut = !isCut && path.EndsWith(cutFile, StringComparison.Ordinal);
            isCut |= cut;
            await context.Response.OutputStream.WriteAsync(bytes.AsMemory(start, cut ? firstBytes : bytes.Length - start));
            if (cut)
            {
                await context.Response.OutputStream.FlushAsync();
                context.Response.Abort();
            }
            else
            {
                context.Response.Close();
            }
        }
    }
}
