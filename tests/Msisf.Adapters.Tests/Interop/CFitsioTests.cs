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
    public void Image_SevenBitsAPixel_ThrowsAllThatCFitsioSays()
    {
        ExternalPartException failure = Assert.Throws<ExternalPartException>(() => FitsUnit.Image(path: null, 7, 4, 2));

        Assert.StartsWith("CFITSIO, ffcrimll: ", failure.Message, StringComparison.Ordinal);
        Assert.Contains("(status 211); ", failure.Message, StringComparison.Ordinal); // BAD_BITPIX, and CFITSIO's message on it
    }
}
