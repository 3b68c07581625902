using System.Reflection;
using System.Runtime.InteropServices;
using System.Text;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Ephemeris;

/// <summary>
/// CSPICE's own writers and readers, called without the program's lock: tests with it run alone. Matrices and lists are passed by rows.
/// </summary>
[CollectionDefinition(Name, DisableParallelization = true)]
public sealed class SpiceItself
{
    public const string Name = "CSPICE itself";

    private const string Library = "cspice-of-tests";

    static SpiceItself() => NativeLibrary.SetDllImportResolver(
        Assembly.GetExecutingAssembly(),
        (name, _, _) => name == Library ? NativeLibrary.Load(TestParts.CSpiceLibrary!) : nint.Zero);

    /// <summary>Writes a new SPK.</summary>
    internal static void WriteSpk(string path, Action<int> write)
    {
        spkopn_c(Bytes(path), Bytes("test"), 0, out int handle);
        write(handle);
        ThrowIfFailed();
        spkcls_c(handle);
        ThrowIfFailed();
    }

    /// <summary>Writes a new CK.</summary>
    internal static void WriteCk(string path, Action<int> write)
    {
        ckopn_c(Bytes(path), Bytes("test"), 0, out int handle);
        write(handle);
        ThrowIfFailed();
        ckcls_c(handle);
        ThrowIfFailed();
    }

    /// <summary>A text as C has it.</summary>
    internal static byte[] Bytes(string text) => Encoding.UTF8.GetBytes(text + '\0');

    internal static void ThrowIfFailed()
    {
        if (failed_c() != 0)
        {
            byte[] message = new byte[1841];
            getmsg_c(Bytes("LONG"), message.Length, message);
            reset_c();
            throw new InvalidOperationException(Encoding.UTF8.GetString(message).TrimEnd('\0', ' '));
        }
    }

    [DllImport(Library)]
    private static extern int failed_c();

    [DllImport(Library)]
    private static extern void reset_c();

    [DllImport(Library)]
    private static extern void getmsg_c(byte[] option, int length, byte[] message);

    [DllImport(Library)]
    private static extern void spkopn_c(byte[] path, byte[] name, int comments, out int handle);

    [DllImport(Library)]
    private static extern void spkcls_c(int handle);

    [DllImport(Library)]
    private static extern void ckopn_c(byte[] path, byte[] name, int comments, out int handle);

    [DllImport(Library)]
    private static extern void ckcls_c(int handle);

    [DllImport(Library)]
    internal static extern void spkw01_(
        ref int handle, ref int body, ref int center, byte[] frame, ref double first, ref double last, byte[] id, ref int count,
        double[] lines, double[] epochs, int frameLength, int idLength);

    [DllImport(Library)]
    internal static extern void spkw21_(
        ref int handle, ref int body, ref int center, byte[] frame, ref double first, ref double last, byte[] id, ref int count,
        ref int size, double[] lines, double[] epochs, int frameLength, int idLength);

    [DllImport(Library)]
    internal static extern void spkw02_c(
        int handle, int body, int center, byte[] frame, double first, double last, byte[] id, double length, int count, int degree,
        double[] data, double begin);

    [DllImport(Library)]
    internal static extern void spkw03_c(
        int handle, int body, int center, byte[] frame, double first, double last, byte[] id, double length, int count, int degree,
        double[] data, double begin);

    [DllImport(Library)]
    internal static extern void spkw05_c(
        int handle, int body, int center, byte[] frame, double first, double last, byte[] id, double gm, int count, double[] states,
        double[] epochs);

    [DllImport(Library)]
    internal static extern void spkw08_c(
        int handle, int body, int center, byte[] frame, double first, double last, byte[] id, int degree, int count, double[] states,
        double begin, double step);

    [DllImport(Library)]
    internal static extern void spkw12_c(
        int handle, int body, int center, byte[] frame, double first, double last, byte[] id, int degree, int count, double[] states,
        double begin, double step);

    [DllImport(Library)]
    internal static extern void spkw09_c(
        int handle, int body, int center, byte[] frame, double first, double last, byte[] id, int degree, int count, double[] states,
        double[] epochs);

