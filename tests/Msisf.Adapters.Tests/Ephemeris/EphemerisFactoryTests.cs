using Msisf.Adapters.Ephemeris;
using Msisf.Core.Errors;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Ephemeris;

/// <summary>The choices that need no CSPICE; Msisf.Integration.Tests has the others.</summary>
public sealed class EphemerisFactoryTests : IDisposable
{
    private static readonly string[] Kernels = [Path.Combine(TestParts.Kernels, "msisf.tm")];
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Open_BuiltIn_SaysSo()
    {
        using OpenedEphemeris opened = EphemerisFactory.Open(
            new EphemerisRequest(EphemerisChoice.BuiltIn, Kernels, _folder.Path, CSpicePath: null));

        Assert.Equal("Ephemeris: built-in kernel reader, as asked for.", opened.Notice);
        Assert.Equal("built-in kernel reader", opened.Engine.EngineName);
    }

    [Fact]
    public void Open_AutoWithoutTheNamedLibrary_FallsBackAndSaysWhy()
    {
        string missing = Path.Combine(_folder.Path, "libcspice.so");

        using OpenedEphemeris opened = EphemerisFactory.Open(new EphemerisRequest(EphemerisChoice.Auto, Kernels, _folder.Path, missing));

        Assert.Equal(
            $"Ephemeris: built-in kernel reader, because CSPICE's library could not be loaded; looked at {missing} (no such file).",
            opened.Notice);
    }

    [Fact]
    public void Open_CSpiceNowhere_ListsThePlaces()
    {
        ExternalPartException failure = Assert.Throws<ExternalPartException>(() =>
            EphemerisFactory.Open(new EphemerisRequest(EphemerisChoice.CSpice, Kernels, _folder.Path, CSpicePath: "")));

        Assert.Contains(Path.Combine(AppContext.BaseDirectory, "libcspice.so"), failure.Message, StringComparison.Ordinal);
        Assert.Contains(Path.Combine(_folder.Path, "lib", "native", "libcspice.so"), failure.Message, StringComparison.Ordinal);
        Assert.Contains("libcspice.so (not installed in the system)", failure.Message, StringComparison.Ordinal);
        Assert.Contains("--ephemeris builtin", failure.Message, StringComparison.Ordinal);
        Assert.Equal(3, failure.ExitCode);
    }

    [Fact]
    public void Open_CSpiceIsNoLibrary_GivesTheLoadersWords()
    {
        string text = _folder.Write("libcspice.so", "not a library");

        ExternalPartException failure = Assert.Throws<ExternalPartException>(() =>
            EphemerisFactory.Open(new EphemerisRequest(EphemerisChoice.CSpice, Kernels, _folder.Path, text)));

        Assert.StartsWith(
            $"CSPICE's library could not be loaded; looked at {text} (file too short). ", failure.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Open_CSpiceForAnotherProcessor_GivesTheLoadersWords()
    {
        // An ELF header of a 64-bit little-endian shared object for AArch64 (machine 183).
        byte[] header = new byte[4096];
        new byte[] { 0x7F, (byte)'E', (byte)'L', (byte)'F', 2, 1, 1, 0 }.CopyTo(header, 0);
        header[16] = 3;
        header[18] = 183;
        header[20] = 1;
        string library = _folder.Write("libcspice.so", header);

        ExternalPartException failure = Assert.Throws<ExternalPartException>(() =>
            EphemerisFactory.Open(new EphemerisRequest(EphemerisChoice.CSpice, Kernels, _folder.Path, library)));

        Assert.Contains($"{library} (cannot open shared object file", failure.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Open_LibraryThatIsNotCSpice_SaysSo()
    {
        ExternalPartException failure = Assert.Throws<ExternalPartException>(() =>
            EphemerisFactory.Open(new EphemerisRequest(EphemerisChoice.CSpice, Kernels, _folder.Path, SystemMathLibrary())));

        Assert.Contains("(a library, but not CSPICE)", failure.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Open_KernelMissing_IsAnErrorForEachChoice() => Assert.All(
        Enum.GetValues<EphemerisChoice>(),
        choice => Assert.Throws<BadInputException>(
            () => EphemerisFactory.Open(new EphemerisRequest(choice, ["none.tm"], _folder.Path, CSpicePath: null))));

    /// <summary>The C library's mathematics, which every glibc process has loaded from a file.</summary>
    private static string SystemMathLibrary() => File.ReadLines("/proc/self/maps")
        .Select(line => line[(line.LastIndexOf(' ') + 1)..])
        .First(path => Path.GetFileName(path).StartsWith("libm.so", StringComparison.Ordinal));
}
