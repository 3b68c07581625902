using System.Buffers.Binary;
using System.Text;
using System.Xml.Linq;
using Msisf.Adapters.Layers;
using Msisf.Adapters.Metadata;
using Msisf.Core.Camera;
using Msisf.Core.Metadata;
using static Msisf.Adapters.CameraExport.MetaFileFrame;

namespace Msisf.Adapters.CameraExport;

/// <summary>How the image of a meta file was scanned, and the states of its exposures.</summary>
internal static class ScanRows
{
    /// <summary>How a frame was scanned, with the digits of its meta file.</summary>
    public static ExportedScan Of(Scan scan, FrameMetadata frame) => Of(
        scan.Kind, scan.Count, scan.Period, scan is { Kind: ScanKind.PushFrame, FlipsFramelets: true },
        [.. RowStates.Of(frame).Select(LongE.Round)], LongE.Round(frame.HeightOverTerrain));

    /// <summary>Reads it.</summary>
    /// <param name="height">Height of the image, px.</param>
    /// <param name="path">Path of the meta file, beside which the states of all rows may be.</param>
    /// <param name="heightOverTerrain">Height of the camera over the terrain, m.</param>
    /// <exception cref="BadInputException">The states of all rows are nowhere.</exception>
    /// <exception cref="FormatException">A number is missing.</exception>
    public static ExportedScan Read(XElement scan, int height, string path, double heightOverTerrain)
    {
        ScanKind kind = ScanXml.KindOf(Text(scan, "kind")) ?? throw new FormatException($"the scan '{Text(scan, "kind")}' is not known.");
        int count = int.Parse(Text(scan, "exposures"), NumberStyles.None, CultureInfo.InvariantCulture);
        if (count < 1 || count > height || height % count != 0)
        {
            throw new FormatException(Invariant($"{count} exposures can't make {height} rows."));
        }

        bool flips = kind == ScanKind.PushFrame && (scan.Attribute("flip")?.Value ?? throw new BadInputException(
            $"{path}: the file is of a version of msis that did not write yet how framelets are read. Make the image again.")) == "yes";
        return Of(kind, count, Number(Text(scan, "period")), flips, NumbersOf(scan, height, path), heightOverTerrain);
    }

    private static ExportedScan Of(ScanKind kind, int count, double period, bool flips, double[] numbers, double heightOverTerrain)
    {
        int rows = numbers.Length / RowStates.Names.Count / count;
        CameraState[] states = [.. Enumerable.Range(0, count).Select(exposure => StateOf(numbers, exposure * rows))];
        bool growsUpwards = states[0].Seconds > states[^1].Seconds;
        return new ExportedScan(kind, period, growsUpwards, flips, growsUpwards ? [.. states.Reverse()] : states, heightOverTerrain);
    }

    /// <summary>The numbers of all rows, with the digits of the meta file: whichever file they are from, they are the same.</summary>
    private static double[] NumbersOf(XElement scan, int height, string path)
    {
        XElement[] rows = [.. scan.Elements("Row")];
        double[]? numbers = rows.Length == height
            ? [.. rows.SelectMany(Numbers)]
            : RowStateFiles.Find(path)?.Select(LongE.Round).ToArray();
        if (numbers is null)
        {
            throw new BadInputException(Invariant(
                $"{path}: it has the states of {rows.Length} rows of {height}, and all are needed; layers have them too, but none of their "
                    + $"files is beside it ({RowStateFiles.NamesFor(path)}). Make the image with --camera-model, --layers or --gridV 1."));
        }

        int columns = RowStates.Names.Count;
        bool Has(XElement row) => Numbers(row).SequenceEqual(numbers.Skip((RowOf(row) - 1) * columns).Take(columns));
        return numbers.Length == height * columns && rows.All(Has) ? numbers : throw new BadInputException(
            $"{path}: its rows and those of the layers beside it ({RowStateFiles.NamesFor(path)}) belong to different images. Make the "
                + $"image again.");
    }

    private static int RowOf(XElement row) => int.Parse(Text(row, "v"), NumberStyles.None, CultureInfo.InvariantCulture);

    private static IEnumerable<double> Numbers(XElement row) => RowStates.Names.Select(name => Number(Text(row, name)));