    [DllImport(Library)]
    internal static extern void spkw13_c(
        int handle, int body, int center, byte[] frame, double first, double last, byte[] id, int degree, int count, double[] states,
        double[] epochs);

    [DllImport(Library)]
    internal static extern void spkw18_c(
        int handle, int subtype, int body, int center, byte[] frame, double first, double last, byte[] id, int degree, int count,
        double[] packets, double[] epochs);

    [DllImport(Library)]
    internal static extern void ckw01_c(
        int handle, double first, double last, int instrument, byte[] frame, int hasRates, byte[] id, int count, double[] ticks,
        double[] quaternions, double[] rates);

    [DllImport(Library)]
    internal static extern void ckw02_c(
        int handle, double first, double last, int instrument, byte[] frame, byte[] id, int count, double[] starts, double[] stops,
        double[] quaternions, double[] rates, double[] secondsPerTick);

    [DllImport(Library)]
    internal static extern void ckw03_c(
        int handle, double first, double last, int instrument, byte[] frame, int hasRates, byte[] id, int count, double[] ticks,
        double[] quaternions, double[] rates, int intervals, double[] starts);

    [DllImport(Library)]
    internal static extern void ckw04b_(
        ref int handle, ref double first, ref int instrument, byte[] frame, ref int hasRates, byte[] id, int frameLength, int idLength);

    [DllImport(Library)]
    internal static extern void ckw04a_(ref int handle, ref int count, int[] sizes, double[] packets, double[] ticks);

    [DllImport(Library)]
    internal static extern void ckw04e_(ref int handle, ref double last);

    [DllImport(Library)]
    internal static extern void ckw05_c(
        int handle, int subtype, int degree, double first, double last, int instrument, byte[] frame, int hasRates, byte[] id, int count,
        double[] ticks, double[] packets, double secondsPerTick, int intervals, double[] starts);

    [DllImport(Library)]
    internal static extern void ckw06_(
        ref int handle, ref int instrument, byte[] frame, ref int hasRates, ref double first, ref double last, byte[] id, ref int pieces,
        int[] counts, int[] subtypes, int[] degrees, double[] packets, double[] secondsPerTick, double[] ticks, double[] bounds,
        ref int isLaterAtBorder, int frameLength, int idLength);

    [DllImport(Library)]
    internal static extern void ckgp_c(
        int instrument, double ticks, double tolerance, byte[] frame, double[] matrix, out double ticksFound, out int isFound);

    [DllImport(Library)]
    internal static extern void ckgpav_c(
        int instrument, double ticks, double tolerance, byte[] frame, double[] matrix, double[] rate, out double ticksFound,
        out int isFound);

    [DllImport(Library)]
    internal static extern void pxform_c(byte[] from, byte[] to, double tdbSeconds, double[] matrix);

    [DllImport(Library)]
    internal static extern void sxform_c(byte[] from, byte[] to, double tdbSeconds, double[] ofStates);

    [DllImport(Library)]
    internal static extern void spkpos_c(
        byte[] target, double tdbSeconds, byte[] frame, byte[] correction, byte[] observer, double[] positionKm, out double lightTime);

    [DllImport(Library)]
    internal static extern void furnsh_c(byte[] path);

    [DllImport(Library)]
    internal static extern void unload_c(byte[] path);

    [DllImport(Library)]
    internal static extern void gdpool_c(byte[] name, int start, int room, out int count, double[] values, out int isFound);

    [DllImport(Library)]
    internal static extern void tparse_c(byte[] text, int length, out double seconds, byte[] error);

    [DllImport(Library)]
    internal static extern void sce2c_c(int clock, double tdbSeconds, out double ticks);

    [DllImport(Library)]
    internal static extern void sct2e_c(int clock, double ticks, out double tdbSeconds);

    [DllImport(Library)]
    internal static extern void str2et_c(byte[] text, out double tdbSeconds);

    [DllImport(Library)]
    internal static extern double unitim_c(double seconds, byte[] from, byte[] to);

    [DllImport(Library)]
    internal static extern void spkgeo_c(int target, double tdbSeconds, byte[] frame, int observer, double[] state, out double lightTime);

    [DllImport(Library)]
    internal static extern void bods2c_c(byte[] name, out int number, out int isFound);
}
