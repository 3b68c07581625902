using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Json.Nodes;
using Msisf.Adapters.Manifest;

namespace Msisf.App.DataSets;

/// <summary>The card of a data set: what it was asked to be, what it is, and what it is made from.</summary>
internal sealed record DataSetCard
{
    /// <summary>Name of the card for readers.</summary>
    public const string MarkdownName = "card.md";

    /// <summary>Name of the card for programs.</summary>
    public const string JsonName = "card.json";

    public const string PlotsName = "card.svg";

    private static readonly JsonWriterOptions Indented = new()
    {
        Indented = true,
        NewLine = "\n",
        Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping,
    };

    public required DataSetSpec Spec { get; init; }

    public required DrawnStates Drawn { get; init; }

    /// <summary>How their numbers are distributed.</summary>
    public required IReadOnlyList<Histogram> Histograms { get; init; }

    /// <summary>Canonical arguments of the frames.</summary>
    public required string Arguments { get; init; }

    public required string Version { get; init; }

    /// <summary>Width and height of the images, px, and K in the form of OpenCV, by rows.</summary>
    public required (int Width, int Height, double[][] K) Camera { get; init; }

    public required IReadOnlyList<DataSetSource> Sources { get; init; }

    /// <summary>States and index.</summary>
    public required IReadOnlyList<OutputFile> Files { get; init; }

    /// <summary>SHA-256 of the names and checksums of all files of all images, in their order.</summary>
    public required string Content { get; init; }

    private string Again => $"msis dataset {Path.GetFileName(Spec.Path)} --frames NUMBER --output-dir again";

    /// <summary>Writes the card for programs.</summary>
    public void WriteJson(Stream stream)
    {
        JsonObject card = new()
        {
            ["name"] = Spec.Name,
            ["description"] = Spec.Description,
            ["licence"] = Spec.Licence,
            ["version"] = Version,
            ["file"] = Path.GetFileName(Spec.Path),
            ["fileSha256"] = Spec.Sha256,
            ["seed"] = Spec.Seed,
            ["noiseSeed"] = Spec.NoiseSeed,
            ["sampling"] = Spec.IsEven ? "kronecker" : "random",
            ["images"] = Spec.Images,
            ["pairs"] = Spec.HasPairs,
            ["again"] = Again,
            ["contentSha256"] = Content,
            ["camera"] = new JsonObject
            {
                ["width"] = Camera.Width,
                ["height"] = Camera.Height,
                ["K"] = new JsonArray([.. Camera.K.Select(Numbers)]),
            },
            ["options"] = Arguments,
            ["conditions"] = new JsonObject
            {
                ["ground"] = Spec.Accept.Ground,
                ["lit"] = Spec.Accept.Lit,
                ["sunElevation"] = Spec.Accept.SunElevation is { } range ? new JsonArray(range.Min, range.Max) : null,
            },
            ["splits"] = new JsonArray([.. Drawn.Splits.Select(draw => new JsonObject
            {
                ["name"] = draw.Split.Name,
                ["images"] = draw.Split.Count * (Spec.HasPairs ? 2 : 1),
                ["regions"] = new JsonArray([.. draw.Split.Regions.Select(
                    region => new JsonArray(region.South, region.North, region.West, region.East))]),
                ["candidates"] = draw.Candidates,
                ["rejected"] = new JsonObject(draw.Rejected.Select(entry => KeyValuePair.Create(entry.Key, (JsonNode?)entry.Value))),
            })]),
            ["distributions"] = new JsonArray([.. Histograms.Select(histogram => new JsonObject
            {
                ["name"] = histogram.Name,
                ["unit"] = histogram.Unit,
                ["asked"] = histogram.Asked?.ToString(),
                ["min"] = histogram.Min,
                ["mean"] = histogram.Mean,
                ["max"] = histogram.Max,
                ["from"] = histogram.From,
                ["width"] = histogram.Width,
                ["counts"] = Numbers(histogram.Counts.Select(count => (double)count)),
                ["expected"] = Numbers(histogram.Expected),
            })]),
            ["sources"] = new JsonArray([.. Sources.Select(source => new JsonObject
            {
                ["kind"] = source.Kind,
                ["name"] = source.Name,
                ["sha256"] = source.Sha256,
                ["licence"] = source.Licence,
            })]),
            ["files"] = new JsonArray([.. Files.Select(file => new JsonObject
            {
                ["name"] = file.Name,
                ["bytes"] = file.Bytes,
                ["sha256"] = file.Sha256,
            })]),
        };
        using Utf8JsonWriter writer = new(stream, Indented);
        card.WriteTo(writer);
        writer.Flush();
        stream.WriteByte((byte)'\n');
    }

