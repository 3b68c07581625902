using System.Xml.Linq;
using Msisf.Adapters.Metadata;
using Msisf.Core.Camera;
using Msisf.Core.Metadata;
using static Msisf.Adapters.CameraExport.MetaFileFrame;

namespace Msisf.Adapters.CameraExport;

/// <summary>How the image of a meta file was scanned, and the states of its exposures.</summary>
/// <param name="Kind">What an exposure adds.</param>
/// <param name="Period">s from one exposure to the next.</param>
/// <param name="RowsOfExposure">px: height of the camera that is exposed.</param>
/// <param name="GrowsUpwards">Whether the first exposure is the lowest of the image.</param>
/// <param name="FlipsFramelets">Whether the rows of a framelet are read from the lowest to the topmost.</param>
/// <param name="States">Of the exposures, the first one's first.</param>
internal sealed record ScanRows(
    ScanKind Kind, double Period, int RowsOfExposure, bool GrowsUpwards, bool FlipsFramelets, CameraState[] States)
{
    /// <summary>px: rows of the detector above the one to which the meta file's K belongs, which is that of the image's top row.</summary>
    public int RowsAbove => FlipsFramelets ? RowsOfExposure - 1 : 0;

    /// <summary>Reads it.</summary>
    /// <param name="height">px: of the image.</param>
    /// <param name="path">For messages.</param>
    /// <param name="rowStates">The states of all rows from elsewhere; null if they are not known.</param>
    /// <exception cref="BadInputException">The states of all rows are nowhere.</exception>
    /// <exception cref="FormatException">A number is missing.</exception>
    public static ScanRows Read(XElement scan, int height, string path, Func<double[]?> rowStates)
    {
        ScanKind kind = ScanXml.KindOf(Text(scan, "kind")) ?? throw new FormatException($"the scan '{Text(scan, "kind")}' is not known.");
        int count = int.Parse(Text(scan, "exposures"), NumberStyles.None, CultureInfo.InvariantCulture);
        if (count < 1 || count > height || height % count != 0)
        {
            throw new FormatException(Invariant($"{count} exposures can't make {height} rows."));
        }

        bool flips = kind == ScanKind.PushFrame && (scan.Attribute("flip")?.Value ?? throw new BadInputException(
            $"{path}: the file is of a version of msis that did not write yet how framelets are read. Make the image again.")) == "yes";
        int rows = height / count;
        double[] numbers = NumbersOf(scan, height, path, rowStates);
        CameraState[] states = [.. Enumerable.Range(0, count).Select(exposure => StateOf(numbers, exposure * rows))];
        bool growsUpwards = states[0].Seconds > states[^1].Seconds;
        return new ScanRows(
            kind, Number(Text(scan, "period")), kind == ScanKind.RollingShutter ? height : rows, growsUpwards, flips,
            growsUpwards ? [.. states.Reverse()] : states);
    }

    /// <summary>The scan for camera models.</summary>
    /// <param name="heightOverTerrain">m: of the camera.</param>
    public ExportedScan Describe(double heightOverTerrain) =>
        new(Kind, Period, GrowsUpwards, FlipsFramelets, States, heightOverTerrain);

    /// <summary>The numbers of all rows, with the digits of the meta file: whichever file they are from, they are the same.</summary>
    private static double[] NumbersOf(XElement scan, int height, string path, Func<double[]?> rowStates)
    {
        XElement[] rows = [.. scan.Elements("Row")];
        double[]? numbers = rows.Length == height
            ? [.. rows.SelectMany(Numbers)]
            : rowStates()?.Select(number => Number(LongE.ToText(number))).ToArray();
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
