using Msisf.Core.Errors;
using Xunit;

namespace Msisf.Core.Tests.Errors;

public sealed class FileErrorsTests
{
    [Fact]
    public void ToBadInput_FileSystemRefuses_SaysWhatAndWhy()
    {
        BadInputException exception = Assert.Throws<BadInputException>(
            () => FileErrors.ToBadInput<int>("a.lbl: can't be read", () => throw new IOException("disk gone.")));

        Assert.Equal("a.lbl: can't be read: disk gone.", exception.Message);
    }

    [Fact]
    public void ToExternalPart_NoRightToWrite_SaysWhatAndWhy()
    {
        ExternalPartException exception = Assert.Throws<ExternalPartException>(
            () => FileErrors.ToExternalPart("a.png: can't be written", void () => throw new UnauthorizedAccessException("denied.")));

        Assert.Equal("a.png: can't be written: denied.", exception.Message);
    }

    [Fact]
    public void ToExternalPart_OtherException_PassesThrough() =>
        Assert.Throws<InvalidOperationException>(() => FileErrors.ToExternalPart<int>("a", () => throw new InvalidOperationException()));
}