    /// <summary>Writes the card for readers.</summary>
    public void WriteMarkdown(TextWriter writer)
    {
        writer.WriteLine($"# {Spec.Name}\n");
        if (Spec.Description is { } description)
        {
            writer.WriteLine($"{description}\n");
        }

        string pairs = Spec.HasPairs ? ", two and two of which are a pair" : string.Empty;
        writer.WriteLine(Invariant(
            $"{Spec.Images} images of {Camera.Width} x {Camera.Height} px{pairs}, made by msis {Version} from "
                + $"{Path.GetFileName(Spec.Path)} (SHA-256 {Spec.Sha256}). States at {(Spec.IsEven ? "Kronecker's" : "random")} points, "
                + $"seed {Spec.Seed}."));
        writer.WriteLine($"Licence: {Spec.Licence ?? "not stated; see the sources"}.\n");
        writer.WriteLine("Any image again, to the byte:\n");
        writer.WriteLine($"```sh\n{Again}\n```\n");
        writer.WriteLine("## Splits\n");
        writer.WriteLine(
            "An image of a split shows nothing beyond one of its regions (south, north, west, east in degrees); no region touches one of "
                + "another split.\n");
        Table(
            writer, ["split", "images", "states looked at", "rejected", "regions"],
            Drawn.Splits.Select(draw => (string[])[
                draw.Split.Name, Number(draw.Split.Count * (Spec.HasPairs ? 2 : 1)), Number(draw.Candidates),
                string.Join(", ", draw.Rejected.Select(entry => $"{entry.Key} {entry.Value}").DefaultIfEmpty("none")),
                string.Join("; ", draw.Split.Regions.Select(region =>
                    string.Join(' ', new[] { region.South, region.North, region.West, region.East }.Select(Number)))),
            ]));
        writer.WriteLine("## Distributions\n");
        string elevation = Spec.Accept.SunElevation is { } range
            ? Invariant($", Sun from {range.Min:R} to {range.Max:R} degrees high")
            : string.Empty;
        writer.WriteLine(Invariant(
            $"Conditions: at least {Spec.Accept.Ground:R} of the image is ground, {Spec.Accept.Lit:R} of that is lit{elevation}. "
                + $"Bars: obtained; lines: asked for, before the conditions.\n"));
        writer.WriteLine($"![Histograms]({PlotsName})\n");
        Table(
            writer, ["number", "asked for", "min", "mean", "max"],
            Histograms.Select(histogram => (string[])[
                histogram.Unit.Length > 0 ? $"{histogram.Name}, {histogram.Unit}" : histogram.Name, histogram.Asked?.ToString() ?? "-",
                Number(histogram.Min), Number(histogram.Mean), Number(histogram.Max)]));
        writer.WriteLine("## Made from\n");
        Table(
            writer, ["source", "name", "licence", "SHA-256"],
            Sources.Select(source => (string[])[source.Kind, source.Name, source.Licence, source.Sha256]));
        writer.WriteLine($"Options: `{Arguments}`\n");
        writer.WriteLine("## Files\n");
        Table(
            writer, ["file", "bytes", "SHA-256"],
            Files.Select(file => (string[])[file.Name, Number(file.Bytes), file.Sha256]));
        writer.WriteLine(
            $"`{ManifestFile.Name}` has the checksum of each image's files. That of all of them (names and checksums): {Content}");
    }

    private static void Table(TextWriter writer, string[] head, IEnumerable<string[]> rows)
    {
        writer.WriteLine($"| {string.Join(" | ", head)} |");
        writer.WriteLine($"|{string.Concat(head.Select(_ => "---|"))}");
        foreach (string[] row in rows)
        {
            writer.WriteLine($"| {string.Join(" | ", row.Select(cell => cell.Replace("|", "\\|", StringComparison.Ordinal)))} |");
        }

        writer.WriteLine();
    }

    private static JsonArray Numbers(IEnumerable<double> numbers) => new([.. numbers.Select(number => (JsonNode)number)]);

    private static string Number(double number) => number.ToString(Math.Abs(number) >= 1e6 ? "G10" : "G6", CultureInfo.InvariantCulture);

    private static string Number(long number) => number.ToString(CultureInfo.InvariantCulture);
}
