using Msisf.Adapters.Interop;
using Msisf.Core.Errors;
using Xunit;

namespace Msisf.Adapters.Tests.Interop;

public class CairoImageTests
{
    [Fact]
    public void RequireLibrary_MissingLibrary_SaysWhatToInstall()
    {
        ExternalPartException failure = Assert.Throws<ExternalPartException>(() => CairoImage.RequireLibrary("libcairo-is-not-here.so.2"));

        Assert.StartsWith("libcairo-is-not-here.so.2 (cairo", failure.Message, StringComparison.Ordinal);
        Assert.Contains("apt-get install libcairo2", failure.Message, StringComparison.Ordinal);
        Assert.Equal(3, failure.ExitCode);
    }
}
