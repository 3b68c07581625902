using System.Buffers.Binary;
using Msisf.Adapters.Raster.Pds;

namespace Msisf.Adapters.RealImages;

/// <summary>The tables that ISIS's spiceinit puts into a cube, or beside a detached label.</summary>
public sealed class CubeTables
{
    private const int BytesOfNumber = sizeof(double);

    /// <summary>A table of more records is not a table: a full NAC has 53,000 lines.</summary>
    private const int MostRecords = 10_000_000;

    private readonly string _path;
    private readonly PdsObject _label;

    internal CubeTables(string path, PdsObject label) => (_path, _label) = (path, label);

    /// <summary>The kernels that the cube's group Kernels lists, as it writes them.</summary>
    public IReadOnlyList<string> Kernels =>
    [
        .. _label.FindObject("Kernels")?.Values
            .SelectMany(pair => pair.Value.Items ?? [pair.Value])
            .Select(item => item.Text)
            .Where(text => OptionOf(text) is not null)
            .Distinct() ?? [],
    ];

    /// <summary>The options that name the cube's kernels; empty without kernels.</summary>
    public string Options => string.Join(' ', Kernels.Select(kernel => $"{OptionOf(kernel)} {kernel}"));

    private static string? OptionOf(string kernel) => Path.GetExtension(kernel).ToLowerInvariant() switch
    {
        ".bsp" => "--spk",
        ".bc" => "--ck",
        ".tsc" or ".tf" or ".ti" or ".tpc" or ".bpc" or ".tls" => "--kernels",
        _ => null,
    };

    /// <summary>Reads a table of numbers.</summary>
    /// <param name="name">E.g. "InstrumentPointing".</param>
    /// <param name="columns">The columns that it must have, in this order at its beginning or, of the last one, at its end.</param>
    /// <exception cref="BadInputException">It is missing, of another form, or cut off.</exception>
    internal CubeTable Read(string name, IReadOnlyList<string> columns)
    {
        PdsObject table = _label.All.FirstOrDefault(found => found.Name == "Table" && found.Find("Name")?.Text == name)
            ?? throw new BadInputException(
                $"{_path}: it has no table {name}. Run ISIS's spiceinit on the cube, or name kernels: "
                    + (Kernels.Count > 0 ? $"the cube lists {Options}." : "--spk, --ck and --kernels."));
        string[] fields = [.. table.All.Where(part => part.Name == "Field").Select(field => field.RequiredText("Name"))];
        bool areNumbers = table.All.Where(part => part.Name == "Field")
            .All(field => field.RequiredText("Type") == "Double" && field.RequiredInteger("Size", 1, 1) == 1);
        if (!areNumbers || !fields.Take(columns.Count - 1).SequenceEqual(columns.Take(columns.Count - 1)) || fields[^1] != columns[^1])
        {
            throw new BadInputException(
                $"{_path}: table {name} has the columns {string.Join(", ", fields)}; {string.Join(", ", columns)} are needed. Polynomials "
                    + "of jigsaw are not read: run spiceinit on the cube again.");
        }

        int records = table.RequiredInteger("Records", 1, MostRecords);
        string file = table.Find("^Table") is { } other
            ? Path.Combine(Path.GetDirectoryName(_path) ?? string.Empty, Path.GetFileName(other.Text))
            : _path;
        return new CubeTable(name, fields, Numbers(file, table, records, fields.Length), table);
    }

    private static double[][] Numbers(string file, PdsObject table, int records, int columns)
    {
        long start = (long)table.RequiredNumber("StartByte") - 1;
        byte[] bytes = new byte[records * columns * BytesOfNumber];
        bool isWhole = FileErrors.ToBadInput($"{file}: can't be read", () =>
        {
            using FileStream stream = File.OpenRead(file);
            if (start < 0 || stream.Length < start + bytes.Length)
            {
                return false;
            }

            stream.Position = start;
            stream.ReadExactly(bytes);
            return true;
        });
        if (!isWhole)
        {
            throw new BadInputException(Invariant(
                $"{file}: table {table.RequiredText("Name")} needs {bytes.Length} bytes from byte {start + 1} on: the file is cut off. Get "
                    + $"it again."));
        }

        bool isBigEndian = table.Find("ByteOrder")?.Text == "Msb";
        double[][] rows = [.. Enumerable.Range(0, records).Select(row => Enumerable.Range(0, columns).Select(column =>
        {
            ReadOnlySpan<byte> number = bytes.AsSpan(((row * columns) + column) * BytesOfNumber);
            return isBigEndian ? BinaryPrimitives.ReadDoubleBigEndian(number) : BinaryPrimitives.ReadDoubleLittleEndian(number);
        }).ToArray())];
        return rows.All(row => row.All(double.IsFinite))
            ? rows
            : throw new BadInputException($"{file}: table {table.RequiredText("Name")} has numbers that are not finite. Get it again.");
    }
}

/// <summary>A table of numbers.</summary>
/// <param name="Columns">Names of its columns.</param>
/// <param name="Label">Its keywords.</param>
internal sealed record CubeTable(string Name, IReadOnlyList<string> Columns, double[][] Rows, PdsObject Label);
