using System.Security.Cryptography;
using System.Text;
using Msisf.Adapters.IO;
using Msisf.Core.Metadata;
using Msisf.Core.Sky;

namespace Msisf.Adapters.Catalogues;

/// <summary>
/// Reads catalogues of stars: the Hipparcos Catalogue (hip_main.dat, CDS I/239), Tycho-2 (tyc2.dat, CDS I/259), and CSV with the names of
/// its columns.
/// </summary>
public static class StarCatalogueReader
{
    /// <summary>The catalogue that comes with the program (lib/stars).</summary>
    public const string BuiltIn = "bright";

    /// <summary>Stars that a run can have: about 0.2 kB of memory each. Tycho-2 has 2.5 million.</summary>
    public const int MostStars = 5_000_000;

    private const string BuiltInFile = "bright.csv";

    private const string Needed = "A catalogue of stars";

    /// <summary>Reads a catalogue.</summary>
    /// <param name="name"><see cref="BuiltIn"/>, or the path of a file.</param>
    /// <param name="faintest">V: fainter stars are left out; null for none.</param>
    /// <exception cref="BadInputException">It can't be read, or a value is wrong; the message names file and line.</exception>
    public static StarCatalogueFile Read(string name, double? faintest)
    {
        if (name == BuiltIn)
        {
            byte[] bytes = BuiltInBytes();
            using StreamReader text = new(new MemoryStream(bytes), Encoding.UTF8);
            return Read(text, BuiltInFile, faintest) with
            {
                File = new InputFile(InputKind.StarCatalogue, BuiltInFile, bytes.Length, Convert.ToHexStringLower(SHA256.HashData(bytes))),
            };
        }

        StarCatalogueFile read = ListTable.Read(name, Needed, reader => Read(reader, name, faintest));
        return read with
        {
            File = FileErrors.ToBadInput(
                $"{name}: can't be read",
                () => new InputFile(InputKind.StarCatalogue, Path.GetFileName(name), new FileInfo(name).Length, FileHash.Sha256Of(name))),
        };
    }

    /// <summary>Reads a catalogue.</summary>
    /// <param name="fileName">For messages.</param>
    /// <param name="faintest">V: fainter stars are left out; null for none.</param>
    /// <inheritdoc cref="Read(string, double?)"/>
    public static StarCatalogueFile Read(TextReader reader, string fileName, double? faintest)
    {
        string first = reader.ReadLine() ?? throw new BadInputException($"{fileName}: it is empty. {Needed} is needed.");
        int fields = first.Split('|').Length;
        IEnumerable<Star?> rows = fields switch
        {
            HipparcosRow.Fields => Lines(first, reader, (line, number) => HipparcosRow.Read(line, fileName, number)),
            TychoRow.Fields => Lines(first, reader, (line, number) => TychoRow.Read(line, fileName, number)),
            _ => StarColumns.Read(new JoinedReader(first, reader), fileName),
        };
        List<Star> stars = [];
        HashSet<string> names = new(StringComparer.Ordinal);
        int withoutMagnitude = 0;
        int fainter = 0;
        foreach (Star? row in rows)
        {
            if (row is not { } star)
            {
                withoutMagnitude++;
            }
            else if (star.Magnitude > faintest)
            {
                fainter++;
            }
            else
            {
                stars.Add(names.Add(star.Identity)
                    ? star
                    : throw new BadInputException($"{fileName}: the star '{star.Identity}' is there twice. Remove one."));
            }

            if (stars.Count > MostStars)
            {
                throw new BadInputException(Invariant(
                    $"{fileName}: more than {MostStars} stars, which would take more than {MostStars / 5e6:F1} GB of memory. Leave out "
                        + $"faint ones with --star-limit."));
            }
        }

        return stars.Count + fainter + withoutMagnitude > 0
            ? new StarCatalogueFile(new StarCatalogue(stars), withoutMagnitude)
            : throw new BadInputException($"{fileName}: no stars in it. Give a catalogue.");
    }

    private static IEnumerable<Star?> Lines(string first, TextReader reader, Func<string, int, Star?> read)
    {
        int number = 1;
        for (string? line = first; line is not null; line = reader.ReadLine(), number++)
        {
            if (line.Length > 0)
            {
                yield return read(line, number);
            }
        }
    }

    private static byte[] BuiltInBytes()
    {
        using Stream stream = typeof(StarCatalogueReader).Assembly.GetManifestResourceStream(BuiltInFile)!;
        using MemoryStream bytes = new();
        stream.CopyTo(bytes);
        return bytes.ToArray();
    }

    /// <summary>A text whose first line has been read.</summary>
    private sealed class JoinedReader(string first, TextReader rest) : TextReader
    {
        private string? _first = first;

        public override string? ReadLine()
        {
            string? line = _first ?? rest.ReadLine();
            _first = null;
            return line;
        }
    }
}

/// <summary>A catalogue that was read.</summary>
/// <param name="WithoutMagnitude">Stars that were left out because the file has no magnitude of them.</param>
public sealed record StarCatalogueFile(StarCatalogue Catalogue, int WithoutMagnitude)
{
    /// <summary>The file; null for a text.</summary>
    public InputFile? File { get; init; }
}
