using System.Text.RegularExpressions;
using Msisf.App.Settings.Specs;

namespace Msisf.App.Settings;

/// <summary>The options of msis serve.</summary>
internal static partial class ServeOptions
{
    public const int DefaultPort = 8810;

    private const int DefaultMaxPixels = 4096 * 4096;
    private const int DefaultMaxMegabytes = 1000;
    private const int MaxOfMegabytes = 1_000_000;
    private const int DefaultQueue = 64;
    private const int DefaultTimeLimit = 60;
    private const int MaxTimeLimit = 86400;
    private const int MaxQueue = 10_000;

    public static TextSpec Listen { get; } = new(
        "--listen", OptionRole.HowItRuns, "ADDRESS:PORT|PATH",
        "Where to listen: an address and a port (0 for any free one), or the path of a Unix socket, which holds a /")
    {
        Default = $"127.0.0.1:{DefaultPort}",
    };

    public static PathSpec TokenFile { get; } = new(
        "--token-file", OptionRole.HowItRuns, PathKind.File,
        "File whose first line clients send as 'Authorization: Bearer', or as password; needed for any address that is not loopback");

    public static PathSpec Certificate { get; } = new("--tls-certificate", OptionRole.HowItRuns, PathKind.File, "Certificate for TLS, PEM");

    public static PathSpec CertificateKey { get; } = new("--tls-key", OptionRole.HowItRuns, PathKind.File, "Key of the certificate, PEM");

    public static TextSpec Hosts { get; } = new(
        "--allow-host", OptionRole.HowItRuns,
        "LIST", "Names under which clients may ask for the server, beside localhost and addresses; separated by commas")
    {
        Separator = ",",
        Form = (HostNames(), "names of computers separated by commas are needed, e.g. moon.example.org"),
    };

    public static WholeNumberSpec MaxPixels { get; } = new(
        "--max-pixels", OptionRole.HowItRuns, "PX", 1, int.MaxValue, "Pixels of the largest image")
    {
        Default = DefaultMaxPixels,
    };

    public static WholeNumberSpec MaxMegabytes { get; } = new(
        "--max-megabytes", OptionRole.HowItRuns,
        "MB", 1, MaxOfMegabytes, "Megabytes (of 1,000,000 bytes) of the largest answer, without compression")
    {
        Default = DefaultMaxMegabytes,
    };

    public static WholeNumberSpec Queue { get; } = new(
        "--queue", OptionRole.HowItRuns, "N", 1, MaxQueue, "Requests that may wait while others are drawn")
    {
        Default = DefaultQueue,
    };

    public static WholeNumberSpec TimeLimit { get; } = new(
        "--max-seconds", OptionRole.HowItRuns, "SECONDS", 1, MaxTimeLimit, "How long a request may take, waiting included")
    {
        Default = DefaultTimeLimit,
    };

    public static FlagSpec EndWithInput { get; } = new(
        "--end-with-input", OptionRole.HowItRuns,
        "End, without finishing images, when standard input ends or the program dies that started this one; for clients that start a "
            + "server");

    public static TextSpec Basilisk { get; } = new(
        "--basilisk", OptionRole.HowItRuns, "tcp://ADDRESS:PORT",
        "Answer Basilisk in Vizard's place at this address, and no HTTP; the usual one is tcp://127.0.0.1:5556")
    {
        ValueIfBare = "tcp://127.0.0.1:5556",
        Form = (ZeroMqAddress(), "tcp://, an address and a port are needed, e.g. tcp://127.0.0.1:5556"),
    };

    public static TextSpec BasiliskCameras { get; } = new(
        "--camera", OptionRole.HowItRuns, "ID=FILE,...",
        "Camera files with lens, detector and exposure for cameras of Basilisk, by their cameraID, separated by commas")
    {
        Separator = ",",
    };

    public static ChoiceSpec<MoonAttitude> MoonAttitude { get; } = new(
        "--moon-attitude", OptionRole.HowItRuns,
        [new Choice("message", Settings.MoonAttitude.Message), new Choice("spice", Settings.MoonAttitude.Spice)],
        "With --basilisk: take the Moon's rotation of the message as ME/PA, or ME/PA of the kernels at the simulation's time")
    {
        Default = Settings.MoonAttitude.Message,
    };

    public static PathSpec FrameOptions { get; } = new(
        "--frame-options", OptionRole.HowItRuns, PathKind.File,
        "With --basilisk: JSON with options of the images, as in a request, e.g. {\"model\": \"LDEM_64\", \"samples\": 4}");

