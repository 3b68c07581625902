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

    /// <summary>SPICE starts at the working directory, and so do tutorials and archives; the folder of the meta-kernel wins.</summary>
    [Fact]
    public void Expand_RelativeNameThatIsNotBesideTheMetaKernel_StartsAtTheWorkingDirectory()
    {
        string name = $"{Guid.NewGuid():N}.tls";
        string inWorkingFolder = Path.GetFullPath(name);
        string meta = _folder.Write("list.tm", $"KPL/MK\n\\begindata\nKERNELS_TO_LOAD = './{name}'\n");
        File.WriteAllText(inWorkingFolder, "x");
        try
        {
            Assert.Equal([inWorkingFolder], KernelList.Expand([meta]));
            string beside = _folder.Write(name, "x");
            Assert.Equal([beside], KernelList.Expand([meta]));
        }
        finally
        {
            File.Delete(inWorkingFolder);
        }

        File.Delete(_folder[name]);
        string message = Assert.Throws<BadInputException>(() => KernelList.Expand([meta])).Message;
        Assert.Contains($"{_folder[name]}: no such kernel, which {meta} lists, nor {inWorkingFolder}.", message, StringComparison.Ordinal);
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

    /// <summary>Paths as people write them; the kernel is always data/a.tls beside the meta-kernel.</summary>
    [Theory]
    [InlineData("KERNELS_TO_LOAD = ( 'da+'\n'ta/a.+'\n'tls' )")]
    [InlineData("KERNELS_TO_LOAD = ( 'da+', 'ta/a.tls' )")]
    [InlineData("KERNELS_TO_LOAD = ( 'data/+  ', 'a.tls  ' )")]
    [InlineData("KERNELS_TO_LOAD = '  data/a.tls'")]
    [InlineData("KERNELS_TO_LOAD = 'data\\a.tls'")]
    [InlineData("KERNELS_TO_LOAD = '.\\data\\a.tls'")]
    [InlineData("KERNELS_TO_LOAD = './data/../data//a.tls'")]
    [InlineData("KERNELS_TO_LOAD += 'data/a.tls'")]
    [InlineData("PATH_SYMBOLS = 'A'\nPATH_VALUES = 'data'\nKERNELS_TO_LOAD = '$A/a.tls'")]
    [InlineData("PATH_SYMBOLS = 'A'\nPATH_VALUES = 'data'\nKERNELS_TO_LOAD = '$A\\a.tls'")]
    [InlineData("PATH_SYMBOLS = 'A'\nPATH_VALUES = '.\\data'\nKERNELS_TO_LOAD = '$A\\a.tls'")]
    [InlineData("PATH_SYMBOLS = ( 'K' 'KERNELS' )\nPATH_VALUES = ( 'none' 'data' )\nKERNELS_TO_LOAD = '$KERNELS/a.tls'")]
    [InlineData("PATH_SYMBOLS = 'A '\nPATH_VALUES = ' data/ '\nKERNELS_TO_LOAD = '$A/a.tls'")]
    [InlineData("PATH_SYMBOLS = ( 'D' 'N' )\nPATH_VALUES = ( 'data' 'a' )\nKERNELS_TO_LOAD = '$D/$N.tls'")]
    [InlineData("PATH_VALUES = 'data'\nKERNELS_TO_LOAD = ( '$A/+', 'a.tls' )\nPATH_SYMBOLS = 'A'")]
    [InlineData("KERNELS_TO_LOAD = (\n'data/a.tls',\n)")]
    public void Expand_OddPath_FindsTheKernel(string data)
    {
        string kernel = _folder.Write("data/a.tls", "x");
        string meta = _folder.Write("list.tm", $"KPL/MK\n\\begindata\n{data}\n\\begintext\n");

        Assert.Equal([kernel], KernelList.Expand([meta]));
    }

    /// <summary>Names that hold what other names use as marks: a doubled quote, blanks within, a dollar sign that is no symbol's.</summary>
    [Theory]
    [InlineData("o'brien.tls", "'o''brien.tls'")]
    [InlineData("my  kernel.tls", "'my  kernel.tls'")]
    [InlineData("a$b.tls", "'a$b.tls'")]
    [InlineData("c++.tls", "'c++.tls'")]
    public void Expand_OddName_FindsTheKernel(string name, string written)
    {
        string kernel = _folder.Write(name, "x");
        string meta = _folder.Write("list.tm", $"KPL/MK\n\\begindata\nKERNELS_TO_LOAD = {written}\n");

        Assert.Equal([kernel], KernelList.Expand([meta]));
    }

    /// <summary>Where the file system has a file with the backslash in its name, that is the one.</summary>
    [Fact]
    public void Expand_BackslashInTheName_IsItself()
    {
        _folder.Write("data/a.tls", "x");
        string kernel = _folder.Write("data\\a.tls", "x");

        Assert.Equal([kernel], KernelList.Expand([_folder.Write("list.tm", "KPL/MK\n\\begindata\nKERNELS_TO_LOAD = 'data\\a.tls'\n")]));
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
    [InlineData("KERNELS_TO_LOAD = '$A/a.tls'", "$A/a.tls: no such kernel, which")]
    [InlineData("KERNELS_TO_LOAD = 'C:\\kernels\\a.tls'", "a.tls: no such kernel, which")]
    [InlineData("KERNELS_TO_LOAD = ''", "KERNELS_TO_LOAD has an empty name")]
    [InlineData("KERNELS_TO_LOAD = '.'", "no such kernel")]
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
        Assert.Equal([meta], KernelList.OnTop(meta, [], SpacecraftKernels.None));
        string trajectory = Path.Combine(TestParts.Kernels, "de421.bsp");
        Assert.Equal([meta, frames, trajectory], KernelList.OnTop(meta, [frames], new SpacecraftKernels([trajectory], [])));
    }

    [Fact]
    public void OnTop_MetaKernel_ReplacesTheInstalledOneAndComesFirst()
    {
        string meta = Path.Combine(TestParts.Kernels, "msisf.tm");
        string frames = Path.Combine(TestParts.Kernels, "moon_080317.tf");
        Assert.Equal([meta, frames], KernelList.OnTop("installed.tm", [frames, meta], SpacecraftKernels.None));
    }

    /// <summary>Each kind of file in the place of another: it is called what it is, with the option that takes it.</summary>
    [Theory]
    [InlineData("DAF/CK  ", "--spk", "this is a CK (attitudes). Give it with --ck in place of --spk.")]
    [InlineData("DAF/PCK ", "--spk", "this is a binary PCK (orientations of bodies). Give it with --kernels in place of --spk.")]
    [InlineData("DAF/SPK ", "--ck", "this is an SPK (trajectories). Give it with --spk in place of --ck.")]
    [InlineData("DAF/PCK ", "--ck", "this is a binary PCK (orientations of bodies). Give it with --kernels in place of --ck.")]
    [InlineData("DAS/DSK ", "--spk", "this is a DSK (shapes), which is not used for images. Leave it out.")]
    [InlineData("DAS/EK  ", "--ck", "this is an EK (events), which is not used for images. Leave it out.")]
    [InlineData("KPL/FK\n", "--spk", "this is a frame kernel (FK). Give it with --kernels in place of --spk.")]
    [InlineData("KPL/IK\n", "--ck", "this is an instrument kernel (IK). Give it with --kernels in place of --ck.")]
    [InlineData("KPL/SCLK\n", "--ck", "this is a clock kernel (SCLK). Give it with --kernels in place of --ck.")]
    [InlineData("KPL/LSK\n", "--spk", "this is a leap seconds kernel (LSK). Give it with --kernels in place of --spk.")]
    [InlineData("KPL/PCK\n", "--ck", "this is a text PCK. Give it with --kernels in place of --ck.")]
    [InlineData("KPL/MK\n", "--spk", "this is a meta-kernel. Give it with --kernels in place of --spk.")]
    [InlineData("CCSDS_OEM_VERS = 2.0\n", "--spk", "this is a CCSDS orbit message (OEM). Give it with --oem in place of --spk.")]
    [InlineData("CCSDS_AEM_VERS = 2.0\n", "--ck", "this is a CCSDS attitude message (AEM). Give it with --aem in place of --ck.")]
    [InlineData("\\begindata\nA = 1\n", "--ck", "no binary kernel, which --ck takes. Text kernels are given with --kernels.")]
    [InlineData("DAF/S", "--spk", "damaged kernel: it begins with \"DAF/S\", which no kernel does. Is it cut off? Get the file anew.")]
    [InlineData("", "--spk", "the file is empty. Get the kernel anew.")]
    [InlineData("NAIF/DAF", "--spk", "convert it with NAIF's tobin.")]
    [InlineData("DAFETF NAIF DAF ENCODED", "--ck", "convert it with NAIF's tobin.")]
    public void OnTop_KernelOfAnotherKind_SaysWhatItIs(string content, string option, string expected)
    {
        string meta = Path.Combine(TestParts.Kernels, "msisf.tm");
        string file = _folder.Write("kernel", content);
        SpacecraftKernels kernels = option == "--spk" ? new([file], []) : new([], [file]);

        string message = Assert.Throws<BadInputException>(() => KernelList.OnTop(meta, [], kernels)).Message;

        Assert.StartsWith($"{file}: ", message, StringComparison.Ordinal);
        Assert.EndsWith(expected, message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("CCSDS_OEM_VERS = 2.0\n", "Give it with --oem in place of --kernels.")]
    [InlineData("CCSDS_AEM_VERS = 2.0\n", "Give it with --aem in place of --kernels.")]
    public void Pool_NoKernel_SaysWhatItIs(string content, string expected) => Assert.EndsWith(
        expected,
        Assert.Throws<BadInputException>(() => KernelPool.Of([_folder.Write("kernel", content)])).Message,
        StringComparison.Ordinal);

    [Theory]
    [InlineData("DAF/SPK ", "--oem", "CCSDS_OE", "this is an SPK (trajectories). Give it with --spk in place of --oem.")]
    [InlineData("DAF/CK  ", "--aem", "CCSDS_AE", "this is a CK (attitudes). Give it with --ck in place of --aem.")]
    [InlineData("CCSDS_AEM_VERS =", "--oem", "CCSDS_OE", "this is a CCSDS attitude message (AEM). Give it with --aem in place of --oem.")]
    [InlineData("CCSDS_OEM_VERS =", "--aem", "CCSDS_AE", "this is a CCSDS orbit message (OEM). Give it with --oem in place of --aem.")]
    public void Require_MessageOfAnotherKind_SaysWhatItIs(string content, string option, string takes, string expected)
    {
        string compressed = _folder["message.gz"];
        using (System.IO.Compression.GZipStream stream = new(File.Create(compressed), System.IO.Compression.CompressionLevel.Fastest))
        {
            stream.Write(System.Text.Encoding.ASCII.GetBytes(content));
        }

        foreach (string file in (string[])[_folder.Write("message", content), compressed])
        {
            string message = Assert.Throws<BadInputException>(() => KernelFile.Require(file, option, takes)).Message;
            Assert.Equal($"{file}: {expected}", message);
        }
    }

    [Fact]
    public void Expand_NothingNamed_SaysSo() =>
        Assert.Contains(
            "No kernel is named", Assert.Throws<BadInputException>(() => KernelList.Expand([])).Message, StringComparison.Ordinal);
}
