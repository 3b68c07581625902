using Msisf.Adapters.Ephemeris;
using Msisf.Core.Errors;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Ephemeris;

public sealed class KernelListTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Expand_ShippedMetaKernel_ListsTheShippedKernels() => Assert.Equal(
        ["naif0012.tls", "moon_080317.tf", "moon_assoc_me.tf", "moon_pa_de421_1900-2050.bpc", "de421.bsp"],
        KernelList.Expand([Path.Combine(TestParts.Kernels, "msisf.tm")]).Select(path => Path.GetRelativePath(TestParts.Kernels, path)));

    [Fact]
    public void Expand_RelativeNames_StartAtTheMetaKernel()
    {
        string kernel = _folder.Write("sub folder/a.tls", "x");
        string meta = _folder.Write("list.tm", "KPL/MK\n\\begindata\nKERNELS_TO_LOAD = 'sub folder/a.tls'\n");

        Assert.Equal([kernel], KernelList.Expand([meta]));
    }

    [Fact]
    public void Expand_NulInAName_IsRefused()
    {
        string meta = _folder.Write("list.tm", "KPL/MK\n\\begindata\nKERNELS_TO_LOAD = 'a\0b.tls'\n");

        BadInputException error = Assert.Throws<BadInputException>(() => KernelList.Expand([meta]));
        Assert.Contains("list.tm: 'a?b.tls' in KERNELS_TO_LOAD holds a NUL character", error.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Expand_SymbolsAndContinuedValues_AreReplaced()
    {
        string kernel = _folder.Write("data/long name/a.tls", "x");
        string meta = _folder.Write("list", "KPL/MK\n\\begindata\nPATH_SYMBOLS = ( 'D' 'DATA' )\nPATH_VALUES = ( 'nowhere' 'da+' 'ta' )\n"
            + "KERNELS_TO_LOAD = ( '$DATA/long +' 'name/a.tls' )\n");

        Assert.Equal([kernel], KernelList.Expand([meta]));
    }

    [Fact]
    public void Expand_KernelsAndMetaKernels_KeepTheirOrder()
    {
        string a = _folder.Write("a.tls", "x");
        string b = _folder.Write("b.tf", "x");
        string meta = _folder.Write("list.tm", "\\begindata\nKERNELS_TO_LOAD = 'a.tls'\n");

        Assert.Equal([b, a, b], KernelList.Expand([b, meta, b]));
    }

    [Theory]
    [InlineData("KERNELS_TO_LOAD = 'none.tls'", "none.tls: no such kernel, which")]
    [InlineData("PATH_VALUES = 'x'", "KERNELS_TO_LOAD is missing")]
    [InlineData("KERNELS_TO_LOAD = 'a.tls'\nPATH_VALUES = 'x'", "0 PATH_SYMBOLS and 1 PATH_VALUES")]
    [InlineData("KERNELS_TO_LOAD = 'a.tls+'", "ends in '+', but nothing follows")]
    [InlineData("KERNELS_TO_LOAD = 'a.tls'\nFRAME_X = 3", "line 4: a meta-kernel may assign")]
    [InlineData("KERNELS_TO_LOAD = 'list.tm'", "is a meta-kernel itself")]
    public void Expand_WrongMetaKernel_SaysWhat(string data, string expected)
    {
        _folder.Write("a.tls", "x");
        string meta = _folder.Write("list.tm", "KPL/MK\n\\begindata\n" + data);

        BadInputException failure = Assert.Throws<BadInputException>(() => KernelList.Expand([meta]));

        Assert.Contains(expected, failure.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Expand_MissingFile_NamesIt() => Assert.Contains(
        "none.tm: no such kernel.",
        Assert.Throws<BadInputException>(() => KernelList.Expand([Path.Combine(_folder.Path, "none.tm")])).Message,
        StringComparison.Ordinal);

    [Fact]
    public void OnTop_KernelAlone_ComesAfterTheInstalledOnes()
    {
        string meta = Path.Combine(TestParts.Kernels, "msisf.tm");
        string frames = Path.Combine(TestParts.Kernels, "moon_080317.tf");
        Assert.Equal([meta], KernelList.OnTop(meta, [], []));
        string trajectory = Path.Combine(TestParts.Kernels, "de421.bsp");
        Assert.Equal([meta, frames, trajectory], KernelList.OnTop(meta, [frames], [trajectory]));
    }

    [Fact]
    public void OnTop_MetaKernel_ReplacesTheInstalledOneAndComesFirst()
    {
        string meta = Path.Combine(TestParts.Kernels, "msisf.tm");
        string frames = Path.Combine(TestParts.Kernels, "moon_080317.tf");
        Assert.Equal([meta, frames], KernelList.OnTop("installed.tm", [frames, meta], []));
        Assert.Contains(
            "a meta-kernel, where one kernel is meant",
            Assert.Throws<BadInputException>(() => KernelList.OnTop(meta, [], [meta])).Message,
            StringComparison.Ordinal);
    }

    [Fact]
    public void Expand_NothingNamed_SaysSo() =>
        Assert.Contains(
            "No kernel is named", Assert.Throws<BadInputException>(() => KernelList.Expand([])).Message, StringComparison.Ordinal);
}
