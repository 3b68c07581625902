using System.Text;

namespace Msisf.Adapters.Interop;

/// <summary>Writes the checksums of a unit as ffpcks does, but without the time of day that its comments have.</summary>
internal static unsafe class FitsChecksums
{
    /// <summary>CFITSIO's name for a comment that stays.</summary>
    private const string Unchanged = "&";

    /// <summary>Writes both, of what CFITSIO has in memory.</summary>
    /// <param name="file">The file; <see cref="CFitsio.Gate"/> is held.</param>
    public static void Put(CFitsioHandle file, ref int status)
    {
        PutEmpty(file, ref status);
        CFitsioNative.ffgcks(file, out nuint dataSum, out _, ref status);
        CFitsioNative.ffmkys(file, "DATASUM", dataSum.ToString(CultureInfo.InvariantCulture), Unchanged, ref status);
        CFitsioNative.ffgcks(file, out _, out nuint unitSum, ref status);
        byte* text = stackalloc byte[CFitsioNative.ChecksumLength];
        CFitsioNative.ffesum(unitSum, complement: 1, text);
        CFitsioNative.ffmkys(file, "CHECKSUM", Encoding.ASCII.GetString(text, CFitsioNative.ChecksumLength - 1), Unchanged, ref status);
    }

    /// <summary>Writes that of the data, and zeros in place of that of the unit.</summary>
    /// <param name="file">The file; <see cref="CFitsio.Gate"/> is held.</param>
    /// <param name="dataSum">That of data that CFITSIO does not have.</param>
    /// <param name="status">CFITSIO's status.</param>
    public static void PutDataSum(CFitsioHandle file, uint dataSum, ref int status)
    {
        PutEmpty(file, ref status);
        CFitsioNative.ffmkys(file, "DATASUM", dataSum.ToString(CultureInfo.InvariantCulture), Unchanged, ref status);
        CFitsioNative.ffflus(file, ref status);
    }

    private static void PutEmpty(CFitsioHandle file, ref int status)
    {
        CFitsioNative.ffpkys(file, "CHECKSUM", "0000000000000000", "HDU checksum", ref status);
        CFitsioNative.ffpkys(file, "DATASUM", "0", "data unit checksum", ref status);
        CFitsioNative.ffflus(file, ref status); // writes the END card behind them, and the fill behind the data
    }
}