    private static CameraState StateOf(double[] numbers, int row)
    {
        ReadOnlySpan<double> n = numbers.AsSpan(row * RowStates.Names.Count, RowStates.Names.Count);
        return new CameraState(
            new Vector3D(n[1], n[2], n[3]), UnitQuaternion.FromComponents(n[4], n[5], n[6], n[7]), n[0], new Vector3D(n[8], n[9], n[10]));
    }
}

/// <summary>Reads the states of a scan's rows from the layers beside its meta file.</summary>
internal static class RowStateFiles
{
    private const int FitsBlock = 2880;

    private const int FitsCard = 80;

    /// <summary>The names of the files in which they can be.</summary>
    /// <param name="metaFile">Path of the meta file.</param>
    public static string NamesFor(string metaFile)
    {
        string stem = Path.GetFileNameWithoutExtension(metaFile);
        return $"{stem}.rowstates.npy, {stem}.fits";
    }

    /// <summary>Reads them.</summary>
    /// <param name="metaFile">Path of the meta file.</param>
    /// <returns>The numbers, row by row (<see cref="RowStates"/>); null if no file has them.</returns>
    /// <exception cref="BadInputException">The file is damaged.</exception>
    public static double[]? Find(string metaFile)
    {
        string npy = Path.ChangeExtension(metaFile, ".rowstates.npy");
        string fits = Path.ChangeExtension(metaFile, ".fits");
        return File.Exists(npy) ? Read(npy, OfNpy) : File.Exists(fits) ? Read(fits, OfFits) : null;
    }

    private static double[]? Read(string path, Func<Stream, double[]?> read)
    {
        try
        {
            using FileStream stream = File.OpenRead(path);
            return read(stream);
        }
        catch (Exception exception) when (exception is EndOfStreamException or FormatException or OverflowException)
        {
            throw new BadInputException($"{path}: it is damaged: {exception.Message} Make the image again.", exception);
        }
    }

    private static double[] OfNpy(Stream stream)
    {
        try
        {
            (double[] values, int width) = NpyFile.ReadReals(stream);
            return width == RowStates.Names.Count ? values : throw new InvalidDataException();
        }
        catch (InvalidDataException exception)
        {
            throw new FormatException("its head is not that of row states.", exception);
        }
    }

    /// <summary>The extension ROWSTATES, behind whatever is before it.</summary>
    private static double[]? OfFits(Stream stream)
    {
        while (stream.Position < stream.Length)
        {
            Dictionary<string, string> keys = FitsHead(stream);
            long Key(string key, long otherwise) =>
                keys.TryGetValue(key, out string? text) ? long.Parse(text, CultureInfo.InvariantCulture) : otherwise;
            long axes = Key("NAXIS", 0);
            long count = axes == 0 ? 0 : 1;
            for (int axis = 1; axis <= axes; axis++)
            {
                count = checked(count * Key(Invariant($"NAXIS{axis}"), 0));
            }

            long bytes = checked(Math.Abs(Key("BITPIX", 8)) / 8 * Key("GCOUNT", 1) * (Key("PCOUNT", 0) + count));
            if (keys.GetValueOrDefault("EXTNAME") == "ROWSTATES")
            {
                byte[] data = Bytes(stream, bytes);
                return [.. Enumerable.Range(0, data.Length / sizeof(double))
                    .Select(i => BinaryPrimitives.ReadDoubleBigEndian(data.AsSpan(i * sizeof(double))))];
            }

            stream.Position += (bytes + FitsBlock - 1) / FitsBlock * FitsBlock;
        }

        return null;
    }

    private static Dictionary<string, string> FitsHead(Stream stream)
    {
        Dictionary<string, string> keys = [];
        while (true)
        {
            string block = Encoding.ASCII.GetString(Bytes(stream, FitsBlock));
            for (int at = 0; at < FitsBlock; at += FitsCard)
            {
                string key = block.Substring(at, 8).TrimEnd();
                if (key == "END")
                {
                    return keys;
                }

                if (block.Substring(at + 8, 2) == "= ")
                {
                    keys[key] = block.Substring(at + 10, FitsCard - 10).Split('/')[0].Trim(' ', '\'').TrimEnd();
                }
            }
        }
    }

    private static byte[] Bytes(Stream stream, long count)
    {
        if (count < 0 || count > stream.Length - stream.Position)
        {
            throw new EndOfStreamException("it is shorter than its head says.");
        }

        byte[] bytes = new byte[count];
        stream.ReadExactly(bytes);
        return bytes;
    }
}