    public static PathSpec RecordFolder { get; } = new(
        "--record", OptionRole.HowItRuns, PathKind.Folder,
        "With --basilisk: write the state of each image to a batch file here, from which msis draws it again");

    public static OptionGroup OfBasilisk { get; } = new(
        "Basilisk", [Basilisk, BasiliskCameras, MoonAttitude, FrameOptions, RecordFolder]);

    public static OptionGroup Group { get; } = new(
        "Server", [Listen, TokenFile, Certificate, CertificateKey, Hosts, MaxPixels, MaxMegabytes, Queue, TimeLimit]);

    /// <summary>The options of a server that belongs to a client.</summary>
    public static OptionGroup OfClients { get; } = new("Clients", [EndWithInput]);

    /// <summary>Reads and checks all options.</summary>
    /// <exception cref="MsisfException">A value is wrong, or an option can't be combined with another.</exception>
    public static ServeSettings Read(OptionValues values)
    {
        ListenAddress address = Listen.Named(() => ListenAddress.Parse(Listen.Read(values)));
        string? token = TokenFile.ReadIfGiven(values);
        if (!address.IsLocal && token is null)
        {
            throw Listen.Wrong($"{address} can be reached from other computers. Add {TokenFile.Name}, or listen on 127.0.0.1.", TokenFile);
        }

        string? certificate = Certificate.ReadIfGiven(values);
        string? key = CertificateKey.ReadIfGiven(values);
        if (certificate is null != key is null)
        {
            throw Certificate.Wrong($"and {CertificateKey.Name} belong together. Give both, or none.", CertificateKey);
        }

        if (certificate is not null && address.SocketPath is not null)
        {
            throw Certificate.Wrong("has no meaning with a Unix socket. Leave it out.", Listen);
        }

        string? basilisk = Basilisk.ReadIfGiven(values);
        values.Refuse(
            basilisk is null
                ? [BasiliskCameras, MoonAttitude, FrameOptions, RecordFolder]
                : [Listen, TokenFile, Certificate, Hosts, MaxMegabytes, ViewOptions.Folders, ViewOptions.Catalogues],
            $"has no meaning {(basilisk is null ? "without" : "with")} {Basilisk.Name}. Leave it out.",
            Basilisk);
        return new ServeSettings(
            address,
            token is null ? null : TokenFile.NamedInErrors(() => ReadToken(token)),
            certificate is null ? null : (certificate, key!),
            Hosts.ReadIfGiven(values)?.Split(',') ?? [],
            MaxPixels.Read(values),
            Queue.Read(values),
            TimeSpan.FromSeconds(TimeLimit.Read(values)),
            SurfaceOptions.Ldem.ReadAll(values),
            LightOptions.Kernels.ReadAll(values))
        {
            MaxMegabytes = MaxMegabytes.Read(values),
            EndsWithInput = EndWithInput.Read(values),
            Basilisk = basilisk,
            BasiliskCameras = NamedPaths.Read(BasiliskCameras, values),
            MoonAttitude = MoonAttitude.Read(values),
            FrameOptions = FrameOptions.ReadIfGiven(values),
            RecordFolder = RecordFolder.ReadIfGiven(values),
            Folders = NamedPaths.Read(ViewOptions.Folders, values),
            Catalogues = NamedPaths.Read(ViewOptions.Catalogues, values),
        };
    }

    private static string ReadToken(string path) => FileErrors.ToBadInput($"--token-file {path}: can't be read", () =>
    {
        const int shortest = 16;
        string token = File.ReadLines(path).FirstOrDefault()?.Trim() ?? string.Empty;
        return token.Length >= shortest && token.All(letter => letter is > ' ' and <= '~' and not ':')
            ? token
            : throw new BadInputException(
                $"--token-file {path}: the first line is not a token; at least {shortest} letters, digits or signs without blanks and "
                    + "colons are needed, e.g. from 'openssl rand -hex 16'.");
    });

    /// <summary>With a port of 0 to 65535.</summary>
    [GeneratedRegex("^tcp://([0-9.]+|localhost|\\*|\\[[0-9a-fA-F:]+\\]):"
        + "(?:[0-9]{1,4}|[1-5][0-9]{4}|6(?:[0-4][0-9]{3}|5(?:[0-4][0-9]{2}|5(?:[0-2][0-9]|3[0-5]))))$")]
    private static partial Regex ZeroMqAddress();

    [GeneratedRegex("^[A-Za-z0-9.-]+(,[A-Za-z0-9.-]+)*$")]
    private static partial Regex HostNames();
}
