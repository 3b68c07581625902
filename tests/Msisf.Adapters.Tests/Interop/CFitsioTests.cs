using Msisf.Adapters.Interop;
using Msisf.Core.Errors;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Interop;

public class CFitsioTests
{
    [Fact]
    public void RequireLibrary_MissingLibrary_SaysWhatToInstallAndWhatDoesWithout()
    {
        ExternalPartException failure = Assert.Throws<ExternalPartException>(() => CFitsio.RequireLibrary("libcfitsio-is-not-here.so.10"));

        Assert.StartsWith("libcfitsio-is-not-here.so.10 (CFITSIO", failure.Message, StringComparison.Ordinal);
        Assert.Contains("apt-get install libcfitsio10", failure.Message, StringComparison.Ordinal);
        Assert.Contains("--layers-format npy", failure.Message, StringComparison.Ordinal);
        Assert.Equal(3, failure.ExitCode);
    }

    [RequiresFact(Part.CFitsio)]
    public void Put_KeyThatFitsForbids_ThrowsAllThatCFitsioSays()
    {
        using FitsUnit unit = FitsUnit.Primary();

        ExternalPartException failure = Assert.Throws<ExternalPartException>(() => unit.Put("NO?KEY", 1, "comment"));

        Assert.Contains("NO?KEY", failure.Message, StringComparison.Ordinal);
        Assert.Contains("(status 207); ", failure.Message, StringComparison.Ordinal); // BAD_KEYCHAR, and CFITSIO's message on it
    }
}
